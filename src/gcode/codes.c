#include "gcode/codes.h"

#include <stddef.h>

enum {
	L = 1 << GCODE_LINUXCNC,
	F = 1 << GCODE_FANUC,
	H = 1 << GCODE_HAAS,
	ALL = L | F | H,
	NO = GROUP_UNSUPPORTED,
	MACRO = GROUP_STATEMENT,
	IDLE = GROUP_HARMLESS
};

/*
 * Sorted by number. LinuxCNC's manual, "G-Codes"; Fanuc 30i-B operator's
 * manual (B-64484EN), preparatory function; Haas mill operator's manual, G-codes.
 */
static const struct code g_codes[] = {
	{G0, ALL, G_MOTION, NULL},
	{G1, ALL, G_MOTION, NULL},
	{G2, ALL, G_MOTION, NULL},
	{G3, ALL, G_MOTION, NULL},
	{G4, ALL, G_NONMODAL, NULL},
	{50, L, NO, "cubic spline"},
	{G5, F, G_CONTOUR, NULL},
	{51, L, NO, "quadratic spline"},
	{G5_1, F, G_CONTOUR, NULL},
	{52, L, NO, "NURBS block"},
	{53, L, NO, "NURBS block"},
	{60, L, NO, "NURBS block"},
	{61, L, NO, "NURBS block"},
	{62, L, NO, "NURBS block"},
	{62, F, NO, "NURBS interpolation"},
	{63, L, NO, "NURBS block"},
	{70, L, NO, "lathe diameter mode"},
	{71, F, NO, "cylindrical interpolation"},
	{80, L, NO, "lathe radius mode"},
	{G8, F, G_CONTOUR, NULL},
	{90, F | H, NO, "exact stop in one block"},
	{G10, ALL, G_NONMODAL, NULL},
	{120, H, NO, "circular pocket milling"},
	{130, H, NO, "circular pocket milling"},
	/* G15, G50, G50.1, G100 take back what is an error where it is switched on. */
	{150, F, IDLE, NULL},
	{160, F, NO, "polar coordinate command"},
	{G17, ALL, G_PLANE, NULL},
	{171, L, NO, "arc plane of U V W"},
	{G18, ALL, G_PLANE, NULL},
	{181, L, NO, "arc plane of U V W"},
	{G19, ALL, G_PLANE, NULL},
	{191, L, NO, "arc plane of U V W"},
	{G20, ALL, G_UNITS, NULL},
	{G21, ALL, G_UNITS, NULL},
	{270, F, NO, "reference position check"},
	{G28, ALL, G_NONMODAL, NULL},
	{G28_1, L, G_NONMODAL, NULL},
	{290, F | H, NO, "return from the reference position"},
	{G30, ALL, G_NONMODAL, NULL},
	{G30_1, L, G_NONMODAL, NULL},
	{310, F | H, NO, "skip function"},
	{G33, L, G_MOTION, NULL},
	{G33, F, NO, "thread cutting"},
	{G33_1, L, G_MOTION, NULL},
	{350, H, NO, "tool diameter measurement"},
	{360, H, NO, "work offset measurement"},
	{370, F | H, NO, "tool offset measurement"},
	{G38_2, L, G_MOTION, NULL},
	{G38_3, L, G_MOTION, NULL},
	{G38_4, L, G_MOTION, NULL},
	{G38_5, L, G_MOTION, NULL},
	{G40, ALL, G_CUTTER, NULL},
	{G41, L, G_CUTTER, NULL},
	{G41, F | H, NO, "cutter compensation"},
	{G41_1, L, G_CUTTER, NULL},
	{G42, L, G_CUTTER, NULL},
	{G42, F | H, NO, "cutter compensation"},
	{G42_1, L, G_CUTTER, NULL},
	{G43, ALL, G_LENGTH, NULL},
	{431, L, NO, "dynamic tool length offset"},
	{431, F, NO, "tool length compensation in the tool axis direction"},
	{432, L, NO, "additional tool length offset"},
	{G43_4, ALL, G_LENGTH, NULL},
	{435, ALL, NO, "tool centre point control with tool vectors"},
	{440, F | H, NO, "negative tool length compensation"},
	{470, H, NO, "text engraving"},
	{G49, ALL, G_LENGTH, NULL},
	{500, F | H, IDLE, NULL},
	{501, F, IDLE, NULL},
	{510, F | H, NO, "scaling"},
	{511, F, NO, "mirror image"},
	{G52, ALL, G_NONMODAL, NULL},
	{G53, ALL, G_NONMODAL, NULL},
	{G53_1, F, G_NONMODAL, NULL},
	{G53_1, H, NO, "tool axis direction control"},
	{536, F, NO, "tool axis direction control that keeps the tool centre point"},
	{G54, ALL, G_SYSTEM, NULL},
	{G54_1, F | H, G_SYSTEM, NULL},
	{542, F, NO, "rotary table dynamic fixture offset"},
	{544, F, NO, "work setting error compensation"},
	{550, ALL, G_SYSTEM, NULL},
	{560, ALL, G_SYSTEM, NULL},
	{570, ALL, G_SYSTEM, NULL},
	{580, ALL, G_SYSTEM, NULL},
	{G59, ALL, G_SYSTEM, NULL},
	{591, L, G_SYSTEM, NULL},
	{592, L, G_SYSTEM, NULL},
	{593, L, G_SYSTEM, NULL},
	{600, F | H, NO, "unidirectional positioning"},
	{G61, ALL, G_PATH, NULL},
	{G61_1, L, G_PATH, NULL},
	{620, F, NO, "automatic corner override"},
	{630, F, NO, "tapping mode"},
	{G64, ALL, G_PATH, NULL},
	{650, F | H, MACRO, NULL},
	{660, F, MACRO, NULL},
	{661, F, NO, "modal macro call at every block"},
	{670, F, MACRO, NULL},
	{G68, F | H, G_ROTATION, NULL},
	{G68_2, F, G_ROTATION, NULL},
	{G68_2, H, NO, "tilted working plane"},
	{683, F, NO, "tilted working plane by the direction of the tool"},
	{684, F, NO, "tilted working plane on a tilted plane"},
	{G69, F | H, G_ROTATION, NULL},
	{700, L | H, NO, "lathe finishing or bolt circle cycle"},
	{710, L | H, NO, "lathe roughing or bolt arc cycle"},
	{711, L, NO, "lathe roughing cycle"},
	{712, L, NO, "lathe roughing cycle"},
	{720, L | H, NO, "lathe facing or bolt line cycle"},
	{721, L, NO, "lathe facing cycle"},
	{722, L, NO, "lathe facing cycle"},
	{G73, ALL, G_MOTION, NULL},
	{G74, ALL, G_MOTION, NULL},
	{760, L, NO, "multi-pass threading cycle"},
	{760, F | H, NO, "fine boring cycle with a shift in the hole"},
	{770, H, NO, "back boring cycle"},
	{G80, ALL, G_MOTION, NULL},
	{G81, ALL, G_MOTION, NULL},
	{G82, ALL, G_MOTION, NULL},
	{G83, ALL, G_MOTION, NULL},
	{G84, ALL, G_MOTION, NULL},
	{G85, ALL, G_MOTION, NULL},
	{G86, ALL, G_MOTION, NULL},
	{G87, L, G_MOTION, NULL},
	{G87, F | H, NO, "back boring cycle"},
	{880, ALL, NO, "boring cycle in which the operator retracts the tool by hand"},
	{G89, ALL, G_MOTION, NULL},
	{G90, ALL, G_DISTANCE, NULL},
	{G90_1, L, G_ARC_DISTANCE, NULL},
	{G91, ALL, G_DISTANCE, NULL},
	{911, L, G_ARC_DISTANCE, NULL},
	{G92, ALL, G_NONMODAL, NULL},
	{G92_1, L, G_NONMODAL, NULL},
	{G92_1, F, NO, "workpiece coordinate system preset"},
	{G92_2, L, G_NONMODAL, NULL},
	{G92_3, L, G_NONMODAL, NULL},
	{G93, ALL, G_FEED_MODE, NULL},
	{G94, ALL, G_FEED_MODE, NULL},
	{G95, ALL, G_FEED_MODE, NULL},
	{G96, L, G_SPINDLE, NULL},
	{G96, F, NO, "constant surface speed"},
	{970, L | F, G_SPINDLE, NULL},	/* the mode that is always in force here */
	{G98, ALL, G_RETRACT, NULL},
	{G99, ALL, G_RETRACT, NULL},
	{1000, H, IDLE, NULL},
	{1010, H, NO, "mirror image"},
	{G103, H, G_CONTOUR, NULL},
	{1100, H, G_SYSTEM, NULL},
	{1110, H, G_SYSTEM, NULL},
	{1120, H, G_SYSTEM, NULL},
	{1130, H, G_SYSTEM, NULL},
	{1140, H, G_SYSTEM, NULL},
	{1150, H, G_SYSTEM, NULL},
	{1160, H, G_SYSTEM, NULL},
	{1170, H, G_SYSTEM, NULL},
	{1180, H, G_SYSTEM, NULL},
	{1190, H, G_SYSTEM, NULL},
	{1200, H, G_SYSTEM, NULL},
	{1210, H, G_SYSTEM, NULL},
	{1220, H, G_SYSTEM, NULL},
	{1230, H, G_SYSTEM, NULL},
	{1240, H, G_SYSTEM, NULL},
	{1250, H, G_SYSTEM, NULL},
	{1260, H, G_SYSTEM, NULL},
	{1270, H, G_SYSTEM, NULL},
	{1280, H, G_SYSTEM, NULL},
	{1290, H, G_SYSTEM, NULL},
	{1360, H, NO, "work offset centre measurement"},
	{1410, H, NO, "3D cutter compensation"},
	{1430, H, NO, "5-axis tool length compensation"},
	{1500, H, NO, "pocket milling"},
	{G154, H, G_SYSTEM, NULL},
	{G187, H, G_CONTOUR, NULL},
	{G234, H, G_LENGTH, NULL},
	{2530, H, NO, "spindle orientation to the feature coordinates"},
	{G254, H, G_DYNAMIC, NULL},
	{G255, H, G_DYNAMIC, NULL},
	{2680, H, NO, "feature coordinate system"},
	{2690, H, NO, "cancelling of the feature coordinate system"},
};

static const struct code m_codes[] = {
	{0, ALL, M_STOP, NULL},
	{1, ALL, M_STOP, NULL},
	{2, ALL, M_STOP, NULL},
	{3, ALL, M_SPINDLE, NULL},
	{4, ALL, M_SPINDLE, NULL},
	{5, ALL, M_SPINDLE, NULL},
	{6, ALL, M_TOOL, NULL},
	{7, ALL, M_COOLANT, NULL},
	{8, ALL, M_COOLANT, NULL},
	{9, ALL, M_COOLANT, NULL},
	/* Haas mill operator's manual, M-codes: brakes of the rotary axes. */
	{10, H, IDLE, NULL},
	{11, H, IDLE, NULL},
	{12, H, IDLE, NULL},
	{13, H, IDLE, NULL},
	{19, ALL, NO, "spindle orientation"},
	/* B-63944EN, rigid tapping: M29, unless parameter 5210 gives it another number. */
	{29, F, IDLE, NULL},
	{30, ALL, M_STOP, NULL},
	/* Haas: chip conveyor, gears; further on the air jet (M83, M84) and coolant through the spindle (M88, M89). */
	{31, H, IDLE, NULL},
	{33, H, IDLE, NULL},
	{34, H, NO, "move of the coolant nozzle"},
	{35, H, NO, "move of the coolant nozzle"},
	{41, H, IDLE, NULL},
	{42, H, IDLE, NULL},
	/* LinuxCNC's manual, "M-Codes": overrides and outputs touch speeds and wires, no axis. */
	{48, L, M_OVERRIDE, NULL},
	{49, L, M_OVERRIDE, NULL},
	{50, L, M_OVERRIDE, NULL},
	{50, H, NO, "pallet change"},
	{51, L, M_OVERRIDE, NULL},
	{52, L, M_OVERRIDE, NULL},
	{53, L, M_OVERRIDE, NULL},
	{60, ALL, NO, "pallet change"},
	{61, L, NO, "setting of the current tool number"},
	{62, L, M_OUTPUT, NULL},
	{63, L, M_OUTPUT, NULL},
	{64, L, M_OUTPUT, NULL},
	{65, L, M_OUTPUT, NULL},
	{66, L, NO, "waiting for an input"},
	{67, L, M_OUTPUT, NULL},
	{68, L, M_OUTPUT, NULL},
	{70, L, NO, "saving of the modal state"},
	{71, L, NO, "saving of the modal state"},
	{72, L, NO, "restoring of the modal state"},
	{73, L, NO, "saving of the modal state"},
	{83, H, IDLE, NULL},
	{84, H, IDLE, NULL},
	{88, H, IDLE, NULL},
	{89, H, IDLE, NULL},
	{96, H, NO, "jump on an input"},
	{97, H, M_STOP, NULL},
	{98, F | H, M_STOP, NULL},
	{99, ALL, M_STOP, NULL},
	{138, H, IDLE, NULL},	/* and M139: the spindle's speed varies */
	{139, H, IDLE, NULL},
	{198, F, NO, "subprogram call from another memory"},
};

/* Binary search for the number, then the row of the dialect among its few rows. */
static const struct code *find(const struct code *codes, size_t count, int number, enum gcode_dialect dialect)
{
	size_t low = 0, high = count;

	while (low < high) {
		size_t middle = (low + high) / 2;

		if (codes[middle].number < number)
			low = middle + 1;
		else
			high = middle;
	}
	for (; low < count && codes[low].number == number; low++) {
		if (codes[low].dialects & (1 << dialect))
			return &codes[low];
	}
	return NULL;
}

const struct code *code_find_g(int number, enum gcode_dialect dialect)
{
	return find(g_codes, sizeof(g_codes) / sizeof(*g_codes), number, dialect);
}

const struct code *code_find_m(int number, enum gcode_dialect dialect)
{
	return find(m_codes, sizeof(m_codes) / sizeof(*m_codes), number, dialect);
}

bool code_is_cycle(int number)
{
	return number == G73 || number == G74 || (number >= G81 && number <= G89);
}

const char *dialect_name(enum gcode_dialect dialect)
{
	static const char *const names[] = {"linuxcnc", "fanuc", "haas"};

	return names[dialect];
}
