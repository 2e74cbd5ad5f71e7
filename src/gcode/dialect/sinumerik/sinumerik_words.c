#include "gcode/dialect/sinumerik/sinumerik_codes.h"

#include <string.h>

/*
 * 840D sl, "G group list" and "List of statements". ROW(word, kind, group, code, state, what). The order is that of
 * the manual's chapters.
 */
#define CODE_ROW(ROW, word, group, code, what) ROW(word, CODE, group, code, CODE_READ, what)
#define ADDRESS_ROW(ROW, word, address, what) ROW(word, ADDRESS, MOTION, SINUMERIK_##address, CODE_READ, what)
#define PLAIN_ROW(ROW, word, kind, what) ROW(word, kind, MOTION, 0, CODE_IGNORED, what)
#define ZERO_ROW(ROW, word, what) ROW(word, ZERO, MOTION, 0, CODE_REFUSED, what)
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
	CODE_ROW(ROW, "CT", MOTION, SINUMERIK_CT, "circle that goes on in the direction of the motion before it") \
	REFUSED_ROW(ROW, "INVCW", "involute interpolation") \
	REFUSED_ROW(ROW, "INVCCW", "involute interpolation") \
	REFUSED_ROW(ROW, "ASPLINE", "spline interpolation (short lines of G1 can say it)") \
	REFUSED_ROW(ROW, "BSPLINE", "spline interpolation (short lines of G1 can say it)") \
	REFUSED_ROW(ROW, "CSPLINE", "spline interpolation (short lines of G1 can say it)") \
	REFUSED_ROW(ROW, "POLY", "polynomial interpolation (short lines of G1 can say it)") \
	REFUSED_ROW(ROW, "OEMIPO1", "interpolation of the machine's maker") \
	REFUSED_ROW(ROW, "OEMIPO2", "interpolation of the machine's maker") \
	ADDRESS_ROW(ROW, "AP", AP, "polar coordinates: angle") \
	ADDRESS_ROW(ROW, "RP", RP, "polar coordinates: radius") \
	ADDRESS_ROW(ROW, "ANG", ANG, "angle of a straight line, beside one coordinate of the plane") \
	REFUSED_ROW(ROW, "ANG1", "two lines by their angles (their coordinates can say it)") \
	REFUSED_ROW(ROW, "ANG2", "two lines by their angles (their coordinates can say it)") \
	ADDRESS_ROW(ROW, "CHF", CHF, "chamfer by its length") \
	ADDRESS_ROW(ROW, "CHR", CHR, "chamfer by what it takes off each block") \
	ADDRESS_ROW(ROW, "RND", RND, "rounding between two blocks") \
	ZERO_ROW(ROW, "RNDM", "rounding between all blocks (RND in each can say it)") \
	ROW("POS", POSITION, MOTION, 0, CODE_READ, "positioning axis, alone in its block") \
	REFUSED_ROW(ROW, "POSA", "positioning axis that goes on while the next blocks move (POS waits for it)") \
	REFUSED_ROW(ROW, "POSP", "positioning axis that goes in parts") \
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
	FRAME_WORD(ROW, "ROTS", 8, "turning by two solid angles") \
	FRAME_WORD(ROW, "AROTS", 9, "turning by two solid angles, added") \
	REFUSED_ROW(ROW, "CROTS", "turning by solid angles in a frame that the control keeps") \
	CODE_ROW(ROW, "TOFRAME", TOOL_FRAME, SINUMERIK_TOROT, "frame in the direction of the tool") \
	CODE_ROW(ROW, "TOFRAMEZ", TOOL_FRAME, SINUMERIK_TOROT, "frame in the direction of the tool") \
	CODE_ROW(ROW, "TOROT", TOOL_FRAME, SINUMERIK_TOROT, "frame in the direction of the tool") \
	CODE_ROW(ROW, "TOROTZ", TOOL_FRAME, SINUMERIK_TOROT, "frame in the direction of the tool") \
	REFUSED_ROW(ROW, "PAROT", "frame that turns with the table of a tool carrier (CYCLE800 gives a plane)") \
	ZERO_ROW(ROW, "TCARR", "orientable tool carrier") \
	CODE_ROW(ROW, "TOFRAMEOF", TOOL_FRAME, SINUMERIK_TOROTOF, "no frame in the direction of the tool") \
	CODE_ROW(ROW, "TOROTOF", TOOL_FRAME, SINUMERIK_TOROTOF, "no frame in the direction of the tool") \
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
	CODE_ROW(ROW, "ORIRPY", ORI_ANGLES, SINUMERIK_ORIRPY, "what A2, B2 and C2 mean") \
	CODE_ROW(ROW, "ORIRPY2", ORI_ANGLES, SINUMERIK_ORIRPY2, "what A2, B2 and C2 mean") \
	CODE_ROW(ROW, "ORIEULER", ORI_ANGLES, SINUMERIK_ORIEULER, "what A2, B2 and C2 mean") \
	CODE_ROW(ROW, "ORISOF", ORI_SMOOTHING, SINUMERIK_ORISOF, "no smoothing of the orientation") \
	CODE_ROW(ROW, "ORISON", ORI_SMOOTHING, SINUMERIK_ORISON, "smoothing of the orientation, within OTOL") \
	PLAIN_ROW(ROW, "OSOF", IGNORED, "no smoothing of the orientation") \
	REFUSED_ROW(ROW, "OSC", "smoothing of the orientation over blocks") \
	REFUSED_ROW(ROW, "OSS", "smoothing of the orientation over blocks") \
	REFUSED_ROW(ROW, "OSSE", "smoothing of the orientation over blocks") \
	REFUSED_ROW(ROW, "OSD", "smoothing of the orientation over blocks") \
	REFUSED_ROW(ROW, "OST", "smoothing of the orientation over blocks") \
	REFUSED_ROW(ROW, "ORIVIRT1", "virtual orientation axes") \
	REFUSED_ROW(ROW, "ORIVIRT2", "virtual orientation axes") \
	REFUSED_ROW(ROW, "ORIPATH", "orientation by the path") \
	REFUSED_ROW(ROW, "ORIPATHS", "orientation by the path") \
	REFUSED_ROW(ROW, "ORICONCW", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICONCCW", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICONIO", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICONTO", "orientation on a cone") \
	REFUSED_ROW(ROW, "ORICURVE", "orientation by a second curve") \
	REFUSED_ROW(ROW, "ORIRESET", "basic orientation of the tool (words of the rotary axes can say it)") \
	REFUSED_ROW(ROW, "ORID", "change of orientation before outside corners") \
	ADDRESS_ROW(ROW, "A2", A2, "orientation by angles") \
	ADDRESS_ROW(ROW, "B2", B2, "orientation by angles") \
	ADDRESS_ROW(ROW, "C2", C2, "orientation by angles") \
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
	REFUSED_ROW(ROW, "TRAILON", "coupling of axes") \
	REFUSED_ROW(ROW, "LEADON", "coupling of axes") \
	REFUSED_ROW(ROW, "TANG", "axis that follows the path") \
	REFUSED_ROW(ROW, "ISOCALL", "call of a program in ISO mode")

#define MORE_WORDS(ROW) \
	ZERO_ROW(ROW, "DL", "sum offset of the tool") \
	REFUSED_ROW(ROW, "FZ", "feed per tooth (F can say it)") \
	PLAIN_ROW(ROW, "SF", IGNORED_VALUE, "angle at which a thread starts") \
	PLAIN_ROW(ROW, "IPOBRKA", IGNORED_VALUE, "when an axis begins to brake") \
	ZERO_ROW(ROW, "TOFFL", "online change of the tool's length or radius") \
	ZERO_ROW(ROW, "TOFFR", "online change of the tool's length or radius") \
	ZERO_ROW(ROW, "TOFFLR", "online change of the tool's length or radius") \
	ZERO_ROW(ROW, "TOFF", "online change of the tool's length or radius") \
	ZERO_ROW(ROW, "CUTMOD", "change of the tool's data with its orientation") \
	ZERO_ROW(ROW, "CUTMODK", "change of the tool's data with its orientation") \
	REFUSED_ROW(ROW, "TOFFON", "change of the tool's data with its orientation") \
	PLAIN_ROW(ROW, "TOFFOF", IGNORED_CALL, "no online change of the tool") \
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
	REFUSED_ROW(ROW, "DISCL", "smooth approach and retraction") \
	REFUSED_ROW(ROW, "DISR", "smooth approach and retraction") \
	REFUSED_ROW(ROW, "DISRP", "smooth approach and retraction") \
	REFUSED_ROW(ROW, "FAD", "smooth approach and retraction") \
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
