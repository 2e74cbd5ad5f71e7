/* Any bytes as a tool library, a table of tools or a listing of offsets; its content tells which it is. */
#include "fuzz.h"
#include "machine/library/library_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	const struct library_options options = {.unit = 1, .number_all = true, .shapes = size % 2};
	struct diag diag = {.handle = fuzz_note};
	const char *path = fuzz_file(data, size);
	struct tool_library tools = {0};

	if (library_file_read(&tools, path, &options, &diag) != (diag.errors == 0))
		abort();
	tool_library_release(&tools);
	unlink(path);
	return 0;
}
