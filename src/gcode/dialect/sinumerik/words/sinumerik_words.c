#include "gcode/dialect/sinumerik/words/sinumerik_codes.h"

#include <string.h>

#include "gcode/dialect/sinumerik/words/sinumerik_word_rows.h"

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
	ADDRESS_ROW(ROW, "OFFN", OFFN, "allowance of the contour, on top of the tool's radius") \
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
	ROW("SETMS", MASTER, MOTION, 0, CODE_READ, "which spindle S and M3 mean") \
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
	REFUSED_ROW(ROW, "COUPON", "coupling of spindles") \
	ROW("TRAILON", COUPLING, MOTION, 0, CODE_READ, "coupling of axes that the machine file does not have") \
	REFUSED_ROW(ROW, "LEADON", "coupling of axes") \
	REFUSED_ROW(ROW, "TANG", "axis that follows the path") \
	REFUSED_ROW(ROW, "ISOCALL", "call of a program in ISO mode")

#define MORE_WORDS(ROW) \
	ZERO_ROW(ROW, "DL", "sum offset of the tool") \
	REFUSED_ROW(ROW, "FZ", "feed per tooth (F can say it)") \
	PLAIN_ROW(ROW, "SF", IGNORED_VALUE, "angle at which a thread starts") \
	PLAIN_ROW(ROW, "IPOBRKA", IGNORED_VALUE, "when an axis begins to brake") \
	ZERO_ROW(ROW, "TOFFL", "programmed offset of the tool (put it into its data)") \
	ZERO_ROW(ROW, "TOFFR", "programmed offset of the tool (put it into its data)") \
	ZERO_ROW(ROW, "TOFFLR", "programmed offset of the tool (put it into its data)") \
	ZERO_ROW(ROW, "TOFF", "programmed offset of the tool (put it into its data)") \
	ZERO_ROW(ROW, "CUTMOD", "change of the tool's data with its orientation") \
	ZERO_ROW(ROW, "CUTMODK", "change of the tool's data with its orientation") \
	REFUSED_ROW(ROW, "TOFFON", "online change of the tool's length") \
	PLAIN_ROW(ROW, "TOFFOF", IGNORED_CALL, "no online change of the tool's length") \
	PLAIN_ROW(ROW, "ORIS", IGNORED_VALUE, "velocity of the orientation") \
	PLAIN_ROW(ROW, "OVRRAP", IGNORED_VALUE, "override of rapids") \
	PLAIN_ROW(ROW, "IPOENDA", IGNORED_VALUE, "condition under which a positioning axis has arrived") \
	PLAIN_ROW(ROW, "CP", IGNORED, "continuous path of the tool under a transformation") \
	REFUSED_ROW(ROW, "PTP", "each axis on its own way under a transformation") \
	REFUSED_ROW(ROW, "PTPG0", "each axis on its own way under a transformation") \
	REFUSED_ROW(ROW, "PTPWOC", "each axis on its own way under a transformation") \
	REFUSED_ROW(ROW, "STAT", "position of the joints under a transformation") \
	REFUSED_ROW(ROW, "TU", "position of the joints under a transformation") \
	REFUSED_ROW(ROW, "THETA", "orientation by angles of rotation") \
	REFUSED_ROW(ROW, "ORIROTA", "orientation by angles of rotation") \
	REFUSED_ROW(ROW, "ORIROTC", "orientation by angles of rotation") \
	REFUSED_ROW(ROW, "ORIROTR", "orientation by angles of rotation") \
	REFUSED_ROW(ROW, "ORIROTT", "orientation by angles of rotation") \
	REFUSED_ROW(ROW, "ORIAXPOS", "orientation by angles of rotation") \
	PLAIN_ROW(ROW, "ORIC", IGNORED, "change of orientation at outside corners") \
	REFUSED_ROW(ROW, "BAUTO", "ends of splines") \
	REFUSED_ROW(ROW, "BNAT", "ends of splines") \
	REFUSED_ROW(ROW, "BTAN", "ends of splines") \
	REFUSED_ROW(ROW, "EAUTO", "ends of splines") \
	REFUSED_ROW(ROW, "ENAT", "ends of splines") \
	REFUSED_ROW(ROW, "ETAN", "ends of splines") \
	REFUSED_ROW(ROW, "PO", "points of splines and polynomials") \
	REFUSED_ROW(ROW, "PL", "points of splines and polynomials") \
	REFUSED_ROW(ROW, "PW", "points of splines and polynomials") \
	REFUSED_ROW(ROW, "SD", "points of splines and polynomials") \
	REFUSED_ROW(ROW, "SPLINEPATH", "points of splines and polynomials") \
	REFUSED_ROW(ROW, "POLYPATH", "points of splines and polynomials") \
	REFUSED_ROW(ROW, "POLYNOM", "points of splines and polynomials") \
	ADDRESS_ROW(ROW, "DISCL", DISCL, "soft approach: height of the point above the contour") \
	ADDRESS_ROW(ROW, "DISR", DISR, "soft approach: length of the line or radius of the circle") \
	ADDRESS_ROW(ROW, "DISRP", DISRP, "soft approach: height of the way to the point above the contour") \
	ADDRESS_ROW(ROW, "FAD", FAD, "soft approach: feed of the way down to the contour") \
	PLAIN_ROW(ROW, "DRFOF", IGNORED, "no offset by the handwheel") \
	PLAIN_ROW(ROW, "CPRECON", IGNORED, "accuracy of the contour") \
	PLAIN_ROW(ROW, "CPRECOF", IGNORED, "accuracy of the contour") \
	PLAIN_ROW(ROW, "FENDNORM", IGNORED, "accuracy of the contour") \
	PLAIN_ROW(ROW, "CPREC", IGNORED_VALUE, "accuracy of the contour") \
	REFUSED_ROW(ROW, "GFRAME1", "frames of grinding") \
	REFUSED_ROW(ROW, "GFRAME2", "frames of grinding") \
	REFUSED_ROW(ROW, "GFRAME3", "frames of grinding") \
	PLAIN_ROW(ROW, "GFRAME0", IGNORED, "no frame of grinding") \
	REFUSED_ROW(ROW, "DIAM90", "diameter programming") \
	REFUSED_ROW(ROW, "DIAMONA", "diameter programming") \
	REFUSED_ROW(ROW, "DIAMCHAN", "diameter programming") \
	PLAIN_ROW(ROW, "DIAMOFA", IGNORED_CALL, "radius programming") \
	PLAIN_ROW(ROW, "DIAMCYCOF", IGNORED_CALL, "radius programming") \
	PLAIN_ROW(ROW, "LFOF", IGNORED, "no fast retraction") \
	REFUSED_ROW(ROW, "LFON", "fast retraction") \
	REFUSED_ROW(ROW, "LFPOS", "fast retraction") \
	REFUSED_ROW(ROW, "LFTXT", "fast retraction") \
	REFUSED_ROW(ROW, "LFWP", "fast retraction") \
	REFUSED_ROW(ROW, "LIFTFAST", "fast retraction") \
	REFUSED_ROW(ROW, "POLF", "fast retraction") \
	REFUSED_ROW(ROW, "POLFMASK", "fast retraction") \
	REFUSED_ROW(ROW, "SETINT", "fast retraction") \
	PLAIN_ROW(ROW, "DILF", IGNORED_VALUE, "fast retraction, its way") \
	PLAIN_ROW(ROW, "ALF", IGNORED_VALUE, "fast retraction, its way") \
	PLAIN_ROW(ROW, "CLRINT", IGNORED_CALL, "interrupts") \
	PLAIN_ROW(ROW, "ENABLE", IGNORED_CALL, "interrupts") \
	PLAIN_ROW(ROW, "DISABLE", IGNORED_CALL, "interrupts") \
	REFUSED_ROW(ROW, "RMI", "return to the contour") \
	REFUSED_ROW(ROW, "REPOSA", "return to the contour") \
	REFUSED_ROW(ROW, "REPOSL", "return to the contour") \
	REFUSED_ROW(ROW, "REPOSQ", "return to the contour") \
	REFUSED_ROW(ROW, "REPOSH", "return to the contour") \
	REFUSED_ROW(ROW, "PON", "stroke of a punch") \
	REFUSED_ROW(ROW, "PONS", "stroke of a punch") \
	REFUSED_ROW(ROW, "SON", "stroke of a punch") \
	REFUSED_ROW(ROW, "SONS", "stroke of a punch") \
	PLAIN_ROW(ROW, "SPOF", IGNORED, "no stroke of a punch") \
	PLAIN_ROW(ROW, "PDELAYON", IGNORED, "no stroke of a punch") \
	PLAIN_ROW(ROW, "PDELAYOF", IGNORED, "no stroke of a punch") \
	PLAIN_ROW(ROW, "SPIF1", IGNORED, "no stroke of a punch") \
	PLAIN_ROW(ROW, "SPIF2", IGNORED, "no stroke of a punch") \
	PLAIN_ROW(ROW, "TCOABS", IGNORED, "orientation of a tool carrier") \
	PLAIN_ROW(ROW, "TCOFR", IGNORED, "orientation of a tool carrier") \
	PLAIN_ROW(ROW, "TCOFRX", IGNORED, "orientation of a tool carrier") \
	PLAIN_ROW(ROW, "TCOFRY", IGNORED, "orientation of a tool carrier") \
	PLAIN_ROW(ROW, "TCOFRZ", IGNORED, "orientation of a tool carrier") \
	PLAIN_ROW(ROW, "WALCS0", IGNORED, "working area limits of the workpiece's coordinates") \
	PLAIN_ROW(ROW, "WALCS1", IGNORED, "working area limits of the workpiece's coordinates") \
	PLAIN_ROW(ROW, "WALCS2", IGNORED, "working area limits of the workpiece's coordinates") \
	REFUSED_ROW(ROW, "TOFRAMEX", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "TOFRAMEY", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "TOROTX", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "TOROTY", "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "CORROF", "frame of the control") \
	PLAIN_ROW(ROW, "CLEARM", IGNORED_CALL, "other channels") \
	PLAIN_ROW(ROW, "CANCEL", IGNORED_CALL, "end of synchronous actions, which are refused") \
	PLAIN_ROW(ROW, "SETM", IGNORED_CALL, "other channels") \
	PLAIN_ROW(ROW, "WAITMC", IGNORED_CALL, "other channels") \
	PLAIN_ROW(ROW, "WAITE", IGNORED_CALL, "other channels") \
	REFUSED_ROW(ROW, "INIT", "program of another channel") \
	REFUSED_ROW(ROW, "START", "program of another channel") \
	REFUSED_ROW(ROW, "GEOAX", "other axes for the workpiece's coordinates") \
	REFUSED_ROW(ROW, "TRAFOON", "other axes for the workpiece's coordinates") \
	PLAIN_ROW(ROW, "SETPIECE", IGNORED_CALL, "tool monitoring") \
	PLAIN_ROW(ROW, "TMON", IGNORED_CALL, "tool monitoring") \
	PLAIN_ROW(ROW, "TMOF", IGNORED_CALL, "tool monitoring") \
	PLAIN_ROW(ROW, "RESETMON", IGNORED_CALL, "tool monitoring") \
	PLAIN_ROW(ROW, "SETTA", IGNORED_CALL, "tool monitoring") \
	PLAIN_ROW(ROW, "NEWCONF", IGNORED, "machine data take effect") \
	REFUSED_ROW(ROW, "PRESETON", "actual positions are set anew") \
	REFUSED_ROW(ROW, "PRESETONS", "actual positions are set anew") \
	PLAIN_ROW(ROW, "NPROT", IGNORED_CALL, "protected areas") \
	PLAIN_ROW(ROW, "CPROT", IGNORED_CALL, "protected areas") \
	REFUSED_ROW(ROW, "NPROTDEF", "definition of protected areas") \
	REFUSED_ROW(ROW, "CPROTDEF", "definition of protected areas") \
	REFUSED_ROW(ROW, "EXECUTE", "definition of protected areas") \
	REFUSED_ROW(ROW, "FCTDEF", "overlaid motion") \
	REFUSED_ROW(ROW, "SYNFCT", "overlaid motion") \
	REFUSED_ROW(ROW, "PUTFTOC", "overlaid motion") \
	REFUSED_ROW(ROW, "PUTFTOCF", "overlaid motion") \
	REFUSED_ROW(ROW, "FTOC", "overlaid motion") \
	REFUSED_ROW(ROW, "FTOCON", "overlaid motion") \
	PLAIN_ROW(ROW, "FTOCOF", IGNORED, "no overlaid motion") \
	REFUSED_ROW(ROW, "EXECSTRING", "a text that is carried out") \
	REFUSED_ROW(ROW, "EXECTAB", "a text that is carried out") \
	REFUSED_ROW(ROW, "CONTPRON", "a text that is carried out") \
	REFUSED_ROW(ROW, "CONTDCON", "a text that is carried out") \
	PLAIN_ROW(ROW, "DELETE", IGNORED_CALL, "files") \
	PLAIN_ROW(ROW, "CALLPATH", IGNORED_CALL, "files") \
	REFUSED_ROW(ROW, "REDEF", "a text that stands for a name") \
	PLAIN_ROW(ROW, "IPTRLOCK", IGNORED, "stop and search of a block") \
	PLAIN_ROW(ROW, "IPTRUNLOCK", IGNORED, "stop and search of a block") \
	PLAIN_ROW(ROW, "DELAYFSTON", IGNORED, "stop and search of a block") \
	PLAIN_ROW(ROW, "DELAYFSTOF", IGNORED, "stop and search of a block") \
	PLAIN_ROW(ROW, "DRIVEA", IGNORED_CALL, "dynamic response of an axis") \
	PLAIN_ROW(ROW, "JERKA", IGNORED_CALL, "dynamic response of an axis") \
	PLAIN_ROW(ROW, "AFISON", IGNORED_CALL, "dynamic response of an axis") \
	PLAIN_ROW(ROW, "AFISOF", IGNORED_CALL, "dynamic response of an axis") \
	PLAIN_ROW(ROW, "FPR", IGNORED_CALL, "where the feed per revolution comes from") \
	PLAIN_ROW(ROW, "FPRAON", IGNORED_CALL, "where the feed per revolution comes from") \
	PLAIN_ROW(ROW, "FPRAOF", IGNORED_CALL, "where the feed per revolution comes from") \
	REFUSED_ROW(ROW, "CADAPTON", "control of the feed while it cuts") \
	PLAIN_ROW(ROW, "CADAPTOF", IGNORED, "no control of the feed") \
	PLAIN_ROW(ROW, "TANGDEL", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "COUPDEL", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "COUPRES", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "EGDEL", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "MASLOF", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "MASLDEL", IGNORED_CALL, "no coupling of axes") \
	PLAIN_ROW(ROW, "CTABDEL", IGNORED_CALL, "no coupling of axes") \
	REFUSED_ROW(ROW, "TANGON", "coupling of axes") \
	REFUSED_ROW(ROW, "TLIFT", "coupling of axes") \
	REFUSED_ROW(ROW, "COUPDEF", "coupling of axes") \
	REFUSED_ROW(ROW, "COUPONC", "coupling of axes") \
	REFUSED_ROW(ROW, "EGDEF", "coupling of axes") \
	REFUSED_ROW(ROW, "EGON", "coupling of axes") \
	REFUSED_ROW(ROW, "MASLON", "coupling of axes") \
	REFUSED_ROW(ROW, "MASLDEF", "coupling of axes") \
	REFUSED_ROW(ROW, "CPON", "coupling of axes") \
	REFUSED_ROW(ROW, "CPDEF", "coupling of axes") \
	REFUSED_ROW(ROW, "CPLON", "coupling of axes") \
	REFUSED_ROW(ROW, "CTABDEF", "coupling of axes") \
	REFUSED_ROW(ROW, "OS", "oscillation") \
	REFUSED_ROW(ROW, "OSCILL", "oscillation") \
	REFUSED_ROW(ROW, "OSP1", "oscillation") \
	REFUSED_ROW(ROW, "OSP2", "oscillation") \
	REFUSED_ROW(ROW, "OST1", "oscillation") \
	REFUSED_ROW(ROW, "OST2", "oscillation") \
	REFUSED_ROW(ROW, "OSB", "oscillation") \
	REFUSED_ROW(ROW, "OSE", "oscillation") \
	REFUSED_ROW(ROW, "OSNSC", "oscillation") \
	REFUSED_ROW(ROW, "OSCTRL", "oscillation") \
	REFUSED_ROW(ROW, "MOV", "motion of an axis by itself") \
	REFUSED_ROW(ROW, "MOVT", "motion of an axis by itself") \
	REFUSED_ROW(ROW, "POSM", "motion of an axis by itself") \
	REFUSED_ROW(ROW, "PM", "motion of an axis by itself") \
	REFUSED_ROW(ROW, "MEAWA", "measuring with a probe") \
	REFUSED_ROW(ROW, "MEAC", "measuring with a probe") \
	REFUSED_ROW(ROW, "FXST", "travel to a fixed stop") \
	REFUSED_ROW(ROW, "FXSW", "travel to a fixed stop") \
	REFUSED_ROW(ROW, "FOC", "travel to a fixed stop") \
	REFUSED_ROW(ROW, "FOCON", "travel to a fixed stop") \
	PLAIN_ROW(ROW, "FOCOF", IGNORED, "no fixed torque") \
	PLAIN_ROW(ROW, "FDA", IGNORED_VALUE, "feed of an axis") \
	PLAIN_ROW(ROW, "FD", IGNORED_VALUE, "feed of an axis")

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
	STATEMENT_ROW(ROW, "DEFINE", "a text that stands for a name") \
	STATEMENT_ROW(ROW, "PROC", "head of a subprogram") \
	STATEMENT_ROW(ROW, "RET", "end of a subprogram") \
	STATEMENT_ROW(ROW, "CALL", "call of a subprogram by a text, or with BLOCK of a part of the program") \
	STATEMENT_ROW(ROW, "PCALL", "call of a subprogram by its path") \
	STATEMENT_ROW(ROW, "EXTCALL", "call of a subprogram by a text") \
	STATEMENT_ROW(ROW, "ID", "synchronous action, if it moves no axis") \
	STATEMENT_ROW(ROW, "IDS", "synchronous action, if it moves no axis") \
	STATEMENT_ROW(ROW, "WHEN", "synchronous action, if it moves no axis") \
	STATEMENT_ROW(ROW, "WHENEVER", "synchronous action, if it moves no axis") \
	STATEMENT_ROW(ROW, "EVERY", "synchronous action, if it moves no axis") \
	STATEMENT_ROW(ROW, "DO", "synchronous action, if it moves no axis")

#define WORDS(ROW) \
	STATEMENT_WORDS(ROW) MOTION_WORDS(ROW) FRAME_WORDS(ROW) FIVE_AXIS_WORDS(ROW) PATH_WORDS(ROW) OTHER_WORDS(ROW) \
	MORE_WORDS(ROW)

#define AS_PEOPLE_READ(word, kind, group, code, state, what) {word, state, what},
#define AS_CODE(word, kind, group, code, state, what) {SINUMERIK_WORD_##kind, SINUMERIK_##group, code, what},

static const struct code_word word_rows[] = {WORDS(AS_PEOPLE_READ)};
static const struct sinumerik_word words[] = {WORDS(AS_CODE)};

const struct word_set sinumerik_word_set = {word_rows, sizeof(word_rows) / sizeof(word_rows[0])};

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
