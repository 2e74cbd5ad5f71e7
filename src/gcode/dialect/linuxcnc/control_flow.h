/* control_flow.h - LinuxCNC's control flow: branches, loops, subprograms. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_H

#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "gcode/dialect/linuxcnc/params.h"
#include "gcode/text/label.h"

struct interp;

/* Blocks in loops and calls, if the configuration sets no other limit. */
#define FLOW_BLOCKS_MAX 100000000LL

/* A branch or a loop that is open. */
struct control {
	enum o_kind kind;	/* O_IF, O_WHILE, O_DO, O_REPEAT */
	struct label *label;
	double remaining;	/* passes of a repeat after this one */
};

/* A call under way; the first one is the program itself. */
struct call {
	char name[PARAM_NAME_MAX + 1];
	bool by_m98;	/* arguments and #1 to #30 are the caller's */
	struct position back;
	const char *file;	/* of the caller's block */
	long line;
	int column;
	double saved[PARAM_ARGUMENTS];
	size_t controls;	/* open when it began */
	int m98_left;	/* calls that the M98 under way at this level has left; 0: it is a new one */
};

/* What lines are being skipped for. */
enum skip {
	SKIP_NOTHING,
	SKIP_FALSE,	/* an if whose condition is false: to elseif, else, endif */
	SKIP_DONE,	/* an if that has been carried out: to endif */
	SKIP_LOOP,	/* a loop that is over: behind its end */
	SKIP_CONTINUE,	/* the rest of one pass of a loop */
	SKIP_DEFINITION,	/* the body of a subprogram: to endsub */
	SKIP_SEARCH	/* to the subprogram that is called */
};

struct control_flow {
	struct labels labels;
	struct control *controls;
	size_t control_count, control_capacity;
	struct call calls[PARAM_LEVELS];
	enum skip skip;
	enum o_kind skip_kind;	/* of the branch or loop that is skipped */
	char skip_key[2 * PARAM_NAME_MAX + 2];
	struct srcloc skip_from;
	/* LinuxCNC's flags that outlive the loop that set them. */
	bool stale_break, stale_continue;
	bool repeated;	/* M99 has started the program anew */
	struct strbuf last_pass;	/* what the program left behind at the last M99 */
	long long steps;	/* blocks in loops and calls */
};

void control_flow_release(struct control_flow *flow);

/*
 * Carries out the line in hand if it is one of control flow, or skips it: then
 * *done is true. False: reported.
 */
bool control_flow_line(struct interp *interp, bool *done);

/* M99 of the program itself: from its first line, unless nothing would be different. False: reported. */
bool control_flow_restart(struct interp *interp);

/* The file in hand has ended. False: something is not closed, which was reported. */
bool control_flow_end_of_file(struct interp *interp);

/* Counts a block against the limit. False: reported. */
bool control_flow_count(struct interp *interp);

/* Notes below what has just been reported: from where the block in hand was called. */
void control_flow_note_callers(struct interp *interp);

#endif
