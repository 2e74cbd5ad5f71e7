#include "gcode/dialect/sinumerik/sinumerik_codes.h"

#include <string.h>

/*
 * 840D sl, "G group list" and "List of statements". ROW(word, kind, group, code, state, what). The order is that of
 * the manual's chapters.
 */
#define CODE_ROW(ROW, word, group, code, what) ROW(word, CODE, group, code, CODE_READ, what)
#define ADDRESS_ROW(ROW, word, address, what) ROW(word, ADDRESS, MOTION, SINUMERIK_##address, CODE_READ, what)
#define PLAIN_ROW(ROW, word, kind, what) ROW(word, kind, MOTION, 0, CODE_IGNORED, what)
#define REFUSED_ROW(ROW, word, what) ROW(word, REFUSED, MOTION, 0, CODE_REFUSED, what)

#define MOTION_WORDS(ROW) \
	CODE_ROW(ROW, "CIP", MOTION, SINUMERIK_CIP, "circle through an intermediate point") \
	ADDRESS_ROW(ROW, "CR", CR, "radius of a circle") \
	ADDRESS_ROW(ROW, "AR", AR, "opening angle of a circle") \
	ADDRESS_ROW(ROW, "TURN", TURN, "full turns of a helix") \
	ADDRESS_ROW(ROW, "I1", I1, "intermediate point of CIP") \
	ADDRESS_ROW(ROW, "J1", J1, "intermediate point of CIP") \
	ADDRESS_ROW(ROW, "K1", K1, "intermediate point of CIP") \
	CODE_ROW(ROW, "SUPA", SUPPRESSION, SINUMERIK_SUPA, "positions of the machine's axes, for its block") \
	ADDRESS_ROW(ROW, "FP", FP, "fixed point of G75") \
	REFUSED_ROW(ROW, "CT", "circle with tangential transition") \
	REFUSED_ROW(ROW, "INVCW", "involute interpolation") \
	REFUSED_ROW(ROW, "INVCCW", "involute interpolation") \
	REFUSED_ROW(ROW, "ASPLINE", "spline interpolation") \
	REFUSED_ROW(ROW, "BSPLINE", "spline interpolation") \
	REFUSED_ROW(ROW, "CSPLINE", "spline interpolation") \
	REFUSED_ROW(ROW, "POLY", "polynomial interpolation") \
	REFUSED_ROW(ROW, "OEMIPO1", "interpolation of the machine's maker") \
	REFUSED_ROW(ROW, "OEMIPO2", "interpolation of the machine's maker") \
	ADDRESS_ROW(ROW, "AP", AP, "polar coordinates: angle") \
	ADDRESS_ROW(ROW, "RP", RP, "polar coordinates: radius") \
	REFUSED_ROW(ROW, "ANG", "contour by an angle") \
	ADDRESS_ROW(ROW, "CHF", CHF, "chamfer by its length") \
	ADDRESS_ROW(ROW, "CHR", CHR, "chamfer by what it takes off each block") \
	ADDRESS_ROW(ROW, "RND", RND, "rounding between two blocks") \
	REFUSED_ROW(ROW, "RNDM", "rounding between blocks") \
	REFUSED_ROW(ROW, "POS", "positioning axis") \
	REFUSED_ROW(ROW, "POSA", "positioning axis") \
	REFUSED_ROW(ROW, "POSP", "positioning axis") \
	REFUSED_ROW(ROW, "MEAS", "measuring with a probe") \
	REFUSED_ROW(ROW, "MEAW", "measuring with a probe") \
	REFUSED_ROW(ROW, "MEASA", "measuring with a probe") \
	REFUSED_ROW(ROW, "FXS", "travel to a fixed stop") \
	REFUSED_ROW(ROW, "REPOS", "repositioning") \
	REFUSED_ROW(ROW, "RTLIOF", "rapids in which each axis goes at its own rate")

#define FRAME_WORD(ROW, word, number, what) ROW(word, CODE, FRAME, SINUMERIK_FRAME_CODES + (number), CODE_READ, what)
#define FRAME_WORDS(ROW) \
	FRAME_WORD(ROW, "TRANS", 0, "shift of the program's coordinates") \
	FRAME_WORD(ROW, "ATRANS", 1, "shift, added") \
	FRAME_WORD(ROW, "ROT", 2, "turning of the program's coordinates") \
	FRAME_WORD(ROW, "AROT", 3, "turning, added") \
	FRAME_WORD(ROW, "SCALE", 4, "scaling of the program's coordinates") \
	FRAME_WORD(ROW, "ASCALE", 5, "scaling, added") \
	FRAME_WORD(ROW, "MIRROR", 6, "mirroring of the program's coordinates") \
	FRAME_WORD(ROW, "AMIRROR", 7, "mirroring, added") \
	ADDRESS_ROW(ROW, "RPL", RPL, "angle of ROT in the plane") \
	REFUSED_ROW(ROW, "ROTS", "turning by solid angles") \
	REFUSED_ROW(ROW, "AROTS", "turning by solid angles") \
	REFUSED_ROW(ROW, "CROTS", "turning by solid angles") \
	REFUSED_ROW(ROW, "TOFRAME", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "TOFRAMEZ", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "TOROT", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "TOROTZ", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "PAROT", "frame that turns with the table") \
	REFUSED_ROW(ROW, "TCARR", "orientable tool carrier") \
	PLAIN_ROW(ROW, "TOFRAMEOF", IGNORED, "no frame in the direction of the tool") \
	PLAIN_ROW(ROW, "TOROTOF", IGNORED, "no frame in the direction of the tool") \
	PLAIN_ROW(ROW, "PAROTOF", IGNORED, "no frame that turns with the table")

#define FIVE_AXIS_WORDS(ROW) \
	CODE_ROW(ROW, "TRAORI", TRANSFORM, SINUMERIK_TRAORI, "five-axis transformation") \
	CODE_ROW(ROW, "TRAFOOF", TRANSFORM, SINUMERIK_TRAFOOF, "no transformation") \
	CODE_ROW(ROW, "ORIWKS", ORI_SYSTEM, SINUMERIK_ORIWKS, "orientation in the workpiece") \
	CODE_ROW(ROW, "ORIMKS", ORI_SYSTEM, SINUMERIK_ORIMKS, "orientation in the machine") \
	CODE_ROW(ROW, "ORIAXES", ORI_WAY, SINUMERIK_ORIAXES, "orientation by linear axes") \
	CODE_ROW(ROW, "ORIVECT", ORI_WAY, SINUMERIK_ORIVECT, "orientation on a great circle") \
	CODE_ROW(ROW, "ORIPLANE", ORI_WAY, SINUMERIK_ORIVECT, "orientation on a great circle") \
	ADDRESS_ROW(ROW, "A3", A3, "direction of the tool") \
	ADDRESS_ROW(ROW, "B3", B3, "direction of the tool") \
	ADDRESS_ROW(ROW, "C3", C3, "direction of the tool") \
	PLAIN_ROW(ROW, "ORIRPY", IGNORED, "what A2, B2 and C2 mean") \
	PLAIN_ROW(ROW, "ORIRPY2", IGNORED, "what A2, B2 and C2 mean") \
	PLAIN_ROW(ROW, "ORIEULER", IGNORED, "what A2, B2 and C2 mean") \
	CODE_ROW(ROW, "ORISOF", ORI_SMOOTHING, SINUMERIK_ORISOF, "no smoothing of the orientation") \
	CODE_ROW(ROW, "ORISON", ORI_SMOOTHING, SINUMERIK_ORISON, "smoothing of the orientation, within OTOL") \
	REFUSED_ROW(ROW, "ORIVIRT1", "virtual orientation axes") \
	REFUSED_ROW(ROW, "ORIVIRT2", "virtual orientation axes") \
	REFUSED_ROW(ROW, "ORIPATH", "orientation by the path") \
	REFUSED_ROW(ROW, "ORIPATHS", "orientation by the path") \
	REFUSED_ROW(ROW, "ORICONCW", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICONCCW", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICONIO", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICONTO", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICURVE", "orientation by a second curve") \
	REFUSED_ROW(ROW, "ORIRESET", "basic orientation of the tool") \
	REFUSED_ROW(ROW, "ORID", "smoothing of the orientation") \
	REFUSED_ROW(ROW, "A2", "orientation by angles") \
	REFUSED_ROW(ROW, "B2", "orientation by angles") \
	REFUSED_ROW(ROW, "C2", "orientation by angles") \
	REFUSED_ROW(ROW, "A4", "orientation by surface normals") \
	REFUSED_ROW(ROW, "B4", "orientation by surface normals") \
	REFUSED_ROW(ROW, "C4", "orientation by surface normals") \
	REFUSED_ROW(ROW, "A5", "orientation by surface normals") \
	REFUSED_ROW(ROW, "B5", "orientation by surface normals") \
	REFUSED_ROW(ROW, "C5", "orientation by surface normals") \
	REFUSED_ROW(ROW, "LEAD", "orientation by an angle of lead") \
	REFUSED_ROW(ROW, "TILT", "orientation by an angle of tilt") \
	REFUSED_ROW(ROW, "TRANSMIT", "milling on the face of a turning part") \
	REFUSED_ROW(ROW, "TRACYL", "milling on a cylinder") \
	REFUSED_ROW(ROW, "TRAANG", "inclined axis") \
	REFUSED_ROW(ROW, "TRACON", "chained transformation")

#define PATH_WORDS(ROW) \
	ADDRESS_ROW(ROW, "ADIS", ADIS, "rounding distance of G641") \
	ADDRESS_ROW(ROW, "ADISPOS", ADISPOS, "rounding distance of rapids") \
	ADDRESS_ROW(ROW, "CTOL", CTOL, "tolerance of the contour") \
	ADDRESS_ROW(ROW, "OTOL", OTOL, "tolerance of the orientation") \
	ADDRESS_ROW(ROW, "STOLF", STOLF, "how much larger tolerances are in rapids") \
	PLAIN_ROW(ROW, "ATOL", IGNORED_VALUE, "tolerance of an axis") \
	CODE_ROW(ROW, "COMPOF", COMPRESSOR, SINUMERIK_COMPOF, "no compressor") \
	CODE_ROW(ROW, "COMPON", COMPRESSOR, SINUMERIK_COMPON, "compressor, within the control's tolerance") \
	CODE_ROW(ROW, "COMPCURV", COMPRESSOR, SINUMERIK_COMPON, "compressor, within the control's tolerance") \
	CODE_ROW(ROW, "COMPCAD", COMPRESSOR, SINUMERIK_COMPON, "compressor, within the control's tolerance") \
	CODE_ROW(ROW, "COMPSURF", COMPRESSOR, SINUMERIK_COMPON, "compressor, within the control's tolerance") \
	PLAIN_ROW(ROW, "FFWON", IGNORED, "feedforward control") \
	PLAIN_ROW(ROW, "FFWOF", IGNORED, "no feedforward control") \
	PLAIN_ROW(ROW, "BRISK", IGNORED, "acceleration in steps") \
	PLAIN_ROW(ROW, "SOFT", IGNORED, "acceleration with limited jerk") \
	PLAIN_ROW(ROW, "DRIVE", IGNORED, "acceleration by the drive") \
	PLAIN_ROW(ROW, "BRISKA", IGNORED_CALL, "acceleration of an axis") \
	PLAIN_ROW(ROW, "SOFTA", IGNORED_CALL, "acceleration of an axis") \
	PLAIN_ROW(ROW, "DYNNORM", IGNORED, "dynamic response") \
	PLAIN_ROW(ROW, "DYNPOS", IGNORED, "dynamic response") \
	PLAIN_ROW(ROW, "DYNROUGH", IGNORED, "dynamic response") \
	PLAIN_ROW(ROW, "DYNSEMIFIN", IGNORED, "dynamic response") \
	PLAIN_ROW(ROW, "DYNFINISH", IGNORED, "dynamic response") \
	PLAIN_ROW(ROW, "DYNPREC", IGNORED, "dynamic response") \
	PLAIN_ROW(ROW, "RTLION", IGNORED, "straight rapids") \
	PLAIN_ROW(ROW, "FNORM", IGNORED, "feed profile") \
	PLAIN_ROW(ROW, "FLIN", IGNORED, "feed profile") \
	PLAIN_ROW(ROW, "FCUB", IGNORED, "feed profile") \
	PLAIN_ROW(ROW, "CFC", IGNORED, "feed at the contour") \
	PLAIN_ROW(ROW, "CFTCP", IGNORED, "feed of the tool's centre") \
	PLAIN_ROW(ROW, "CFIN", IGNORED, "feed at inside curves") \
	PLAIN_ROW(ROW, "FGROUP", IGNORED_CALL, "which axes the feed counts for") \
	PLAIN_ROW(ROW, "FGREF", IGNORED_VALUE, "reference radius of the feed") \
	PLAIN_ROW(ROW, "FL", IGNORED_VALUE, "limit of an axis' feed") \
	PLAIN_ROW(ROW, "FA", IGNORED_VALUE, "feed of a positioning axis") \
	PLAIN_ROW(ROW, "FRC", IGNORED_VALUE, "feed of a chamfer") \
	PLAIN_ROW(ROW, "FRCM", IGNORED_VALUE, "feed of chamfers") \
	PLAIN_ROW(ROW, "OVR", IGNORED_VALUE, "override") \
	PLAIN_ROW(ROW, "OVRA", IGNORED_VALUE, "override") \
	PLAIN_ROW(ROW, "ACC", IGNORED_VALUE, "acceleration") \
	PLAIN_ROW(ROW, "ACCLIMA", IGNORED_VALUE, "acceleration") \
	PLAIN_ROW(ROW, "VELOLIM", IGNORED_VALUE, "limit of velocity") \
	PLAIN_ROW(ROW, "VELOLIMA", IGNORED_VALUE, "limit of velocity") \
	PLAIN_ROW(ROW, "JERKLIM", IGNORED_VALUE, "limit of jerk") \
	PLAIN_ROW(ROW, "JERKLIMA", IGNORED_VALUE, "limit of jerk") \
	PLAIN_ROW(ROW, "UPATH", IGNORED, "parameter of the path") \
	PLAIN_ROW(ROW, "SPATH", IGNORED, "parameter of the path")

#define OTHER_WORDS(ROW) \
	CODE_ROW(ROW, "NORM", APPROACH, SINUMERIK_NORM, "start of cutter compensation at right angles") \
	ROW("KONT", CODE, APPROACH, SINUMERIK_KONT, CODE_BOUNDED, "start of cutter compensation round the contour") \
	REFUSED_ROW(ROW, "KONTC", "start of cutter compensation on a curve") \
	REFUSED_ROW(ROW, "KONTT", "start of cutter compensation on a tangent") \
	CODE_ROW(ROW, "CUT2D", CUT, SINUMERIK_CUT2D, "cutter compensation in the plane") \
	CODE_ROW(ROW, "CUT2DF", CUT, SINUMERIK_CUT2DF, "cutter compensation in the plane of the frame") \
	REFUSED_ROW(ROW, "CUT3DC", "cutter compensation in space") \
	REFUSED_ROW(ROW, "CUT3DF", "cutter compensation in space") \
	REFUSED_ROW(ROW, "CUT3DFS", "cutter compensation in space") \
	REFUSED_ROW(ROW, "CUT3DFF", "cutter compensation in space") \
	REFUSED_ROW(ROW, "OFFN", "allowance of the contour") \
	PLAIN_ROW(ROW, "CDOF", IGNORED, "no watch for bottlenecks") \
	PLAIN_ROW(ROW, "CDOF2", IGNORED, "no watch for bottlenecks") \
	PLAIN_ROW(ROW, "CDON", IGNORED, "watch for bottlenecks") \
	ADDRESS_ROW(ROW, "DISC", DISC, "how far outside corners are rounded") \
	PLAIN_ROW(ROW, "DIAMOF", IGNORED, "radius programming") \
	REFUSED_ROW(ROW, "DIAMON", "diameter programming") \
	PLAIN_ROW(ROW, "WALIMON", IGNORED, "working area limits") \
	PLAIN_ROW(ROW, "WALIMOF", IGNORED, "no working area limits") \
	PLAIN_ROW(ROW, "SPOS", SPINDLE_STANDS, "spindle at an angle") \
	PLAIN_ROW(ROW, "SPOSA", SPINDLE_STANDS, "spindle at an angle") \
	PLAIN_ROW(ROW, "SPCON", IGNORED_CALL, "position control of the spindle") \
	PLAIN_ROW(ROW, "SPCOF", IGNORED_CALL, "no position control of the spindle") \
	PLAIN_ROW(ROW, "LIMS", IGNORED_VALUE, "limit of the spindle's speed") \
	PLAIN_ROW(ROW, "SVC", IGNORED_VALUE, "cutting speed") \
	PLAIN_ROW(ROW, "SETMS", IGNORED_CALL, "master spindle") \
	PLAIN_ROW(ROW, "WAITS", IGNORED_CALL, "wait for the spindle") \
	PLAIN_ROW(ROW, "STOPRE", STOPS_READING, "no reading ahead") \
	PLAIN_ROW(ROW, "STARTFIFO", IGNORED, "reading ahead") \
	PLAIN_ROW(ROW, "STOPFIFO", IGNORED, "reading ahead") \
	PLAIN_ROW(ROW, "FIFOCTRL", IGNORED, "reading ahead") \
	PLAIN_ROW(ROW, "SBLON", IGNORED, "single block") \
	PLAIN_ROW(ROW, "SBLOF", IGNORED, "no single block") \
	PLAIN_ROW(ROW, "DISPLON", IGNORED, "display") \
	PLAIN_ROW(ROW, "DISPLOF", IGNORED, "no display") \
	PLAIN_ROW(ROW, "MSG", IGNORED_CALL, "message to the operator") \
	PLAIN_ROW(ROW, "SETAL", IGNORED_CALL, "alarm") \
	PLAIN_ROW(ROW, "WORKPIECE", IGNORED_CALL, "blank of the simulation") \
	PLAIN_ROW(ROW, "GROUP_BEGIN", IGNORED_CALL, "group of blocks in the editor") \
	PLAIN_ROW(ROW, "GROUP_END", IGNORED_CALL, "group of blocks in the editor") \
	PLAIN_ROW(ROW, "EXTERN", IGNORED_LINE, "declaration of a subprogram") \
	PLAIN_ROW(ROW, "GROUP_ADDEND", IGNORED_CALL, "group of blocks in the editor") \
	PLAIN_ROW(ROW, "TOWSTD", IGNORED, "in which coordinates wear counts") \
	PLAIN_ROW(ROW, "TOWMCS", IGNORED, "in which coordinates wear counts") \
	PLAIN_ROW(ROW, "TOWWCS", IGNORED, "in which coordinates wear counts") \
	PLAIN_ROW(ROW, "TOWBCS", IGNORED, "in which coordinates wear counts") \
	PLAIN_ROW(ROW, "TOWTCS", IGNORED, "in which coordinates wear counts") \
	PLAIN_ROW(ROW, "TOWKCS", IGNORED, "in which coordinates wear counts") \
	PLAIN_ROW(ROW, "CUTCONOF", IGNORED, "no suspended cutter compensation") \
	REFUSED_ROW(ROW, "CUTCONON", "suspended cutter compensation") \
	PLAIN_ROW(ROW, "SCPARA", IGNORED_VALUE, "parameters of an axis' control") \
	PLAIN_ROW(ROW, "GET", IGNORED_CALL, "axis of another channel") \
	PLAIN_ROW(ROW, "GETD", IGNORED_CALL, "axis of another channel") \
	PLAIN_ROW(ROW, "RELEASE", IGNORED_CALL, "axis for another channel") \
	PLAIN_ROW(ROW, "WAITP", IGNORED_CALL, "wait for a positioning axis") \
	PLAIN_ROW(ROW, "WAITM", IGNORED_CALL, "wait for another channel") \
	PLAIN_ROW(ROW, "TRAILOF", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "LEADOF", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "COUPOF", IGNORED_CALL, "no coupling of spindles") \
	PLAIN_ROW(ROW, "TANGOF", IGNORED_CALL, "no axis that follows the path") \
	PLAIN_ROW(ROW, "FB", IGNORED_VALUE, "feed of the block alone") \
	PLAIN_ROW(ROW, "WRITE", IGNORED_CALL, "text to a file") \
	PLAIN_ROW(ROW, "DELDTG", IGNORED, "distance to go") \
	ROW("MCALL", MODAL, MOTION, 0, CODE_READ, "modal call of a cycle or subprogram") \
	REFUSED_ROW(ROW, "ID", "synchronous action") \
	REFUSED_ROW(ROW, "IDS", "synchronous action") \
	REFUSED_ROW(ROW, "WHEN", "synchronous action") \
	REFUSED_ROW(ROW, "WHENEVER", "synchronous action") \
	REFUSED_ROW(ROW, "EVERY", "synchronous action") \
	REFUSED_ROW(ROW, "DO", "synchronous action") \
	REFUSED_ROW(ROW, "COUPON", "coupling of spindles") \
	REFUSED_ROW(ROW, "TRAILON", "coupling of axes") \
	REFUSED_ROW(ROW, "LEADON", "coupling of axes") \
	REFUSED_ROW(ROW, "TANG", "axis that follows the path") \
	REFUSED_ROW(ROW, "PCALL", "call of a subprogram by its path") \
	REFUSED_ROW(ROW, "ISOCALL", "call of a program in ISO mode")

#define STATEMENT_ROW(ROW, word, what) ROW(word, STATEMENT, MOTION, 0, CODE_READ, what)
#define STATEMENT_WORDS(ROW) \
	STATEMENT_ROW(ROW, "IF", "condition") \
	STATEMENT_ROW(ROW, "ELSE", "condition") \
	STATEMENT_ROW(ROW, "ENDIF", "condition") \
	STATEMENT_ROW(ROW, "WHILE", "loop") \
	STATEMENT_ROW(ROW, "ENDWHILE", "loop") \
	STATEMENT_ROW(ROW, "FOR", "loop that counts") \
	STATEMENT_ROW(ROW, "ENDFOR", "loop that counts") \
	STATEMENT_ROW(ROW, "LOOP", "endless loop") \
	STATEMENT_ROW(ROW, "ENDLOOP", "endless loop") \
	STATEMENT_ROW(ROW, "REPEAT", "loop, or repeat of a part of the program") \
	STATEMENT_ROW(ROW, "REPEATB", "repeat of a block") \
	STATEMENT_ROW(ROW, "UNTIL", "loop") \
	STATEMENT_ROW(ROW, "GOTO", "jump") \
	STATEMENT_ROW(ROW, "GOTOF", "jump forward") \
	STATEMENT_ROW(ROW, "GOTOB", "jump backward") \
	STATEMENT_ROW(ROW, "GOTOS", "jump to the start of the program") \
	STATEMENT_ROW(ROW, "GOTOC", "jump that may miss its label") \
	STATEMENT_ROW(ROW, "CASE", "jump by a value") \
	STATEMENT_ROW(ROW, "DEF", "variables") \
	STATEMENT_ROW(ROW, "PROC", "head of a subprogram") \
	STATEMENT_ROW(ROW, "RET", "end of a subprogram") \
	STATEMENT_ROW(ROW, "CALL", "call of a subprogram by a text") \
	STATEMENT_ROW(ROW, "EXTCALL", "call of a subprogram by a text")

#define WORDS(ROW) \
	STATEMENT_WORDS(ROW) MOTION_WORDS(ROW) FRAME_WORDS(ROW) FIVE_AXIS_WORDS(ROW) PATH_WORDS(ROW) OTHER_WORDS(ROW)

#define AS_PEOPLE_READ(word, kind, group, code, state, what) {word, state, what},
#define AS_CODE(word, kind, group, code, state, what) {SINUMERIK_WORD_##kind, SINUMERIK_##group, code, what},

static const struct code_word word_rows[] = {WORDS(AS_PEOPLE_READ)};
static const struct sinumerik_word words[] = {WORDS(AS_CODE)};

const struct word_set sinumerik_word_set = {word_rows, sizeof(word_rows) / sizeof(word_rows[0])};

/* sinumerik_cycle.h and sinumerik_swivel.h carry them out. */
static const struct code_word cycle_rows[] = {
	{"CYCLE81", CODE_READ, "drilling"},
	{"CYCLE82", CODE_READ, "drilling with dwell"},
	{"CYCLE83", CODE_READ, "deep hole drilling"},
	{"CYCLE84", CODE_READ, "rigid tapping"},
	{"CYCLE840", CODE_READ, "tapping with compensating chuck"},
	{"CYCLE85", CODE_READ, "reaming"},
	{"CYCLE86", CODE_READ, "boring with oriented spindle stop"},
	{"CYCLE87", CODE_READ, "boring with stop"},
	{"CYCLE88", CODE_READ, "boring with dwell and stop"},
	{"CYCLE89", CODE_READ, "boring, feed out"},
	{"HOLES1", CODE_READ, "row of holes"},
	{"HOLES2", CODE_READ, "circle of holes"},
	{"CYCLE801", CODE_READ, "grid of holes"},
	{"CYCLE802", CODE_READ, "holes at given positions"},
	{"CYCLE800", CODE_READ, "swivelled plane, axis by axis or by solid angles"},
	{"CYCLE832", CODE_READ, "tolerance of the contour"},
	{"POCKET1 to POCKET4", CODE_BOUNDED, "milling of a pocket"},
	{"SLOT1, SLOT2", CODE_BOUNDED, "milling of slots"},
	{"LONGHOLE", CODE_BOUNDED, "milling of long holes"},
	{"CYCLE61, CYCLE71", CODE_BOUNDED, "milling of a face"},
	{"CYCLE70, CYCLE90", CODE_BOUNDED, "milling of a thread, from within"},
	{"CYCLE60", CODE_REFUSED, "engraving"},
	{"CYCLE62 to CYCLE64, CYCLE72", CODE_REFUSED, "milling of contours"},
	{"CYCLE76, CYCLE77, CYCLE79", CODE_REFUSED, "milling round a spigot"},
	{"CYCLE78", CODE_REFUSED, "drilling and milling of a thread"},
	{"CYCLE899", CODE_REFUSED, "milling of a slot"},
	{"CYCLE9..", CODE_REFUSED, "turning or measuring"},
};

const struct word_set sinumerik_cycle_set = {cycle_rows, sizeof(cycle_rows) / sizeof(cycle_rows[0])};

bool sinumerik_codes_word(const char *name, struct sinumerik_word *word)
{
	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++) {
		if (word_rows[i].word[0] == name[0] && !strcmp(word_rows[i].word, name)) {
			*word = words[i];
			return true;
		}
	}
	return false;
}

/* The numbers of the two tables that follow are G-codes in tenths, and M-codes. */
static const struct code g_rows[] = {
	{SINUMERIK_G(0), SINUMERIK_MOTION, CODE_READ, "rapid"},
	{SINUMERIK_G(1), SINUMERIK_MOTION, CODE_READ, "straight line"},
	{SINUMERIK_G(2), SINUMERIK_MOTION, CODE_READ, "circle or helix, clockwise"},
	{SINUMERIK_G(3), SINUMERIK_MOTION, CODE_READ, "circle or helix, counter-clockwise"},
	{SINUMERIK_G(4), SINUMERIK_ONCE, CODE_READ, "dwell"},
	{SINUMERIK_G(5), GROUP_NONE, CODE_REFUSED, "plunge-cut grinding"},
	{SINUMERIK_G(7), GROUP_NONE, CODE_REFUSED, "compensation of plunge-cut grinding"},
	{SINUMERIK_G(9), GROUP_NONE, CODE_IGNORED, "exact stop, for its block"},
	{SINUMERIK_G(17), SINUMERIK_PLANE, CODE_READ, "plane XY"},
	{SINUMERIK_G(18), SINUMERIK_PLANE, CODE_READ, "plane ZX"},
	{SINUMERIK_G(19), SINUMERIK_PLANE, CODE_READ, "plane YZ"},
	{SINUMERIK_G(25), SINUMERIK_ONCE, CODE_IGNORED, "lower limit of the working area or of the spindle"},
	{SINUMERIK_G(26), SINUMERIK_ONCE, CODE_IGNORED, "upper limit of the working area or of the spindle"},
	{SINUMERIK_G(33), SINUMERIK_MOTION, CODE_READ, "thread cutting with a constant pitch"},
	{SINUMERIK_G(34), GROUP_NONE, CODE_REFUSED, "thread cutting with a pitch that changes"},
	{SINUMERIK_G(35), GROUP_NONE, CODE_REFUSED, "thread cutting with a pitch that changes"},
	{SINUMERIK_G(40), SINUMERIK_CUTTER, CODE_READ, "no cutter compensation"},
	{SINUMERIK_G(41), SINUMERIK_CUTTER, CODE_READ, "cutter compensation, left of the path"},
	{SINUMERIK_G(42), SINUMERIK_CUTTER, CODE_READ, "cutter compensation, right of the path"},
	{SINUMERIK_G(53), SINUMERIK_SUPPRESSION, CODE_READ, "without work offset and frames, for its block"},
	{SINUMERIK_G(54), SINUMERIK_SYSTEM, CODE_READ, "work offset 1"},
	{SINUMERIK_G(55), SINUMERIK_SYSTEM, CODE_READ, "work offset 2"},
	{SINUMERIK_G(56), SINUMERIK_SYSTEM, CODE_READ, "work offset 3"},
	{SINUMERIK_G(57), SINUMERIK_SYSTEM, CODE_READ, "work offset 4"},
	{SINUMERIK_G(58), GROUP_NONE, CODE_REFUSED, "axial shift of the programmable frame"},
	{SINUMERIK_G(59), GROUP_NONE, CODE_REFUSED, "axial shift of the programmable frame"},
	{SINUMERIK_G(60), SINUMERIK_PATH, CODE_READ, "exact stop"},
	{SINUMERIK_G(62), GROUP_NONE, CODE_IGNORED, "slower at inside corners"},
	{SINUMERIK_G(63), SINUMERIK_ONCE, CODE_READ, "tapping with a compensating chuck"},
	{SINUMERIK_G(64), SINUMERIK_PATH, CODE_READ, "continuous path"},
	{SINUMERIK_G(70), SINUMERIK_UNITS, CODE_READ, "lengths in inches"},
	{SINUMERIK_G(71), SINUMERIK_UNITS, CODE_READ, "lengths in mm"},
	{SINUMERIK_G(74), SINUMERIK_ONCE, CODE_READ, "to the reference point"},
	{SINUMERIK_G(75), SINUMERIK_ONCE, CODE_READ, "to a fixed point"},
	{SINUMERIK_G(90), SINUMERIK_DISTANCE, CODE_READ, "absolute coordinates"},
	{SINUMERIK_G(91), SINUMERIK_DISTANCE, CODE_READ, "incremental coordinates"},
	{SINUMERIK_G(93), SINUMERIK_FEED, CODE_READ, "inverse time feed"},
	{SINUMERIK_G(94), SINUMERIK_FEED, CODE_READ, "feed per minute"},
	{SINUMERIK_G(95), SINUMERIK_FEED, CODE_READ, "feed per revolution"},
	{SINUMERIK_G(96), GROUP_NONE, CODE_REFUSED, "constant cutting speed"},
	{SINUMERIK_G(97), GROUP_NONE, CODE_IGNORED, "no constant cutting speed"},
	{SINUMERIK_G(110), SINUMERIK_ONCE, CODE_READ, "pole of polar coordinates, from where the tool is"},
	{SINUMERIK_G(111), SINUMERIK_ONCE, CODE_READ, "pole of polar coordinates, from the workpiece's zero"},
	{SINUMERIK_G(112), SINUMERIK_ONCE, CODE_READ, "pole of polar coordinates, from the last pole"},
	{SINUMERIK_G(140), GROUP_NONE, CODE_IGNORED, "direction of smooth approach"},
	{SINUMERIK_G(141), GROUP_NONE, CODE_IGNORED, "direction of smooth approach"},
	{SINUMERIK_G(142), GROUP_NONE, CODE_IGNORED, "direction of smooth approach"},
	{SINUMERIK_G(143), GROUP_NONE, CODE_IGNORED, "direction of smooth approach"},
	{SINUMERIK_G(147), GROUP_NONE, CODE_REFUSED, "smooth approach"},
	{SINUMERIK_G(148), GROUP_NONE, CODE_REFUSED, "smooth retraction"},
	{SINUMERIK_G(153), SINUMERIK_SUPPRESSION, CODE_READ, "without offsets, base frames included, for its block"},
	{SINUMERIK_G(247), GROUP_NONE, CODE_REFUSED, "smooth approach"},
	{SINUMERIK_G(248), GROUP_NONE, CODE_REFUSED, "smooth retraction"},
	{SINUMERIK_G(290), GROUP_NONE, CODE_IGNORED, "language of Siemens"},
	{SINUMERIK_G(291), GROUP_NONE, CODE_REFUSED, "ISO mode, the language of Fanuc"},
	{SINUMERIK_G(331), SINUMERIK_MOTION, CODE_READ, "rigid tapping"},
	{SINUMERIK_G(332), SINUMERIK_MOTION, CODE_READ, "rigid tapping, retraction"},
	{SINUMERIK_G(340), GROUP_NONE, CODE_IGNORED, "smooth approach in space"},
	{SINUMERIK_G(341), GROUP_NONE, CODE_IGNORED, "smooth approach in the plane"},
	{SINUMERIK_G(347), GROUP_NONE, CODE_REFUSED, "smooth approach"},
	{SINUMERIK_G(348), GROUP_NONE, CODE_REFUSED, "smooth retraction"},
	{SINUMERIK_G(450), SINUMERIK_CORNER, CODE_READ, "cutter compensation rounds outside corners"},
	{SINUMERIK_G(451), SINUMERIK_CORNER, CODE_READ, "cutter compensation cuts outside corners"},
	{SINUMERIK_G(460), GROUP_NONE, CODE_IGNORED, "end of cutter compensation at a contour that it meets"},
	{SINUMERIK_G(461), GROUP_NONE, CODE_REFUSED, "end of cutter compensation, drawn out by a circle"},
	{SINUMERIK_G(462), GROUP_NONE, CODE_REFUSED, "end of cutter compensation, drawn out by a line"},
	{SINUMERIK_G(500), SINUMERIK_SYSTEM, CODE_READ, "no work offset"},
	{SINUMERIK_G(601), GROUP_NONE, CODE_IGNORED, "when an exact stop is reached"},
	{SINUMERIK_G(602), GROUP_NONE, CODE_IGNORED, "when an exact stop is reached"},
	{SINUMERIK_G(603), GROUP_NONE, CODE_IGNORED, "when an exact stop is reached"},
	{SINUMERIK_G(641), SINUMERIK_PATH, CODE_READ, "continuous path, within a distance (ADIS)"},
	{SINUMERIK_G(642), SINUMERIK_PATH, CODE_READ, "continuous path, within the control's tolerance"},
	{SINUMERIK_G(643), SINUMERIK_PATH, CODE_READ, "continuous path, within the control's tolerance"},
	{SINUMERIK_G(644), SINUMERIK_PATH, CODE_READ, "continuous path, as the axes' dynamics allow"},
	{SINUMERIK_G(645), SINUMERIK_PATH, CODE_READ, "continuous path, within the control's tolerance"},
	{SINUMERIK_G(646), SINUMERIK_PATH, CODE_READ, "continuous path, within the control's tolerance"},
	{SINUMERIK_G(700), SINUMERIK_UNITS, CODE_READ, "lengths and feeds in inches"},
	{SINUMERIK_G(710), SINUMERIK_UNITS, CODE_READ, "lengths and feeds in mm"},
};

static const struct code m_rows[] = {
	{0, M_STOP, CODE_READ, "program stop"},
	{1, M_STOP, CODE_READ, "optional stop"},
	{2, M_STOP, CODE_READ, "end of program"},
	{3, M_SPINDLE, CODE_READ, "spindle on, clockwise"},
	{4, M_SPINDLE, CODE_READ, "spindle on, counter-clockwise"},
	{5, M_SPINDLE, CODE_READ, "spindle stop"},
	{6, M_TOOL, CODE_READ, "tool change"},
	{7, M_COOLANT, CODE_IGNORED, "coolant"},
	{8, M_COOLANT, CODE_IGNORED, "coolant"},
	{9, M_COOLANT, CODE_IGNORED, "coolant off"},
	{17, M_STOP, CODE_READ, "end of a subprogram"},
	{19, M_SPINDLE, CODE_READ, "spindle at an angle"},
	{30, M_STOP, CODE_READ, "end of program"},
	{40, GROUP_NONE, CODE_IGNORED, "automatic gear"},
	{41, GROUP_NONE, CODE_IGNORED, "gear"},
	{42, GROUP_NONE, CODE_IGNORED, "gear"},
	{43, GROUP_NONE, CODE_IGNORED, "gear"},
	{44, GROUP_NONE, CODE_IGNORED, "gear"},
	{45, GROUP_NONE, CODE_IGNORED, "gear"},
	{70, M_SPINDLE, CODE_READ, "spindle as an axis"},
};

const struct code_set sinumerik_g_codes = CODE_SET(g_rows);
const struct code_set sinumerik_m_codes = CODE_SET(m_rows);
