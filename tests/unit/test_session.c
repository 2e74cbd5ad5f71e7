#include "cli/session.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "machine_case.h"
#include "report/format/digest.h"

/* Two cubes of 10 mm, 20 mm apart at home; X moves the second one onto the first. */
static const char machine_text[] =
	"<machine version=\"1\"><base><body name=\"post\" mesh=\"cube.stl\"/>\n"
	"<axis name=\"X\" type=\"linear\" direction=\"1 0 0\" limit_min=\"-40\" limit_max=\"40\" rate_max=\"1000\">\n"
	"<axis name=\"Y\" type=\"linear\" direction=\"0 1 0\" limit_min=\"-40\" limit_max=\"40\" rate_max=\"1000\">\n"
	"<body name=\"head\" mesh=\"cube.stl\" location=\"30 0 0\"/></axis></axis></base></machine>\n";

static void write_cube(void)
{
	static const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
					 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
	struct strbuf text = {0};

	strbuf_addf(&text, "solid cube\n");
	for (int f = 0; f < 12; f++) {
		strbuf_addf(&text, "facet normal 0 0 0\nouter loop\n");
		for (int c = 0; c < 3; c++)
			strbuf_addf(&text, "vertex %d %d %d\n", 10 * (faces[f][c] & 1), 5 * (faces[f][c] & 2),
				    10 * (faces[f][c] >> 2));
		strbuf_addf(&text, "endloop\nendfacet\n");
	}
	strbuf_addf(&text, "endsolid cube\n");
	write_text("cube.stl", strbuf_text(&text));
	strbuf_release(&text);
}

static void write_job(void)
{
	write_cube();
	write_text("m.xml", machine_text);
	write_text("clear.nc", "G21\nG53 G0 X10\n");
	write_text("hit.nc", "G21\nG53 G0 X10\nG53 G0 X-25\n");
}

/* All files of a job are directly in the folder. */
static void remove_job(void)
{
	static const char *const names[] = {"cube.stl", "m.xml", "clear.nc", "hit.nc", "p.nc", "out"};

	for (size_t i = 0; i < COUNT(names); i++)
		unlink(names[i]);
}

/* Runs the session; its output goes to the file `out`. */
static enum run_status told(enum run_status (*ask)(struct session *, int, char **), struct session *session,
			    const char *const *words)
{
	int file = open("out", O_WRONLY | O_CREAT | O_TRUNC, 0600), output = dup(STDOUT_FILENO), count = 1;
	char *argv[8] = {(char *)"fivecheck"};
	enum run_status status;

	ck_assert(file >= 0 && output >= 0);
	while (words[count - 1]) {
		argv[count] = (char *)words[count - 1];
		count++;
	}
	fflush(stdout);
	dup2(file, STDOUT_FILENO);
	status = ask(session, count, argv);
	fflush(stdout);
	dup2(output, STDOUT_FILENO);
	close(output);
	close(file);
	return status;
}

#define CHECK(session, ...) told(session_check, session, (const char *const[]){__VA_ARGS__, NULL})
#define POSE(session, ...) told(session_pose, session, (const char *const[]){__VA_ARGS__, NULL})

static bool out_has(const char *text)
{
	static char content[65536];
	FILE *file = fopen("out", "rb");
	size_t count;

	ck_assert_ptr_nonnull(file);
	count = fread(content, 1, sizeof(content) - 1, file);
	content[count] = '\0';
	fclose(file);
	return strstr(content, text) != NULL;
}

START_TEST(programs_are_read_anew_and_the_machine_is_not)
{
	struct session *session = session_new();

	write_job();
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_CLEAR);
	ck_assert_int_eq(CHECK(session, "m.xml", "hit.nc"), RUN_FOUND);
	ck_assert(out_has("hit.nc:3"));
	write_text("clear.nc", "G21\nG53 G0 X-25\n");
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_FOUND);
	write_text("m.xml", "gone");
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_FOUND);
	/* With another clearance the bodies must be prepared again. */
	ck_assert_int_eq(CHECK(session, "--clearance=1", "m.xml", "clear.nc"), RUN_INCOMPLETE);
	session_free(session);
	remove_job();
}
END_TEST

START_TEST(a_clearance_is_that_of_its_check)
{
	struct session *session = session_new();

	write_job();
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_CLEAR);
	ck_assert_int_eq(CHECK(session, "--clearance=21", "m.xml", "clear.nc"), RUN_FOUND);
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_CLEAR);
	session_free(session);
	remove_job();
}
END_TEST

START_TEST(a_control_is_that_of_its_check)
{
	struct session *session = session_new();

	write_job();
	write_text("p.nc", "BEGIN PGM P MM\nL X+10 F100 M91\nEND PGM P MM\n");
	ck_assert_int_eq(CHECK(session, "--dialect=klartext", "m.xml", "p.nc"), RUN_CLEAR);
	ck_assert_int_eq(CHECK(session, "m.xml", "p.nc"), RUN_INCOMPLETE);
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_CLEAR);
	session_free(session);
	remove_job();
}
END_TEST

/* The digest is that of the mesh that was loaded and checked, not of the file that has its name now. */
START_TEST(digests_are_those_of_what_was_loaded)
{
	struct session *session = session_new();
	char loaded[DIGEST_SIZE], later[DIGEST_SIZE];

	write_job();
	ck_assert(digest_file(loaded, "cube.stl", NULL));
	ck_assert_int_eq(CHECK(session, "-f", "ndjson", "m.xml", "clear.nc"), RUN_CLEAR);
	ck_assert(out_has(loaded));
	write_text("cube.stl", "solid other\nendsolid other\n");
	ck_assert(digest_file(later, "cube.stl", NULL));
	ck_assert_int_eq(CHECK(session, "-f", "ndjson", "m.xml", "clear.nc"), RUN_CLEAR);
	ck_assert(out_has(loaded) && !out_has(later));
	/* The digest of a program is computed for each check. */
	write_text("clear.nc", "G21\nG53 G0 X11\n");
	ck_assert(digest_file(later, "clear.nc", NULL));
	ck_assert_int_eq(CHECK(session, "-f", "ndjson", "m.xml", "clear.nc"), RUN_CLEAR);
	ck_assert(out_has(later));
	session_free(session);
	remove_job();
}
END_TEST

START_TEST(a_machine_that_cannot_be_loaded_leaves_none)
{
	struct session *session = session_new();

	write_job();
	ck_assert_int_eq(POSE(session, "X=0"), RUN_INCOMPLETE);
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_CLEAR);
	ck_assert_int_eq(CHECK(session, "none.xml", "clear.nc"), RUN_INCOMPLETE);
	ck_assert_int_eq(POSE(session, "X=0"), RUN_INCOMPLETE);
	ck_assert_int_eq(CHECK(session, "--list-pairs", "m.xml"), RUN_INCOMPLETE);
	ck_assert_int_eq(CHECK(session, "--no-such-option", "m.xml", "clear.nc"), RUN_INCOMPLETE);
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_CLEAR);
	session_free(session);
	session_free(NULL);
	remove_job();
}
END_TEST

START_TEST(poses)
{
	struct session *session = session_new();

	write_job();
	ck_assert_int_eq(CHECK(session, "m.xml", "clear.nc"), RUN_CLEAR);
	ck_assert_int_eq(POSE(session, "X=-12.5"), RUN_CLEAR);
	ck_assert(out_has("\"distance\":7.5"));
	ck_assert_int_eq(POSE(session, "X=-25", "T=0"), RUN_FOUND);
	ck_assert(out_has("[\"post\",\"head\"]") || out_has("[\"head\",\"post\"]"));
	/* Axes that are not named are at home. */
	ck_assert_int_eq(POSE(session, "Y=15"), RUN_CLEAR);
	ck_assert(out_has("\"X\":0"));
	for (int i = 0; i < 6; i++) {
		static const char *const wrong[] = {"X", "X=", "X=1mm", "X=nan", "Z=1", ""};

		ck_assert_int_eq(POSE(session, wrong[i]), RUN_INCOMPLETE);
	}
	session_free(session);
	remove_job();
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("session");

	tcase_add_test(tcase, programs_are_read_anew_and_the_machine_is_not);
	tcase_add_test(tcase, a_clearance_is_that_of_its_check);
	tcase_add_test(tcase, a_control_is_that_of_its_check);
	tcase_add_test(tcase, digests_are_those_of_what_was_loaded);
	tcase_add_test(tcase, a_machine_that_cannot_be_loaded_leaves_none);
	tcase_add_test(tcase, poses);
	return run_in_folders("session", tcase);
}
