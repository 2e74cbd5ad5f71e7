/*
 * test_places.c - messages about a block name the block's own file: the lines of a subprogram are not those of the
 * program.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/strbuf.h"
#include "check/check.h"
#include "machine/machine.h"
#include "scene/scene.h"
#include "suite.h"

/* A ball in a bowl: they stay apart at all positions of the three rotary axes, but this is hard to prove. */
static const char machine_format[] =
	"<machine version=\"1\" name=\"m\" units=\"mm\"><controller rapid=\"%s\"/><base>"
	"<axis name=\"A\" type=\"rotary\" direction=\"1 0 0\" location=\"0 0 0\" rate_max=\"3600\">"
	"<axis name=\"B\" type=\"rotary\" direction=\"0 1 0\" location=\"0 0 0\" rate_max=\"3600\">"
	"<axis name=\"C\" type=\"rotary\" direction=\"0 0 1\" location=\"0 0 0\" rate_max=\"3600\">"
	"<body name=\"ball\" mesh=\"ball.stl\"/></axis></axis></axis><body name=\"bowl\" mesh=\"bowl.stl\"/></base>"
	"<pairs><pair a=\"ball\" b=\"bowl\" check=\"always\"/></pairs></machine>";

static const char subprogram[] = "o<turn> sub\n\n\n\nG0 A90 B90 C90\no<turn> endsub\n";
static const char program[] = "G21\no<turn> call\nM2\n";

static void write_file(const char *name, const char *text)
{
	FILE *out = fopen(name, "w");

	ck_assert_ptr_nonnull(out);
	ck_assert_int_ge(fputs(text, out), 0);
	ck_assert_int_eq(fclose(out), 0);
}

/* The corner of ring i and meridian k. */
static void write_corner(FILE *out, double radius, int rings, int i, int k)
{
	double t = acos(-1) * i / rings, f = acos(-1) * k / rings;

	fprintf(out, "vertex %.9g %.9g %.9g\n", radius * sin(t) * cos(f), radius * sin(t) * sin(f), radius * cos(t));
}

static void write_facet(FILE *out, double radius, int rings, const int corners[3][2])
{
	fprintf(out, "facet normal 0 0 0\nouter loop\n");
	for (int i = 0; i < 3; i++)
		write_corner(out, radius, rings, corners[i][0], corners[i][1]);
	fprintf(out, "endloop\nendfacet\n");
}

/* A sphere, or a hollow one that lacks a facet: whether something is inside a sphere would be asked first. */
static void write_sphere(const char *name, double radius, int rings, bool whole)
{
	FILE *out = fopen(name, "w");

	ck_assert_ptr_nonnull(out);
	fprintf(out, "solid s\n");
	for (int i = 0; i < rings; i++) {
		for (int k = 0; k < 2 * rings; k++) {
			const int low[3][2] = {{i, k}, {i + 1, k}, {i + 1, k + 1}};
			const int high[3][2] = {{i, k}, {i + 1, k + 1}, {i, k + 1}};

			if (i < rings - 1)
				write_facet(out, radius, rings, low);
			if (i > 0 && (whole || i > 1 || k > 0))
				write_facet(out, radius, rings, high);
		}
	}
	fprintf(out, "endsolid s\n");
	ck_assert_int_eq(fclose(out), 0);
}

/* The first error, with its place. */
struct heard {
	char file[64], text[200];
	long line;
	int calls;	/* of the progress callback */
	int rounds;	/* the check is to be broken off at this call; 0: it is not */
};

static void on_diag(void *context, const struct diag_entry *entry)
{
	struct heard *heard = context;

	if (entry->severity != DIAG_ERROR || heard->text[0])
		return;
	snprintf(heard->file, sizeof(heard->file), "%s", entry->loc.file ? entry->loc.file : "");
	snprintf(heard->text, sizeof(heard->text), "%s", entry->text);
	heard->line = entry->loc.line;
}

static bool on_finding(void *context, const struct finding *finding)
{
	(void)context;
	ck_abort_msg("%s in line %ld of %s", finding_kind_name(finding->kind), finding->line, finding->file);
	return false;
}

static bool on_progress(void *context, long lines)
{
	struct heard *heard = context;

	(void)lines;
	heard->calls++;
	return heard->rounds == 0 || --heard->rounds > 0;
}

/* Checks the program; the check must end incomplete. */
static void check(struct heard *heard, const struct check_options *options)
{
	struct diag diag = {.handle = on_diag, .context = heard};
	const struct check_sink sink = {heard, on_finding, on_progress, NULL};
	struct machine *machine = machine_load("m.xml", &diag);
	struct scene *scene = machine ? scene_new(machine, NULL, 0, 1, &diag) : NULL;
	struct check_stats stats;
	FILE *in = fopen("a.nc", "r");

	ck_assert_msg(scene, "%s", heard->text);
	ck_assert_ptr_nonnull(in);
	ck_assert_int_eq(check_run(scene, options, in, "a.nc", &sink, &diag, &stats, NULL), CHECK_INCOMPLETE);
	fclose(in);
	scene_free(scene);
	machine_free(machine);
}

static void write_case(const char *rapid)
{
	struct strbuf machine = {0};

	strbuf_addf(&machine, machine_format, rapid);
	write_file("m.xml", machine.text);
	write_file("a.nc", program);
	write_file("turn.ngc", subprogram);
	write_sphere("ball.stl", 99, 24, true);
	write_sphere("bowl.stl", 100, 24, false);
	strbuf_release(&machine);
}

static void expect(const struct heard *heard, const char *file, long line, const char *text)
{
	ck_assert_str_eq(heard->file, file);
	ck_assert_int_eq((int)heard->line, (int)line);
	ck_assert_msg(strstr(heard->text, text) != NULL, "%s", heard->text);
}

START_TEST(what_cannot_be_decided)
{
	for (int threads = 1; threads <= 2; threads++) {
		const struct check_options options = {.tolerance = 0.001, .threads = threads, .effort = 20000};
		struct heard unknown = {.rounds = 0}, straight = {.rounds = 0};

		write_case("any");
		check(&unknown, &options);
		expect(&unknown, "turn.ngc", 5, "rapid=\"any\"");
		write_case("linear");
		check(&straight, &options);
		expect(&straight, "turn.ngc", 5, "The check stops here");
	}
}
END_TEST

/* Progress is also reported in the middle of a batch: here the whole program is one batch. */
START_TEST(where_it_was_interrupted)
{
	for (int threads = 1; threads <= 2; threads++) {
		const struct check_options options = {.method = CHECK_NOTHING, .tolerance = 0.001, .threads = threads};
		const struct check_options proves = {.tolerance = 0.001, .threads = threads, .effort = 200000};
		struct heard heard = {.rounds = 1}, patient = {.rounds = 0};

		write_case("linear");
		check(&heard, &options);
		expect(&heard, "turn.ngc", 0, "interrupted after line 5:");
		check(&patient, &proves);
		ck_assert_int_gt(patient.calls, 5);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("files");
	char folder[] = "/tmp/fivecheck-places-XXXXXX";
	static const char *const names[] = {"m.xml", "a.nc", "turn.ngc", "ball.stl", "bowl.stl"};
	int status;

	if (!mkdtemp(folder) || chdir(folder))
		return EXIT_FAILURE;
	tcase_add_test(tcase, what_cannot_be_decided);
	tcase_add_test(tcase, where_it_was_interrupted);
	status = run_suite("places", tcase);
	for (size_t i = 0; i < COUNT(names); i++)
		remove(names[i]);
	if (chdir("/"))
		return status;
	rmdir(folder);
	return status;
}
