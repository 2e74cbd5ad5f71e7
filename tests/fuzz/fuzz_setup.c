/* Any bytes as a setup file, on a machine of the project's own. */
#include "fuzz.h"
#include "machine/machine.h"
#include "machine/setup.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	static struct machine *machine;
	struct diag diag = {.handle = fuzz_note};
	const char *path = fuzz_file(data, size);
	struct setup *setup;

	if (!machine)
		machine = machine_load(FUZZ_MACHINE, &diag);
	if (!machine)
		abort();
	setup = setup_load(path, machine, &diag);
	if (!setup != (diag.errors > 0))
		abort();
	if (setup)
		machine_check_rules(machine, setup, &diag);
	setup_free(setup);
	unlink(path);
	return 0;
}
