/* test_fivecheck.c - the public face: a probe that is lowered into a table, as another program would check it. */
#include <math.h>
#include <pthread.h>
#include <sys/stat.h>

#include "fivecheck.h"
#include "xml_case.h"

static const char machine_text[] =
	"<machine version='1' name='t' units='mm'><base>\n"
	"<axis name='Z' type='linear' direction='0 0 1' limit_min='-150' limit_max='50' rate_max='6000'>\n"
	"<body name='probe' mesh='probe.stl'/><spindle location='0 0 100' direction='0 0 -1'/></axis>\n"
	"<axis name='C' type='rotary' direction='0 0 1' location='0 0 0' rate_max='3600'>\n"
	"<body name='table' mesh='table.stl'/><workholding location='0 0 0'/></axis></base></machine>";

/* A closed tetrahedron with a corner at `tip` and a face at the height `face`. */
static void write_solid(const char *path, double tip, double face)
{
	const double p[4][3] = {{0, 0, tip}, {-30, -30, face}, {30, -30, face}, {0, 40, face}};
	const int up[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
	FILE *out = fopen(path, "w");

	ck_assert_ptr_nonnull(out);
	fprintf(out, "solid s\n");
	for (int i = 0; i < 4; i++) {
		fprintf(out, "facet normal 0 0 0\nouter loop\n");
		for (int k = 0; k < 3; k++) {
			const double *v = p[up[i][tip > face ? k : 2 - k]];

			fprintf(out, "vertex %g %g %g\n", v[0], v[1], v[2]);
		}
		fprintf(out, "endloop\nendfacet\n");
	}
	fprintf(out, "endsolid s\n");
	ck_assert_int_eq(fclose(out), 0);
}

static fivecheck_diag *diag;
static fivecheck_model *model;
static fivecheck_options *options;
static struct strbuf messages;

static void take_message(void *context, const fivecheck_message *message)
{
	static const char *const names[] = {"note", "warning", "error"};
	const char *file = fivecheck_message_file(message);

	strbuf_addf(context, "%s %s:%ld:%d %s\n", names[fivecheck_message_severity(message)], file ? file : "-",
		    fivecheck_message_line(message), fivecheck_message_column(message), fivecheck_message_text(message));
}

static void start(void)
{
	enter_folder();
	write_text("m.xml", machine_text);
	/* The probe's tip stands at z = 100 when Z = 0, the table's face at z = 0. */
	write_solid("probe.stl", 100, 150);
	write_solid("table.stl", -40, 0);
	diag = fivecheck_diag_new(take_message, &messages);
	options = fivecheck_options_new();
	model = fivecheck_load("m.xml", NULL, diag);
	ck_assert_ptr_nonnull(model);
}

static void finish(void)
{
	static const char *const written[] = {"probe.stl", "table.stl", "a.nc", "b.nc", "long.nc", "lib/O0002", "lib"};

	fivecheck_free(model);
	fivecheck_options_free(options);
	fivecheck_diag_free(diag);
	strbuf_release(&messages);
	for (size_t i = 0; i < COUNT(written); i++)
		remove(written[i]);
	leave_folder();
}

static void assert_messages(const char *expected)
{
	ck_assert_str_eq(strbuf_text(&messages), expected);
}

struct seen {
	pthread_t thread;
	int findings;
	long progress;
	long times;	/* calls of the progress callback */
	bool go_on;	/* result of the progress callback */
	enum fivecheck_kind kind;
	long line;
};

static bool on_collision(void *context, const fivecheck_finding *finding)
{
	struct seen *seen = context;
	double point[3] = {9, 9, 9};
	const char *file;
	long line;

	ck_assert(pthread_equal(pthread_self(), seen->thread));
	seen->findings++;
	seen->kind = fivecheck_finding_kind(finding);
	seen->line = fivecheck_finding_line(finding);
	ck_assert_str_eq(fivecheck_finding_file(finding), "a.nc");
	ck_assert_str_eq(fivecheck_finding_block(finding), "G1 Z-120 F6000");
	ck_assert(!fivecheck_finding_caller(finding, 0, &file, &line));
	/* 100 of 120 mm at 100 mm/s, after 10 mm of the rapid move before. */
	ck_assert_double_eq_tol(fivecheck_finding_fraction(finding), 90.0 / 110, 1e-4);
	ck_assert_double_eq_tol(fivecheck_finding_time(finding), 1, 1e-3);
	ck_assert_double_eq_tol(fivecheck_finding_axis(finding, 'Z'), -100, 2e-3);
	ck_assert(fivecheck_finding_axis(finding, 'Q') == 0);
	ck_assert_int_eq(fivecheck_finding_tool(finding), 0);
	ck_assert_str_eq(fivecheck_finding_body_a(finding), "probe");
	ck_assert_str_eq(fivecheck_finding_body_b(finding), "table");
	ck_assert(fivecheck_finding_point(finding, point));
	ck_assert_double_eq_tol(fabs(point[0]) + fabs(point[1]) + fabs(point[2]), 0, 1e-2);
	ck_assert_double_eq_tol(fivecheck_finding_distance(finding), 0, 2e-3);
	ck_assert(fivecheck_finding_required(finding) == 0);
	ck_assert_int_eq(fivecheck_finding_limit_axis(finding), 0);
	ck_assert(fivecheck_finding_limit(finding) == 0);
	return true;
}

static bool on_limit(void *context, const fivecheck_finding *finding)
{
	struct seen *seen = context;
	double point[3] = {9, 9, 9};
	const char *file;
	long line;

	seen->findings++;
	seen->kind = fivecheck_finding_kind(finding);
	ck_assert(!fivecheck_finding_point(finding, point));
	ck_assert(point[0] == 9);
	ck_assert_ptr_null(fivecheck_finding_body_a(finding));
	ck_assert_ptr_null(fivecheck_finding_body_b(finding));
	ck_assert_int_eq(fivecheck_finding_limit_axis(finding), 'Z');
	ck_assert(fivecheck_finding_limit(finding) == 50);
	ck_assert_int_eq(fivecheck_finding_line(finding), 2);
	ck_assert(fivecheck_finding_caller(finding, 0, &file, &line));
	ck_assert_str_eq(file, "a.nc");
	ck_assert_int_eq(line, 5);
	ck_assert(!fivecheck_finding_caller(finding, 1, &file, &line));
	return true;
}

static bool on_progress(void *context, long lines)
{
	struct seen *seen = context;

	seen->progress = lines;
	seen->times++;
	return seen->go_on;
}

START_TEST(finds_and_proves)
{
	struct seen seen = {.thread = pthread_self()};
	const struct fivecheck_events events = {.context = &seen, .finding = on_collision};
	fivecheck_statistics *statistics = fivecheck_statistics_new();
	const char *a, *b, *reason;
	double proven[1];

	ck_assert_int_eq((int)fivecheck_pair_count(model), 0);
	ck_assert(fivecheck_prepare(model, 0, diag));
	ck_assert_int_eq((int)fivecheck_pair_count(model), 1);
	ck_assert(fivecheck_pair(model, 0, &a, &b, &reason));
	ck_assert_str_eq(a, "probe");
	ck_assert_str_eq(b, "table");
	ck_assert(fivecheck_options_set_threads(options, 4));
	write_text("a.nc", "G0 Z-10\nG1 Z-120 F6000\nG1 Z0\n");
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", &events, diag, statistics, NULL), FIVECHECK_FOUND);
	ck_assert_int_eq(seen.findings, 1);
	ck_assert_int_eq((int)seen.kind, FIVECHECK_COLLISION);
	ck_assert_int_eq((int)seen.line, 2);
	ck_assert_int_eq((int)fivecheck_statistics_findings(statistics), 1);
	/* The contact is also found without a callback. */
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", NULL, diag, NULL, NULL), FIVECHECK_FOUND);
	write_text("b.nc", "G1 Z-99 F6000\nG1 Z0\n");
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "b.nc", &events, diag, statistics, proven), FIVECHECK_CLEAR);
	ck_assert_int_eq((int)fivecheck_statistics_blocks(statistics), 2);
	ck_assert_double_eq_tol(fivecheck_statistics_motion_time(statistics), 1.98, 1e-6);
	ck_assert(proven[0] > 0 && proven[0] <= 1);
	assert_messages("");
	fivecheck_statistics_free(statistics);
}
END_TEST

START_TEST(keeps_clearances)
{
	struct seen seen = {.thread = pthread_self()};

	ck_assert(fivecheck_prepare(model, 2, diag));
	write_text("a.nc", "G1 Z-99 F6000\n");
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", NULL, diag, NULL, NULL), FIVECHECK_FOUND);
	ck_assert(!fivecheck_prepare(model, 2, diag));
	assert_messages("error -:0:0 a model can be prepared only once\n");
	ck_assert_int_eq((int)fivecheck_diag_errors(diag), 1);
	(void)seen;
}
END_TEST

START_TEST(parses_without_bodies)
{
	struct seen seen = {.thread = pthread_self()};
	const struct fivecheck_events events = {.context = &seen, .finding = on_limit};

	write_text("a.nc", "o<up> sub\n/G1 Z60\no<up> endsub\nG1 Z-120 F6000\no<up> call\n");
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", NULL, diag, NULL, NULL), FIVECHECK_INCOMPLETE);
	assert_messages("error -:0:0 the model was not prepared, so its bodies are not known\n");
	fivecheck_options_set_parse_only(options, true);
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", &events, diag, NULL, NULL), FIVECHECK_FOUND);
	ck_assert_int_eq(seen.findings, 1);
	ck_assert_int_eq((int)seen.kind, FIVECHECK_LIMIT);
	fivecheck_options_set_block_delete(options, true);
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", &events, diag, NULL, NULL), FIVECHECK_CLEAR);
}
END_TEST

START_TEST(goes_on_or_gives_up)
{
	struct seen seen = {.thread = pthread_self(), .go_on = false};
	const struct fivecheck_events events = {.context = &seen, .progress = on_progress};
	fivecheck_statistics *statistics = fivecheck_statistics_new();
	FILE *in = fopen("long.nc", "w+");

	ck_assert(fivecheck_prepare(model, 0, diag));
	write_text("a.nc", "G1 Z-120 F6000\nG1 Z0\nG1 Z-120\n");
	fivecheck_options_set_all(options, true);
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", NULL, diag, statistics, NULL), FIVECHECK_FOUND);
	ck_assert_int_eq((int)fivecheck_statistics_findings(statistics), 3);
	for (int i = 0; i < 100000; i++)
		fprintf(in, "G1 Z%d F6000\n", -(i % 90));
	rewind(in);
	ck_assert_int_eq((int)fivecheck_check(model, options, in, "long.nc", &events, diag, NULL, NULL), FIVECHECK_INCOMPLETE);
	ck_assert_int_gt((int)seen.progress, 0);
	ck_assert_int_lt((int)seen.progress, 100000);
	fclose(in);
	fivecheck_statistics_free(statistics);
}
END_TEST

/*
 * A writer that sends nothing, or a loop that moves nothing, reports no block; the check can be cancelled all the same.
 */
START_TEST(can_give_up_at_any_time)
{
	struct seen seen = {.thread = pthread_self(), .go_on = false};
	const struct fivecheck_events events = {.context = &seen, .progress = on_progress};
	FILE *in = fopen("long.nc", "w+");
	int ends[2];

	ck_assert(fivecheck_prepare(model, 0, diag));
	fprintf(in, "o1 while [1]\no1 endwhile\n");
	for (int threads = 1; threads <= 2; threads++) {
		FILE *silent;

		ck_assert(fivecheck_options_set_threads(options, threads));
		ck_assert_int_eq(pipe(ends), 0);
		silent = fdopen(ends[0], "rb");
		ck_assert_int_eq((int)fivecheck_check(model, options, silent, "pipe", &events, diag, NULL, NULL),
				 FIVECHECK_INCOMPLETE);
		fclose(silent);
		close(ends[1]);
		rewind(in);
		ck_assert_int_eq((int)fivecheck_check(model, options, in, "long.nc", &events, diag, NULL, NULL),
				 FIVECHECK_INCOMPLETE);
	}
	fclose(in);
	assert_messages("error pipe:0:0 interrupted after line 0: the rest was not checked\n"
			"error long.nc:0:0 interrupted after line 0: the rest was not checked\n"
			"error pipe:0:0 interrupted after line 0: the rest was not checked\n"
			"error long.nc:0:0 interrupted after line 0: the rest was not checked\n");
}
END_TEST

/* After a limit finding, blocks are still checked many at a time. The way back from the place is a finding, too. */
START_TEST(goes_on_past_a_limit)
{
	struct seen seen = {.thread = pthread_self(), .go_on = true};
	const struct fivecheck_events events = {.context = &seen, .progress = on_progress};
	fivecheck_statistics *statistics = fivecheck_statistics_new();
	FILE *in = fopen("long.nc", "w+");

	ck_assert(fivecheck_prepare(model, 0, diag));
	fivecheck_options_set_all(options, true);
	fprintf(in, "G1 Z60 F6000\n");
	for (int i = 0; i < 10000; i++)
		fprintf(in, "G1 Z%d\n", i == 9990 ? -120 : -(i % 90));
	for (int threads = 1; threads <= 2; threads++) {
		rewind(in);
		seen.times = 0;
		ck_assert(fivecheck_options_set_threads(options, threads));
		ck_assert_int_eq((int)fivecheck_check(model, options, in, "long.nc", &events, diag, statistics, NULL),
				 FIVECHECK_FOUND);
		ck_assert_int_eq((int)fivecheck_statistics_findings(statistics), 4);
		ck_assert_int_lt((int)seen.times, 100);
	}
	fclose(in);
	fivecheck_statistics_free(statistics);
}
END_TEST

START_TEST(reports_faults)
{
	fivecheck_model *none = fivecheck_load("nowhere.xml", NULL, diag);

	ck_assert_ptr_null(none);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&messages), "nowhere.xml"));
	fivecheck_free(none);
	ck_assert_ptr_null(fivecheck_load("m.xml", "nowhere.xml", diag));
	strbuf_clear(&messages);
	ck_assert(!fivecheck_set_dialect(model, "klingon", diag));
	ck_assert(!fivecheck_prepare(model, -1, diag));
	ck_assert(!fivecheck_prepare(model, NAN, diag));
	assert_messages("error -:0:0 'klingon' is not the name of a dialect\n"
			"error -:0:0 the clearance must not be negative\nerror -:0:0 the clearance must not be "
			"negative\n");
	strbuf_clear(&messages);
	fivecheck_options_set_parse_only(options, true);
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "none.nc", NULL, diag, NULL, NULL), FIVECHECK_INCOMPLETE);
	ck_assert_int_eq((int)fivecheck_check_file(model, options, ".", NULL, diag, NULL, NULL), FIVECHECK_INCOMPLETE);
	assert_messages("error none.nc:0:0 cannot open: No such file or directory\n"
			"error .:0:0 is a directory, not a file\n");
	strbuf_clear(&messages);
	write_text("a.nc", "G1 Z-1 F6000\nG1 Q1\n");
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", NULL, diag, NULL, NULL), FIVECHECK_INCOMPLETE);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&messages), "error a.nc:2:"));
	ck_assert(!fivecheck_options_set_tolerance(options, 0));
	ck_assert(!fivecheck_options_set_tolerance(options, NAN));
	ck_assert(fivecheck_options_set_tolerance(options, 0.01));
	ck_assert(!fivecheck_options_set_threads(options, 0));
	ck_assert_str_eq(fivecheck_version(), FIVECHECK_VERSION);
}
END_TEST

START_TEST(reads_other_dialects_and_folders)
{
	static const char *const folders[] = {"lib"};

	fivecheck_options_set_parse_only(options, true);
	write_text("a.nc", "%\nO1\nM98 P2\nM30\n%\n");
	ck_assert(fivecheck_set_dialect(model, "fanuc", diag));
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", NULL, diag, NULL, NULL), FIVECHECK_INCOMPLETE);
	ck_assert_int_eq(mkdir("lib", 0777), 0);
	write_text("lib/O0002", "%\nO2\nG21 G90 G1 Z-5. F100.\nM99\n%\n");
	fivecheck_options_set_includes(options, folders, 1);
	strbuf_clear(&messages);
	ck_assert_int_eq((int)fivecheck_check_file(model, options, "a.nc", NULL, diag, NULL, NULL), FIVECHECK_CLEAR);
	assert_messages("");
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("face");

	tcase_add_checked_fixture(tcase, start, finish);
	tcase_add_test(tcase, finds_and_proves);
	tcase_add_test(tcase, keeps_clearances);
	tcase_add_test(tcase, parses_without_bodies);
	tcase_add_test(tcase, goes_on_or_gives_up);
	tcase_add_test(tcase, can_give_up_at_any_time);
	tcase_add_test(tcase, goes_on_past_a_limit);
	tcase_add_test(tcase, reports_faults);
	tcase_add_test(tcase, reads_other_dialects_and_folders);
	return run_suite("fivecheck", tcase);
}
