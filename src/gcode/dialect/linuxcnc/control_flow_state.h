/* control_flow_state.h - LinuxCNC's open branches, loops and calls, and the reason why lines are skipped. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_STATE_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_STATE_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/dialect/linuxcnc/modal_state.h"
#include "gcode/dialect/linuxcnc/params.h"
#include "gcode/text/label.h"

/* Kinds of o-words; O_PROGRAM is an O-word alone, which names a subprogram for M98. */
enum o_kind {
	O_SUB, O_ENDSUB, O_CALL, O_DO, O_WHILE, O_REPEAT, O_IF, O_ELSEIF, O_ELSE, O_ENDIF, O_BREAK, O_CONTINUE,
	O_ENDWHILE, O_ENDREPEAT, O_RETURN, O_PROGRAM, O_M98, O_M99
};

/* A branch or a loop that is open. */
struct control {
	enum o_kind kind;	/* O_IF, O_WHILE, O_DO, O_REPEAT */
	struct label *label;
	double remaining;	/* passes of a repeat after the present one */
};

/* An active call; the first one is the main program. */
struct call {
	char name[PARAM_NAME_MAX + 1];
	bool by_m98;	/* arguments and #1 to #30 are the caller's */
	struct position back;
	const char *file;	/* of the caller's block */
	long line;
	int column;
	double saved[PARAM_ARGUMENTS];
	size_t controls;	/* the number of open branches and loops at its start */
	struct modal_state modal;	/* of M70 and M73 */
	int m98_left;	/* remaining calls of the active M98 at this level; 0: the M98 is new */
};

/* The reason why lines are skipped. */
enum skip {
	SKIP_NOTHING,
	SKIP_FALSE,	/* an if whose condition is false: to elseif, else, endif */
	SKIP_DONE,	/* an if that has been carried out: to endif */
	SKIP_LOOP,	/* a loop that is finished: past its end */
	SKIP_CONTINUE,	/* the rest of one pass of a loop */
	SKIP_DEFINITION,	/* the body of a subprogram: to endsub */
	SKIP_SEARCH	/* to the subprogram that is called */
};

/* "subprogram#label" */
#define CONTROL_KEY_MAX (2 * PARAM_NAME_MAX + 2)

struct control_flow {
	/* The key of a subprogram is its name, of others "subprogram#label"; kinds are enum o_kind. */
	struct labels labels;
	struct control *controls;
	size_t control_count, control_capacity;
	struct call calls[PARAM_LEVELS];
	enum skip skip;
	enum o_kind skip_kind;	/* of the branch or loop that is skipped */
	char skip_key[CONTROL_KEY_MAX];
	struct srcloc skip_from;
	/* LinuxCNC's flags that stay set after their loop. */
	bool stale_break, stale_continue;
};

#endif
