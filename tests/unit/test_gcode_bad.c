/* test_gcode_bad.c - programs that must be refused, each with its message, its place and its caret. */
#include "gcode_refusal.h"

struct bad {
	const char *program;
	int line, column;
	const char *message;
};

/* The message is the only one, and the caret stands below the column of the line that it names. */
static void expect_bad(const struct bad *bad, const struct dialect *dialect, bool has_setup)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = dialect;
	c.config.has_setup = has_setup;
	case_refuses_at(&c, bad->program, bad->line, bad->column, bad->message);
}

#define PROBED \
	"the position where the probe stopped Z is not known before the program runs; move the axis to an absolute " \
	"coordinate (G90) first"

static const struct bad texts[] = {
    /* "G38.n Straight Probe": only the machine knows how far the axis goes. */
    {"G38.2 Z-9 F99\nG91 G1 X2 Z2\n", 2, 11, PROBED},
    {"G38.2 Z-9 F99\nG92 Z0\n", 2, 5, PROBED},
    {"G38.2 Z-9 F99\n#1=#5420\nG0 Z#5422\n", 3, 5, PROBED},
    {"G38.2 Z-9 F99\nG0 X#<_z>\n", 2, 5, PROBED},
    {"G38.2 Z-9 F99\nG10 L20 P1 X1\nG10 L20 P1 Z3\n", 3, 12, PROBED},
    {"G0 X1 (open\n", 1, 7, "this comment is not closed"},
    {"G0 X1 (a (b) c)\n", 1, 10, "a comment inside a comment"},
    {"G0 X1 (x))\n", 1, 10, "unexpected ')'"},
    {"G0 X\n", 1, 4, "X without a number"},
    {"G0 X-\n", 1, 4, "X without a number"},
    {"G0 X.\n", 1, 4, "X without a number"},
    {"G0 X1.2.3\n", 1, 8, "unexpected '.'"},
    {"G0 X1e3\n", 1, 6, "no code in the block uses the word E; numbers cannot have an exponent"},
    {"G0 X1 ! Y2\n", 1, 7, "unexpected '!'"},
    {"G0 X\xc2\xb5"
     "1\n",
     1, 4, "X without a number"},
    {"G0 X1\xc3\n", 1, 6, "unexpected byte 0xC3: only comments can have characters other than ASCII"},
    {"G0 X1 /Y2\n", 1, 7, "'/' is allowed only at the start of a block"},
    {"G0 X1 % \n", 1, 7, "'%' must be alone on its line"},
    {"% part 7\n", 1, 1, "'%' must be alone on its line"},
    {"G0 X1\n%\n", 2, 1, "'%' ends a program only if one begins it"},
    {"(header)\n%\nG0 X1\n", 2, 1, "'%' ends a program only if one begins it"},
    {"G0 N10 X1\n", 1, 4, "N is allowed only at the start of a block"},
    {"N1.5 X1\n", 1, 1, "a line number must be a whole number that is not negative"},
    {"N-1 X1\n", 1, 1, "a line number must be a whole number that is not negative"},
    {"N1 N2 G0\n", 1, 4, "N is allowed only at the start of a block"},
    {"G0 @10 Y5\n", 1, 8, "X and Y cannot stand beside polar coordinates (@, ^)"},
    {"G0 X5 ^45\n", 1, 7, "X and Y cannot stand beside polar coordinates (@, ^)"},
    {"G0 @5 @6\n", 1, 7, "@ occurs twice in the block"},
    {"G0 @\n", 1, 4, "@ without a number"},
    {"G18\nG0 @5 ^10\n", 2, 4, "polar coordinates (@, ^) need the plane G17 in a block before"},
    {"G92 @5 ^10\n", 1, 5, "polar coordinates (@, ^) are supported with G0, G1, G2 and G3 alone"},
    {"G81 @5 ^10 Z-1 R1 F10\n", 1, 5, "polar coordinates (@, ^) are supported with G0, G1, G2 and G3 alone"},
    {"G0 @5\n", 1, 4, "@ needs ^ beside it where the tool stands at X0 Y0"},
    {"G0 G91 @5 ^10\n", 1, 8, "increments of polar coordinates (@, ^) where the tool stands at X0 Y0"},
    {"M3 $1 S5\n", 1, 4, "$: spindle numbers are not supported"},
    {"(py,emccanon.MESSAGE)\n", 1, 1, "a comment that runs Python code is not supported"},
    {";py,emccanon.STRAIGHT_FEED(0)\n", 1, 1, "a comment that runs Python code is not supported"},
    {"( ABORT, no tool)\n", 1, 1, "the comment (ABORT, ...) stops the program here"},
};

static const struct bad codes[] = {
    {"G12.5\n", 1, 1, "G12.5 is not a G-code of the linuxcnc dialect"},
    {"G12\n", 1, 1, "G12 is not a G-code of the linuxcnc dialect"},
    {"G1.05 X1\n", 1, 1, "1.05 is not a G-code"},
    {"G99999\n", 1, 1, "99999 is not a G-code"},
    {"G-1\n", 1, 1, "a G-code must not be negative"},
    {"M-1\n", 1, 1, "an M-code must not be negative"},
    {"M3.5\n", 1, 1, "3.5 is not an M-code"},
    {"G0 X1\nG41 D1 X2\n", 2, 5, "the setup does not give the diameter of tool T1"},
    {"G42.1\n", 1, 1, "G42.1 needs D (tool diameter)"},
    {"G43.1\n", 1, 1, "G43.1 needs an axis word"},
    {"G43.1 Z1 H1\n", 1, 10, "no code in the block uses the word H"},
    {"G43.1 X1\n", 1, 7, "a tool offset in X is not supported, only in Z"},
    {"G0 G43.1 Z1\n", 1, 4, "G43.1 with axis words needs a block without motion and offsets"},
    {"G43.2\n", 1, 1, "G43.2 needs either H or axis words"},
    {"G43.2 H1 Z1\n", 1, 1, "G43.2 needs either H or axis words"},
    {"G43.2 H7\n", 1, 7, "H7: no length offsets are defined, because there is no setup"},
    {"G6 X1 I1 J1\n", 1, 1, "G6: NURBS block is not supported; post the program without it"},
    {"G96 D100\n", 1, 1, "G96 needs S (surface speed)"},
    {"G97 D1\n", 1, 5, "no code in the block uses the word D"},
    {"G1 F1 X1 M62\n", 1, 10, "M62 needs P (number of the output)"},
    {"M68 Q1\n", 1, 1, "M68 needs E (number of the output)"},
    {"M67 E-1 Q1\n", 1, 5, "the number of an output must not be negative"},
    {"M48 P1\n", 1, 5, "no code in the block uses the word P"},
    {"M48 M52\n", 1, 5,
     "M52 and the M-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"M66 L0\n", 1, 1, "M66 needs the number of one input, in either P or E"},
    {"M66 P1 E1\n", 1, 1, "M66 needs the number of one input, in either P or E"},
    {"M66 P1 L3\n", 1, 8, "M66 with L3 needs P (input) and Q (timeout)"},
    {"M66 E1 L1 Q1\n", 1, 8, "M66 with L1 needs P (input) and Q (timeout)"},
    {"M66 P1 L5 Q1\n", 1, 8, "L5 must be a whole number from 0 to 4"},
    {"M66 P1 L0\nG0 X#5399\n", 2, 5, "#5399 (an input that M66 has read) is not known before the program runs"},
    {"M61 Q0\nG43\n", 2, 1, "after M61, controls differ in the tool whose length G43 uses: write H0"},
    {"M61\n", 1, 1, "M61 needs Q (number of the tool in the spindle)"},
    {"M61 Q-1\n", 1, 5, "Q-1 must be a whole number from 0 to 2147483647"},
    {"M70 G91\n", 1, 1, "M70 needs a block of its own, because its order among other words is not known"},
    {"M72\n", 1, 1, "M72 without M70 or M73 before it in this subprogram"},
    {"M70\nM71\nM72\n", 3, 1, "M72 without M70 or M73 before it in this subprogram"},
    {"M70\nG93\nM72\n", 3, 1,
     "M72 and the end of M73 restore the feed mode only partly in LinuxCNC; restore it by its own code first"},
    {"M428\n", 1, 1,
     "M428 is not known; if it moves no axis, set <mcode number=\"428\" action=\"ignore\"/> in the machine file's "
     "<controller>"},
    {"G0 G1 X1\n", 1, 4,
     "G1 and the G-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"G1 G1 X1\n", 1, 4,
     "G1 and the G-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"G80 G80\n", 1, 5,
     "G80 and the G-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"G54 G59.1\n", 1, 5,
     "G59.1 and the G-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"G4 P1 G53\n", 1, 7,
     "G53 and the G-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"M3 M4\n", 1, 4,
     "M4 and the M-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"M0 M30\n", 1, 4,
     "M30 and the M-code at column 1 belong to the same modal group; a block can have only one of them"},
    {"M3 M8 M6 M0 M9\n", 1, 13, "a block can have at most 4 M-codes"},
    {"G0 X1 Y2 X3\n", 1, 10, "the word X occurs twice in the block, at columns 4 and 10"},
    {"F1 F1\n", 1, 4, "the word F occurs twice in the block, at columns 1 and 4"},
};

static const struct bad blocks[] = {
    {"X1\n", 1, 1, "axis words without an active motion code (G0, G1, G2, G3)"},
    {"G0 X1\nG80\nY1\n", 3, 1, "axis words without an active motion code (G0, G1, G2, G3)"},
    {"G80 X1\n", 1, 5, "axis words with G80, which cancels motion; write a motion code instead"},
    {"G0 B1\n", 1, 4, "the machine has no B axis"},
    {"G10 L2 P1 V1\n", 1, 11, "the machine has no V axis"},
    {"G0 G92 X1\n", 1, 1, "G0 and G92 both need the axis words of the block; write two blocks"},
    {"G28 G1 X1\n", 1, 5, "G1 and G28 both need the axis words of the block; write two blocks"},
    {"G92\n", 1, 1, "G92 without an axis word"},
    {"G52\n", 1, 1, "G52 without an axis word"},
    {"G53 X1\n", 1, 5, "axis words without an active motion code (G0, G1, G2, G3)"},
    {"G53\n", 1, 1, "G53 needs G0 or G1"},
    {"G0\nG53 G2 X1 I1\n", 2, 1, "G53 needs G0 or G1"},
    {"G91\nG53 G0 X1\n", 2, 1, "G53 in incremental mode (G91); write G90 first"},
    {"G53 G0 G91 X1\n", 1, 1, "G53 in incremental mode (G91); write G90 first"},
    {"G4\n", 1, 1, "G4 needs its time in P"},
    {"G4 P-1\n", 1, 4, "a dwell must not be negative"},
    {"G4 P1 G2 X1 I1\n", 1, 1, "G4 is not allowed with G2 or G3, which also use P"},
    {"G0 X1 I1\n", 1, 7, "no code in the block uses the word I"},
    {"G0 X1 P1\n", 1, 7, "no code in the block uses the word P"},
    {"G0 X1 R1\n", 1, 7, "no code in the block uses the word R"},
    {"H1\n", 1, 1, "no code in the block uses the word H"},
    {"D1\n", 1, 1, "no code in the block uses the word D"},
    {"G0 X1 L2\n", 1, 7, "no code in the block uses the word L"},
    {"G61 P.1\n", 1, 5, "no code in the block uses the word P"},
    {"G64 P-.1\n", 1, 5, "a path tolerance must not be negative"},
    {"F-1\n", 1, 1, "a feed rate must not be negative"},
    {"M3 S-1\n", 1, 4, "a spindle speed must not be negative"},
    {"M6\n", 1, 1, "M6 without a tool: write T first"},
    {"T1.5 M6\n", 1, 1,
     "T1.5: a tool number must be whole; where T1.1 is a tool and its offset (Fagor), write T1, and H1 or D1 for the "
     "offset"},
    {"G0 W1\n", 1, 4,
     "the machine has no W axis; on a lathe U and W are increments of X and Z, but lathe programs are not supported"},
    {"T-1\n", 1, 1, "T-1 must be a whole number from 0 to 2147483647"},
    {"G43 H5\n", 1, 5, "H5: no length offsets are defined, because there is no setup"},
    {"T3 M6\nG43 G0 Z1\n", 2, 1, "the length of T3, the tool in the spindle, is not known; give it in the setup"},
    {"G10 L2 X1\n", 1, 1, "G10 needs L and P"},
    {"G10 L1 P1 Z1\n", 1, 8, "P1: no tools are defined, because there is no setup"},
    {"G10 L2 P10 X1\n", 1, 8, "P10 must be a whole number from 0 to 9"},
    {"G10 L2 P1.5 X1\n", 1, 8, "P1.5 must be a whole number from 0 to 9"},
    {"G10 L2 P1 R45\n", 1, 11, "G10 with R: rotation of a coordinate system is not supported"},
    {"G43.4 H0\nG43\n", 2, 1, "G43 while tool centre point control is on; write G49 first"},
};

static const struct bad motions[] = {
    {"G1 X1\n", 1, 1, "G1 without a feed rate (F)"},
    {"G1 F10 X1\nG94 X2\n", 2, 5, "G1 without a feed rate (F)"},
    {"G95 G1 F.1 X1\n", 1, 5, "G1 in feed per revolution (G95) without a spindle speed (S)"},
    {"G93 G1 X1 F1\nX2\n", 2, 1, "G1 without F in inverse time mode (G93)"},
    {"G93 G1 X1 F0\n", 1, 11, "F must be greater than 0 in inverse time mode (G93)"},
    {"F9 G2 X1\n", 1, 4, "an arc needs a centre (I, J, K) or a radius (R)"},
    {"F9 G2 I1 R1 X1\n", 1, 10, "an arc has either a radius (R) or a centre (I, J, K), not both"},
    {"F9 G2 Z1 R1\n", 1, 10, "an arc with a radius (R) needs X or Y"},
    {"F9 G2 X0 R1\n", 1, 10,
     "an arc with a radius (R) must not end at its start; for a full circle, give the centre (I, J, K)"},
    {"F9 G2 X10 R4.99\n", 1, 11, "the radius of 4.99 mm is too small to reach the end of the arc"},
    {"F9 G2 X1 I0\n", 1, 4, "the radius of the arc is 0: 0 mm at its start, 1 mm at its end"},
    {"F9 G2 X10.03 I5\n", 1, 4, "the radius of the arc is 5 mm at its start and 5.03 mm at its end"},
    {"F9 G2 X200.2 I100\n", 1, 4, "the radius of the arc is 100 mm at its start and 100.2 mm at its end"},
    {"F9 G2 X20002.9 I10000\n", 1, 4, "the radius of the arc is 10000 mm at its start and 10002.9 mm at its end"},
    {"F9 G2 X1 I.5 K1\n", 1, 14, "K does not belong to the centre of an arc in the plane of G17"},
    {"G18 F9 G2 X1 I.5 J1\n", 1, 18, "J does not belong to the centre of an arc in the plane of G18"},
    {"G90.1 F9 G2 X10 I5\n", 1, 10, "an arc with an absolute centre (G90.1) needs both centre words; J is missing"},
    {"F9 G2 X1 I.5 P0\n", 1, 14, "P0 must be a whole number from 1 to 2147483647"},
    {"F9 G2 X1 I.5 P1.2\n", 1, 14, "P1.2 must be a whole number from 1 to 2147483647"},
};

static const struct bad with_setup[] = {
    {"T3 M6\n", 1, 1, "the setup defines no tool T3: add <tool number=\"3\" length=\"\"/> with its shape"},
    {"G55\n", 1, 1, "the setup defines no work offset G55: add <work_offset name=\"G55\" X=\"\" Y=\"\" Z=\"\"/> with its values"},
    {"G10 L2 P2 X5\nG55\nG59.3\n", 3, 1,
     "the setup defines no work offset G59.3: add <work_offset name=\"G59.3\" X=\"\" Y=\"\" Z=\"\"/> with its values"},
    {"T3\nM6\n", 2, 1, "the setup defines no tool T3: add <tool number=\"3\" length=\"\"/> with its shape"},
    {"G43 H7\n", 1, 5,
     "the setup defines no length offset H7: add <offset number=\"7\" length=\"\"/> with its value, or a <tool> with "
     "this number"},
};

static const struct bad fanuc[] = {
    /* Fanuc B-64484EN, program configuration: program numbers, end of block. */
    {"O X5\n", 1, 1, "O without a number"},
    {"O1.5\n", 1, 1, "a program number must be a whole number that is not negative"},
    {":X1\n", 1, 1, "':' without a number"},
    {"G0 O1\n", 1, 4, "O is allowed only at the start of a block"},
    {"G0 X1. ; X5.\n", 1, 8,
     "';' ends a block on this control; write the rest on a line of its own, or in parentheses if it is a comment; if "
     "a parameter makes ';' start a comment, set semicolon=\"comment\" in the machine file's <controller>"},
    /* The same, "Additional workpiece coordinate systems": P goes with G54 and G54.1 only. */
    {"G55 P3\n", 1, 5, "no code in the block uses the word P"},
    {"G59.1\n", 1, 1,
     "G59.1 is not a G-code of the fanuc dialect; if the machine builder made it, set <macro code=\"\"/> in the "
     "machine file's <controller>"},
    /* "Reference position return (G28)": the axes that return are named. */
    {"G28\n", 1, 1, "G28 without an axis word"},
    {"G0 G43 Z1.\n", 1, 4, "G43 needs H, and no earlier block has one"},
    /* "Programmable parameter input (G10 L50)", "Changing workpiece coordinate system": P0 is the external offset. */
    {"G11\nG10 L50\n", 2, 1,
     "G10 L50 changes parameters of the control, which are not supported; check a copy of the program without the "
     "blocks from G10 to G11"},
    {"G10 L3\n", 1, 1,
     "G10 L3 changes the tool life data of the control, which is not supported; check a copy of the program without "
     "the blocks from G10 to G11"},
    {"G10 L2 P0 X1.\n", 1, 11,
     "G10 L2 P0 with values other than 0 shifts all work offsets, which is not supported: write the sum into each of "
     "them by P1 to P6"},
    {"G52 X1.\nG10 L2 P0 X0\n", 2, 8, "G10 L2 P0 while G52 is active is not supported"},
    /* "Setting a workpiece coordinate system (G92)", "Local coordinate system (G52)". */
    {"G91 G92 X1.\n", 1, 5, "G92 in incremental mode (G91) is not supported"},
    {"G91 G52 X1.\n", 1, 5, "G52 in incremental mode (G91) is not supported"},
    {"G92 X1.\nG52 X1.\n", 2, 1, "G52 while G92 is active is not supported"},
    /* "Dwell (G04)". */
    {"G4 X1. P5\n", 1, 1, "G4 needs its time in one word, X, U or P"},
    {"G4 Y1.\n", 1, 1, "G4 needs its time in one word, X, U or P"},
    {"G4 X1. G0\n", 1, 8, "G4 needs a block without motion"},
    {"F9. G2 X1. I.5 P2\n", 1, 16, "no code in the block uses the word P"},
};

START_TEST(text)
{
	expect_bad(&texts[_i], &dialect_linuxcnc, false);
}
END_TEST

START_TEST(code)
{
	expect_bad(&codes[_i], &dialect_linuxcnc, false);
}
END_TEST

START_TEST(block)
{
	expect_bad(&blocks[_i], &dialect_linuxcnc, false);
}
END_TEST

START_TEST(motion)
{
	expect_bad(&motions[_i], &dialect_linuxcnc, false);
}
END_TEST

START_TEST(setup)
{
	expect_bad(&with_setup[_i], &dialect_linuxcnc, true);
}
END_TEST

START_TEST(in_fanuc)
{
	expect_bad(&fanuc[_i], &dialect_fanuc, false);
}
END_TEST

START_TEST(in_haas)
{
	static const struct bad bad[] = {
	    {"G143\n", 1, 1, "G143: 5-axis tool length compensation is not supported; post the program without it"},
	    {"M97 P10\n", 1, 5, "the program has no block N10"},
	};

	for (size_t i = 0; i < COUNT(bad); i++)
		expect_bad(&bad[i], &dialect_haas, false);
}
END_TEST

START_TEST(wrapped_position_beyond_a_turn)
{
	struct gcode_case c;

	case_init(&c);
	c.config.wrap[SLOT_A] = WRAP_SIGN;
	ck_assert(!case_run(&c, "G0 A360\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:1:4: error: A360: the absolute position of a wrapped axis must be between -360 and 360 "
			 "degrees\n    G0 A360\n       ^\n");
	case_release(&c);
	case_init(&c);
	/* Fanuc B-63534EN, "Rotary axis roll-over": whole turns of the programmed value are left out. */
	c.config.wrap[SLOT_A] = WRAP_SIGN;
	c.config.dialect = &dialect_fanuc;
	case_expect(&c, "G0 A-370.\nM30\n", "rapid 0 0 0 -350 0\n");
}
END_TEST

/* In LinuxCNC these moves would be moves of the tool point. */
START_TEST(machine_axes_under_switched_kinematics)
{
	static const char *const blocks_of_axes[] = {"G53 G0 X1", "G28", "G30 X1", "G28.1"};
	const struct mcode mcode = {428, MCODE_TCP_ON};

	for (size_t i = 0; i < COUNT(blocks_of_axes); i++) {
		struct strbuf program = {0};
		struct gcode_case c;

		case_init(&c);
		c.config.controller.mcodes = &mcode;
		c.config.controller.mcode_count = 1;
		strbuf_addf(&program, "M428\n%s\n", blocks_of_axes[i]);
		ck_assert(!case_run(&c, program.text));
		ck_assert_ptr_nonnull(
		    strstr(strbuf_text(&c.messages),
			   "p.nc:2:1: error: while an M-code has TCP on, this control takes machine coordinates as "
			   "those of the tool point; cancel TCP first\n"));
		strbuf_release(&program);
		case_release(&c);
	}
}
END_TEST

#define LOOP(test, cases) tcase_add_loop_test(tcase, test, 0, COUNT(cases))

int main(void)
{
	TCase *tcase = tcase_create("gcode_bad");

	LOOP(text, texts);
	LOOP(code, codes);
	LOOP(block, blocks);
	LOOP(motion, motions);
	LOOP(setup, with_setup);
	LOOP(in_fanuc, fanuc);
	tcase_add_test(tcase, in_haas);
	tcase_add_test(tcase, wrapped_position_beyond_a_turn);
	tcase_add_test(tcase, machine_axes_under_switched_kinematics);
	return run_suite("gcode_bad", tcase);
}
