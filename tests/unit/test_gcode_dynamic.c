/* test_gcode_dynamic.c - G254 and G255 of Haas, against a table that turns with C about the machine's zero. */
#include "gcode_refusal.h"

static const struct length_offset lengths[] = {{1, 100}};
static const struct mcode mcodes[] = {{428, MCODE_TCP_ON}};
static const struct work_offset offsets[] = {{.name = "G54", .value = {{10, 2, -50}}}, {.name = "G55", .value = {{1, 2, 3}}}};

static void dynamic_case(struct gcode_case *c)
{
	case_init(c);
	c->config.dialect = &dialect_haas;
	c->config.controller.length_moves = ANSWER_NO;
	c->config.lengths = lengths;
	c->config.length_count = 1;
	c->config.controller.mcodes = mcodes;
	c->config.controller.mcode_count = 1;
	c->config.work_offsets = offsets;
	c->config.work_offset_count = 2;
}

static void run(const char *program, const char *moves)
{
	struct gcode_case c;

	dynamic_case(&c);
	case_expect(&c, program, moves);
}

/*
 * Haas mill operator's manual (NGC), "G254 Dynamic Work Offset (DWO)". C90 takes
 * the work zero from (10, 2) to (-2, 10); X, Y and Z go on along the machine's axes.
 */
START_TEST(shifts_with_the_table)
{
	run("G54 G0 C90.\nG254\nX1. Y0.\nG43 H1 Z5.\nG1 X3. Y1. Z-1. F99.\nG91 X1.\nG90 G2 X5. Y0. R1.\n"
	    "G0 Z5.\nG81 X0. Y0. Z-2. R1.\nG80\nG255\nG0 X1. Y0. Z5.\nM30\n",
	    "rapid 0 0 0 0 90\nrapid -1 10 0 0 90\nrapid -1 10 55 0 90\nfeed 1 11 49 0 90\nfeed 2 11 49 0 90\n"
	    "arc 3 10 49 0 90 centre 2 10 49 normal 0 0 1 sweep -90\n"
	    "rapid 3 10 55 0 90\nrapid -2 10 55 0 90\nrapid -2 10 51 0 90\nfeed -2 10 48 0 90\n"
	    "rapid -2 10 55 0 90\n"
	    "rapid 11 2 55 0 90\n");
}
END_TEST

/* An axis that is not named stays where it is; each block is in the coordinates of its time. */
START_TEST(moves_nothing_by_itself)
{
	run("G54 G0 X5. Y6. Z7. C180.\nG254\nG0 X0.\nY0.\nZ0.\nG255\nX0.\nM30\n",
	    "rapid 15 8 -43 0 180\nrapid -10 8 -43 0 180\nrapid -10 -2 -43 0 180\nrapid -10 -2 -50 0 180\n"
	    "rapid 10 -2 -50 0 180\n");
	/* At C0 nothing changes, so no axis has to move first. */
	run("G54 G0 X5. Y6. Z7.\nG254\nG91 G1 X1. F9.\nG255\nX1.\nM30\n",
	    "rapid 15 8 -43 0 0\nfeed 16 8 -43 0 0\nfeed 17 8 -43 0 0\n");
	/* G254 while it is active, and the same work offset selected again. */
	run("G54 G0 C90.\nG254\nG0 X0. Y0.\nG254\nG54 Z0.\nX1.\nM30\n",
	    "rapid 0 0 0 0 90\nrapid -2 10 0 0 90\nrapid -2 10 -50 0 90\nrapid -1 10 -50 0 90\n");
	/*
	 * After G255 a cut may move the axes itself; a G1 without motion and moves in machine coordinates do not cut.
	 */
	run("G54 G0 C90.\nG254\nG1 F9.\nG53 Z-1.\nG0 X0. Y0.\nG255\nG1 X0. Y0.\nX1.\nM30\n",
	    "rapid 0 0 0 0 90\nfeed 0 0 -1 0 90\nrapid -2 10 -1 0 90\nfeed 10 2 -1 0 90\nfeed 11 2 -1 0 90\n");
	/* A rotary word that turns nothing. */
	run("G54 G0 C90.\nG254\nG0 X0. Y0. C90.\nM30\n", "rapid 0 0 0 0 90\nrapid -2 10 0 0 90\n");
}
END_TEST

/* The same section: G28, G53 and M06 ignore it; M30 ends it. */
START_TEST(ignored_by_machine_places)
{
	struct gcode_case c;

	run("G54 G0 C90.\nG254\nX0. Y0.\nG53 Z-1.\nG91 G28 Z0.\nG90 G0 Z0.\nG28 X1. Y1.\nX0. Y0.\nM30\n",
	    "rapid 0 0 0 0 90\nrapid -2 10 0 0 90\nrapid -2 10 -1 0 90\nrapid -2 10 -1 0 90\nrapid -2 10 0 0 90\n"
	    "rapid -2 10 -50 0 90\nrapid 11 3 -50 0 90\nrapid 0 0 -50 0 90\nrapid -2 10 -50 0 90\n");
	dynamic_case(&c);
	c.config.controller.tool_change = (struct control_place){.given = true, .has[SLOT_Z] = true, .order = {SLOT_Z},
						    .order_count = 1};
	case_expect(&c, "G54 G0 C90.\nG254\nX0. Y0. Z0.\nT1 M6\nX1.\nM30\n",
		    "rapid 0 0 0 0 90\nrapid -2 10 -50 0 90\nrapid -2 10 0 0 90\ntool 1\nrapid -1 10 0 0 90\n");
}
END_TEST

struct bad {
	const char *before, *block;
	int column;
	const char *message;
};

#define ON "G54 G0 C90.\nG254"
#define LED "G54 G0 C90.\nG254\nX0. Y0. Z0."
#define ALONE "G254 needs a block without axis words, offsets, tool length or tool change"
#define UNLED(what, axis)                                                                                            \
	what ", but before G0 has moved " axis " to an absolute coordinate: the control needs this for each of X, "  \
	     "Y and Z before it cuts"
#define CHANGE "a change of offsets while G254 is active is not supported; write G255 first"
#define TCP "tool centre point control while G254 is active; write G255 first"
#define TURNS " turns while G254 is active: it is not known whether the work zero turns with it; write G255 first"
#define READ                                                                                                         \
	"it is not known whether the position is relative to the work zero or to the one that G254 has moved; write " \
	"G255 first"

static const struct bad bads[] = {
    {"G0", "G254 X1.", 1, ALONE},
    {"", "G55 G254", 5, ALONE},
    {"", "G254 G43 H1", 1, ALONE},
    {"T1", "M6 G254", 4, ALONE},
    {"", "G255 G53 G0 Z0.", 1, "G255 needs a block without axis words, offsets, tool length or tool change"},
    {"", "G254 G255", 6,
     "G255 and the G-code at column 1 belong to the same modal group; a block can have only one of them"},
    {ON, "G1 X0. Y0. Z0. F9.", 1, UNLED("G1 after G254", "X")},
    {ON "\nX0.", "G1 X0. Y0. F9.", 1, UNLED("G1 after G254", "Y")},
    {"G54 G0 C90.\nG53 X0. Y0.\nG254\nG53 X0. Y0. Z0.", "G81 X0. Y0. Z0. R1. F9.", 1, UNLED("G81 after G254", "X")},
    {ON "\nX0. F9.", "G2 I5.", 1, UNLED("G2 after G254", "Y")},
    {LED "\nG255\nX0.", "G1 Z0. F9.", 1,
     "G1 after G255 without Y: it is not known whether the axis stays in place; write its absolute coordinate"},
    {LED "\nG255\nX0.", "G91 G1 Y0. F9.", 5,
     "G1 after G255 without Y: it is not known whether the axis stays in place; write its absolute coordinate"},
    {ON, "G91 X5.", 5,
     "increment in X after G254: the start point of the increment is not known; move the axis to an absolute "
     "coordinate first"},
    {ON "\nG91 Y0. Z1.", "G28 Y1.", 5,
     "increment in Y after G254: the start point of the increment is not known; move the axis to an absolute "
     "coordinate first"},
    {LED "\nG255", "G91 Y1.", 5,
     "increment in Y after G255: the start point of the increment is not known; move the axis to an absolute "
     "coordinate first"},
    {LED, "X1. C91.", 5, "C" TURNS},
    {LED, "G53 C0.", 5, "C" TURNS},
    {LED, "G91 G28 C0.", 9, "C" TURNS},
    {LED, "G28", 1, "C" TURNS},
    {LED, "G30 Z0.", 1,
     "G30 while G254 is active: it is not known whether the control ignores G254 on the way; write G255 first"},
    {LED, "G55", 1,
     "a change of the work offset while G254 is active: the control needs it before G254; write G255 first"},
    {LED "\n#5221=3.", "G54", 1,
     "a change of the work offset while G254 is active: the control needs it before G254; write G255 first"},
    {LED, "G10 L2 P1 X1.", 1, CHANGE},
    {LED, "G52 X1.", 1, CHANGE},
    {LED, "G92 X1.", 1, CHANGE},
    {LED, "G68 R5.", 1, "G68 while G254 is active; write G255 first"},
    {LED, "G234 H1", 1, TCP},
    {LED, "M428", 1, TCP},
    {LED, "X#5001", 2, READ},
    {LED "\nG255", "X#5001", 2,
     "the position after G255 is not known; move the axis to an absolute coordinate first"},
    {"G234 H1", "G254", 1, "G254 under tool centre point control; cancel tool centre point control first"},
    {"G68 X0. Y0. R5.", "G254", 1, "G254 while G68 is active; write G69 first"},
    {"G52 Y1.", "G254", 1,
     "G254 while G52 shifts Y: it is not known whether the shift moves with the table; cancel the shift first"},
    {"G10 L2 P1 C5.", "G254", 1, "G254 with a work offset of 5 degrees in C: the control needs 0"},
    {"#5221=3.", "G254", 1,
     "G54 was changed by assignment while it was active, and controls differ in when that takes effect; select G54 "
     "again before the next move"},
};

START_TEST(refused)
{
	const struct bad *bad = &bads[_i];
	struct gcode_case c;

	dynamic_case(&c);
	c.config.controller.tool_change.given = true;
	case_refuses_last(&c, bad->column, bad->message, "%s%s%s\n", bad->before, *bad->before ? "\n" : "", bad->block);
}
END_TEST

/* M6 that turns a rotary axis; a machine that carries nothing; a work offset that the setup lacks. */
START_TEST(machine_and_setup)
{
	struct gcode_case c;

	dynamic_case(&c);
	c.config.controller.tool_change = (struct control_place){.given = true, .has[SLOT_C] = true};
	ck_assert(!case_run(&c, LED "\nT1 M6\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:4:4: error: C" TURNS "\n"));
	case_release(&c);
	dynamic_case(&c);
	c.refuse_tcp = true;
	ck_assert(!case_run(&c, "G254\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:1:1: error: nothing is carried here\n"));
	case_release(&c);
	dynamic_case(&c);
	c.config.has_setup = true;
	c.config.work_offset_count = 0;
	ck_assert(!case_run(&c, "G254\nM30\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:1:1: error: the setup defines no work offset G54: add "));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, shifts_with_the_table);
	tcase_add_test(tcase, moves_nothing_by_itself);
	tcase_add_test(tcase, ignored_by_machine_places);
	tcase_add_test(tcase, machine_and_setup);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_dynamic", tcase);
}
