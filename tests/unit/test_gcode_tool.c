/* test_gcode_tool.c - G10 L1, L10 and L11: by hand from LinuxCNC's manual; tests/rs274 compares them with rs274. */
#include "gcode_refusal.h"

static const struct tool tools[] = {{.number = 1, .length_offset = 100, .diameter = 10},
				     {.number = 2, .length_offset = 50, .diameter = 6}};
static const struct length_offset lengths[] = {{1, 100}, {2, 40}, {7, 33}};
static const struct mcode mcodes[] = {{428, MCODE_TCP_ON}, {429, MCODE_TCP_OFF}};

static void tool_case(struct gcode_case *c)
{
	case_init(c);
	c->config.has_setup = true;
	c->config.tools = tools;
	c->config.tool_count = 2;
	c->config.lengths = lengths;
	c->config.length_count = 3;
	c->config.controller.mcodes = mcodes;
	c->config.controller.mcode_count = 2;
}

static void run(const char *program, const char *moves)
{
	struct gcode_case c;

	tool_case(&c);
	case_expect(&c, program, moves);
}

/* "G10 L1": the entry changes at once, the compensation in force with the next G43. */
START_TEST(length_from_the_next_g43)
{
	run("T1 M6\nG43 G0 Z1\nG10 L1 P1 Z30\nZ2\nG43\nZ2\nG49 Z3\nM2\n",
	    "tool 1\nrapid 0 0 101 0 0\nrapid 0 0 102 0 0\nrapid 0 0 32 0 0\nrapid 0 0 3 0 0\n");
	/* The H of the number as well, though the setup gave it a length of its own; no other entry. */
	run("G10 L1 P2 Z20\nG43 H2 G0 Z0\nG43 H1 Z0\nT2 M6\nG43 Z0\nM2\n",
	    "rapid 0 0 20 0 0\nrapid 0 0 100 0 0\ntool 2\nrapid 0 0 20 0 0\n");
	/* Nothing of tool 1 is in an empty spindle. */
	run("G10 L1 P1 Z20\nG43 G0 Z1\nX#5403\nM2\n", "rapid 0 0 1 0 0\nrapid 0 0 1 0 0\n");
}
END_TEST

START_TEST(units)
{
	run("T1 M6\nG20 G10 L1 P1 Z2 R.5\nG21 G43 G0 Z0\nX#5403 Y#5410\nM2\n",
	    "tool 1\nrapid 0 0 50.8 0 0\nrapid 50.8 25.4 50.8 0 0\n");
	run("T1 M6\nG0 Z254\nG20 G10 L10 P1 Z1\nG43 Z0\nM2\n",
	    "tool 1\nrapid 0 0 254 0 0\nrapid 0 0 228.6 0 0\n");
}
END_TEST

/* LinuxCNC's manual, "G43.1", "G43.2": from words, in the unit in force; no axis moves. */
START_TEST(length_from_words)
{
	run("G0 Z10\nG43.1 Z5\nX1\nZ10\nG43.2 Z2.5\nZ10\nG43.2 H1\nZ10\nG20 G43.1 Z1\nZ1\nG49 Z1\nM2\n",
	    "rapid 0 0 10 0 0\nrapid 1 0 10 0 0\nrapid 1 0 15 0 0\nrapid 1 0 17.5 0 0\nrapid 1 0 117.5 0 0\n"
	    "rapid 1 0 50.8 0 0\nrapid 1 0 25.4 0 0\n");
	/* As an axis word, Z is no motion's. */
	run("F9 G1 Z3\nG43.1 Z5\nX1\nM2\n", "feed 0 0 3 0 0\nfeed 1 0 3 0 0\n");
	run("G43.1 Z30\nM428\nG0 X1 Z0\nM2\n", "tcp on length 30 zero A0 C0\nrapid 1 0 0 0 0 tcp\n");
}
END_TEST

/* The definition of L10 and L11: after G43 the same place has the coordinate that was given. */
START_TEST(measured)
{
	run("T1 M6\nG10 L2 P1 Z5\nG92 Z-7\nG43 G0 Z60\nG10 L10 P1 Z11\nG43 X1 Z11\nM2\n",
	    "tool 1\nrapid 0 0 167 0 0\nrapid 1 0 167 0 0\n");
	run("T1 M6\nG10 L2 P1 Z5\nG10 L2 P9 Z-20\nG92 Z-7\nG43 G0 Z60\nG10 L11 P1 Z11\nG92.1\nG59.3 G43 X1 Z11\nM2\n",
	    "tool 1\nrapid 0 0 167 0 0\nrapid 1 0 167 0 0\n");
}
END_TEST

START_TEST(radius)
{
	run("F9 G10 L1 P1 R2\nG41 D1\nG1 X10 Y0\nX30\nG40 X50\nM2\n",
	    "feed 10 2 0 0 0\nfeed 30 2 0 0 0\nfeed 50 0 0 0 0\n");
}
END_TEST

/* Under TCP the length written is the length along the spindle, from the next G43 or G43.4 on. */
START_TEST(under_tcp)
{
	run("G10 L1 P1 Z30\nG43.4 H1\nG0 X1 Z0\nG10 L1 P1 Z70\nX2\nG43.4 H1\nM2\n",
	    "tcp on length 30 zero A0 C0\nrapid 1 0 0 0 0 tcp\nrapid 2 0 0 0 0 tcp\ntcp on length 70 zero A0 C0\n");
	run("T1 M6\nG10 L1 P1 Z30\nG43\nM428\nG0 X1 Z0\nM429\nM2\n",
	    "tool 1\ntcp on length 30 zero A0 C0\nrapid 1 0 0 0 0 tcp\ntcp off length 30 zero A0 C0\n");
}
END_TEST

/* After a probe the place is known again with an absolute coordinate. */
START_TEST(after_a_probe)
{
	run("T1 M6 F9\nG38.2 Z-9\nG0 Z5\nG10 L10 P1 Z0\nG43 Z0\nM2\n",
	    "tool 1\nfeed 0 0 -9 0 0\nrapid 0 0 5 0 0\nrapid 0 0 5 0 0\n");
	run("T1 M6 F9\nG38.2 Z-9\nG10 L10 P1 R2\nG10 L1 P1 Z2\nG43 G0 Z0\nM2\n",
	    "tool 1\nfeed 0 0 -9 0 0\nrapid 0 0 2 0 0\n");
}
END_TEST

START_TEST(fixture_not_in_the_setup)
{
	struct gcode_case c;

	tool_case(&c);
	ck_assert(!case_run(&c, "G10 L11 P1 Z-3\nG43 H1 G0 Z1\nM2\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "error: the setup defines no work offset G59.3: add "));
	case_release(&c);
}
END_TEST

#define PROBED \
	" measures the tool at the probed position of Z, which is not known before the program runs; give the " \
	"length in the setup or by G10 L1"

static const struct {
	const char *program, *message;
} bad[] = {
    {"G10 L1 P3 Z1\n", "1:8: error: the setup defines no tool T3: add <tool number=\"3\" length=\"\"/> with its shape"},
    {"G10 L1 P7 Z1\n", "1:8: error: the setup defines no tool T7: add <tool number=\"7\" length=\"\"/> with its shape"},
    {"G10 L1 P1\n", "1:1: error: G10 L1 without effect: give Z (tool length) or R (tool radius)"},
    {"G10 L1 P1 Z1 J3\n",
     "1:14: error: J: angles and orientation of lathe tools are not supported"},
    {"G10 L1 P1 Y2\n",
     "1:11: error: G10 L1 gives T1 an offset of 2 mm in Y, which G43 would apply; only tool offsets in Z are "
     "supported"},
    {"G0 C30\nG10 L10 P1 C0\n", "2:12: error: G10 L10 gives T1 an offset of 30 degrees in C, which"},
    {"G43.4 H1\nG10 L10 P1 Z0\n",
     "2:1: error: G10 L10 measures the tool at the machine position, which is not supported under TCP; cancel TCP "
     "first"},
    {"F9 G38.2 Z-9\nG10 L11 P1 Z0\n", "2:1: error: G10 L11" PROBED},
    {"F9 G38.2 Z-9\nG91 G0 X1\nG90 X2\nG10 L10 P1 Z0\n", "4:1: error: G10 L10" PROBED},
    {"F9 G43.4 H1\nG38.3 Z-9\nG0 X1 Y1\nG49\nG10 L10 P1 Z0\n", "5:1: error: G10 L10" PROBED},
    {"G41.1 D2\nG10 L1 P1 R1\n", "2:1: error: a code that moves or shifts the machine's axes while cutter"},
};

START_TEST(refused)
{
	struct gcode_case c;

	tool_case(&c);
	case_refuses(&c, bad[_i].message, "%s", bad[_i].program);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("tool table");

	tcase_add_test(tcase, length_from_the_next_g43);
	tcase_add_test(tcase, units);
	tcase_add_test(tcase, length_from_words);
	tcase_add_test(tcase, measured);
	tcase_add_test(tcase, radius);
	tcase_add_test(tcase, under_tcp);
	tcase_add_test(tcase, after_a_probe);
	tcase_add_test(tcase, fixture_not_in_the_setup);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bad));
	return run_suite("gcode_tool", tcase);
}
