/* test_length_check.c - which active tool lengths belong to another tool. */
#include "motion/length_check.h"

#include <string.h>

#include "suite.h"

/* T1 100, T2 140, T3 140.2, T4 120 with edges of 115 and 110. An <offset> gives 90 for H2. */
static struct tool tools[4];
static struct tool_edge edges[] = {{4, 2, 115, 0}, {4, 3, 110, 0}};
static struct length_offset lengths[] = {{2, 90}, {50, 105}};
static struct setup setup = {.tools = tools, .tool_count = 4, .edges = edges, .edge_count = 2,
			     .lengths = lengths, .length_count = 2};

static void start(void)
{
	static const double all[] = {100, 140, 140.2, 120};

	for (int i = 0; i < 4; i++)
		tools[i] = (struct tool){.number = i + 1, .name = "", .length = all[i], .length_offset = all[i]};
}

static struct canon_move move_of(enum canon_kind kind, bool turns, const struct canon_origin *origin)
{
	struct canon_move move;

	memset(&move, 0, sizeof(move));
	move.kind = kind;
	move.spindle_turns = turns;
	move.origin = origin;
	return move;
}

/* The number of warnings for a move of this tool with this length. */
static int said(int tool, double length)
{
	const struct canon_origin origin = {.length = length};
	const struct canon_move move = move_of(CANON_FEED, true, &origin);
	struct length_check check = {.told = false};
	struct diag diag = {0};

	length_check_tool(&check, &setup, tool);
	length_check_move(&check, &diag, (struct srcloc){"p.nc", 1, 0}, &move);
	length_check_move(&check, &diag, (struct srcloc){"p.nc", 2, 0}, &move);
	ck_assert_uint_eq(diag.errors, 0);
	return (int)diag.warnings;
}

START_TEST(own_and_others)
{
	start();
	/* No length, the tool's own, nearly its own. */
	ck_assert_int_eq(said(1, 0), 0);
	ck_assert_int_eq(said(1, 100), 0);
	ck_assert_int_eq(said(1, 100.4), 0);
	ck_assert_int_eq(said(1, 103), 0);
	/* A length that belongs to no tool. */
	ck_assert_int_eq(said(1, 105), 0);
	/* The lengths of T2 (by its offset), T3 and T4. */
	ck_assert_int_eq(said(1, 90), 1);
	ck_assert_int_eq(said(1, 140.2), 1);
	ck_assert_int_eq(said(1, 120), 1);
	ck_assert_int_eq(said(1, 120.00001), 0);
	/* The length of T2 that its offset replaces. */
	ck_assert_int_eq(said(1, 140), 0);
	ck_assert_int_eq(said(2, 90), 0);
	ck_assert_int_eq(said(2, 140.2), 1);
	/* The tool's own edges. */
	ck_assert_int_eq(said(4, 115), 0);
	ck_assert_int_eq(said(4, 110), 0);
	ck_assert_int_eq(said(4, 100), 1);
	edges[1].length = 100.2;
	ck_assert_int_eq(said(4, 100), 0);
	edges[1].length = 110;
	/* A tool that the setup does not have. */
	ck_assert_int_eq(said(9, 100), 0);
	ck_assert_int_eq(said(0, 100), 0);
	tools[0].checked = "r";
	ck_assert_int_eq(said(1, 120), 0);
	tools[0].checked = NULL;
	tools[0].kind = TOOL_PROBES;
	ck_assert_int_eq(said(1, 120), 0);
}
END_TEST

START_TEST(which_moves)
{
	static const struct canon_origin own_length = {.length = 100}, other = {.length = 120};
	const struct canon_move rapid = move_of(CANON_RAPID, true, &other), standing = move_of(CANON_FEED, false, &other);
	const struct canon_move own = move_of(CANON_ARC, true, &own_length), arc = move_of(CANON_ARC, true, &other);
	struct length_check check = {.told = false};
	const struct srcloc at = {"p.nc", 1, 0};
	struct diag diag = {0};

	start();
	length_check_tool(&check, NULL, 1);
	length_check_move(&check, &diag, at, &arc);
	length_check_tool(&check, &setup, 1);
	length_check_move(&check, &diag, at, &rapid);
	length_check_move(&check, &diag, at, &standing);
	length_check_move(&check, &diag, at, &own);
	ck_assert_uint_eq(diag.warnings, 0);
	length_check_move(&check, &diag, at, &arc);
	ck_assert_uint_eq(diag.warnings, 1);
	/* One warning per program, for all tools. */
	length_check_tool(&check, &setup, 2);
	length_check_move(&check, &diag, at, &arc);
	ck_assert_uint_eq(diag.warnings, 1);
	/* The length stays active while the tool changes. */
	check = (struct length_check){.told = false};
	length_check_tool(&check, &setup, 4);
	length_check_move(&check, &diag, at, &arc);
	ck_assert_uint_eq(diag.warnings, 1);
	length_check_tool(&check, &setup, 1);
	length_check_move(&check, &diag, at, &arc);
	ck_assert_uint_eq(diag.warnings, 2);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {own_and_others, which_moves};

	return RUN_TESTS("length_check", tests);
}
