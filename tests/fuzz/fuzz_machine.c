/* Any bytes as a machine file. */
#include "fuzz.h"
#include "machine/machine.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct diag diag = {.handle = fuzz_note};
	const char *path = fuzz_file(data, size);
	struct machine *machine = machine_load(path, &diag);

	if (!machine != (diag.errors > 0))
		abort();
	if (machine)
		machine_check_rules(machine, NULL, &diag);
	machine_free(machine);
	unlink(path);
	return 0;
}
