/* Any bytes as a program, interpreted and turned into motion; FUZZ_DIALECT in the environment names the dialect. */
#include "check/check.h"
#include "control/dialects.h"
#include "fuzz.h"

enum { BLOCKS = 300 };

static bool keep_going(void *context, const struct finding *finding)
{
	(void)context;
	if (!(finding->fraction >= 0 && finding->fraction <= 1 && finding->line >= 0))
		abort();
	return true;
}

static int dialect_of_environment(void)
{
	const char *name = getenv("FUZZ_DIALECT");
	int row = name ? dialect_row_find(name) : 0;

	if (row < 0)
		abort();
	return row;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	static struct machine *machine;
	static struct setup *setup;
	struct diag diag = {.handle = fuzz_note};
	const struct check_options options = {.method = CHECK_NOTHING, .tolerance = 1e-3, .all = true, .threads = 1,
					      .read.max_blocks = BLOCKS};
	const struct check_sink sink = {.finding = keep_going};
	struct check_stats stats;
	struct scene bare;
	FILE *in;

	if (!machine) {
		machine = machine_load(FUZZ_MACHINE, &diag);
		setup = machine ? setup_load(FUZZ_SETUP, machine, &diag) : NULL;
		if (!setup)
			abort();
		machine->controller.dialect = dialect_of_environment();
	}
	bare = (struct scene){.machine = machine, .setup = setup};
	in = size ? fmemopen((void *)(uintptr_t)data, size, "r") : fopen("/dev/null", "r");
	if (!in)
		abort();
	if ((check_run(&bare, &options, in, "/nonexistent/fuzz.nc", &sink, &diag, &stats, NULL) == CHECK_INCOMPLETE) !=
	    (diag.errors > 0))
		abort();
	fclose(in);
	return 0;
}
