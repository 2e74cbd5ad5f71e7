/*
 * check.c - fivecheck inside another program: checks one NC program and prints what it finds, a line each.
 *
 *   cc -o check check.c $(pkg-config --cflags --libs fivecheck)
 *   ./check machine.xml setup.xml part.nc
 */
#include <fivecheck.h>

static void print_message(void *context, const fivecheck_message *message)
{
	(void)context;
	fprintf(stderr, "line %ld: %s\n", fivecheck_message_line(message), fivecheck_message_text(message));
}

static bool print_finding(void *context, const fivecheck_finding *finding)
{
	const char *a = fivecheck_finding_body_a(finding), *b = fivecheck_finding_body_b(finding);

	(void)context;
	printf("line %ld, %.3f s: %s, %s\n", fivecheck_finding_line(finding), fivecheck_finding_time(finding),
	       a ? a : "axis limit", b ? b : "passed");
	return true;
}

int main(int argc, char **argv)
{
	const struct fivecheck_events events = {.finding = print_finding};
	fivecheck_diag *diag = fivecheck_diag_new(print_message, NULL);
	fivecheck_options *options = fivecheck_options_new();
	fivecheck_model *model = argc == 4 ? fivecheck_load(argv[1], argv[2], diag) : NULL;
	enum fivecheck_result result = FIVECHECK_INCOMPLETE;

	if (model && fivecheck_prepare(model, 0, diag))
		result = fivecheck_check_file(model, options, argv[3], &events, diag, NULL, NULL);
	fivecheck_free(model);
	fivecheck_options_free(options);
	fivecheck_diag_free(diag);
	return (int)result;
}
