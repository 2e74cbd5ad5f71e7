/* sinumerik_ahead.h - the meaning of a line in the search for a tool change: M6, or the end of the program. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_AHEAD_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_AHEAD_H

enum sinumerik_ahead {
	SINUMERIK_AHEAD_NOTHING,
	SINUMERIK_AHEAD_END,	/* the end of the program: later lines do not run, or only after a jump */
	SINUMERIK_AHEAD_CHANGE,
};

/*
 * The meaning of a line whose words follow its block number and its label. If a line has both, the tool change counts.
 */
enum sinumerik_ahead sinumerik_ahead_of_line(const char *words);

#endif
