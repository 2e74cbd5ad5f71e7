/*
 * cutter_hand.h - does the spindle turn the right way for a cutter? Right-hand cutters cut with M3, left-hand with M4.
 */
#ifndef FIVECHECK_MOTION_CUTTER_HAND_H
#define FIVECHECK_MOTION_CUTTER_HAND_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/canon.h"
#include "machine/setup.h"

/* The hand of the tool in the spindle, and whether a check needs it. */
struct cutter_hand {
	int tool;
	enum tool_hand hand;	/* HAND_UNKNOWN also if it is no turning cutter */
	bool decides;	/* the hand is not given, and the remaining stock depends on it */
	bool matters;	/* the hand is not given, and a part may be touched */
};

/* setup may be NULL. */
void cutter_hand_init(struct cutter_hand *hand, const struct setup *setup, int tool);

/* Does the spindle turn against the hand of the cutter? Then it rubs, and cuts nothing. */
bool cutter_hand_reversed(const struct cutter_hand *hand, const struct canon_move *move);

/* A cutter without a hand is assumed to cut with M3. A feed with M4 needs its hand. */
static inline bool cutter_hand_is_asked(const struct canon_move *move)
{
	return move->spindle_turns && move->turn == TURN_COUNTERCLOCKWISE && move->kind != CANON_RAPID;
}

/*
 * For a move that needs the hand: with a stock this is an error, reported (false); with only a part a warning says once
 * what is assumed.
 */
bool cutter_hand_ask(struct cutter_hand *hand, struct diag *diag, struct srcloc at);

#endif
