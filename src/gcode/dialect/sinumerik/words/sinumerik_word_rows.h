/* sinumerik_word_rows.h - rows of words: their forms, and those of motion, frames, orientation and path. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_WORDS_SINUMERIK_WORD_ROWS_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_WORDS_SINUMERIK_WORD_ROWS_H

/*
 * 840D sl, "G group list" and "List of statements". ROW(word, kind, group, code, state, what): sinumerik_words.c makes
 * its tables of them. The order is that of the manual's chapters.
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
	ROW("POS", POSITION, MOTION, 0, CODE_READ, "positioning axis") \
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

#endif
