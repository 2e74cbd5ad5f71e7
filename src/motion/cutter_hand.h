/*
 * cutter_hand.h - does the spindle turn as a cutter needs it? Right-hand cutters cut with M3, left-hand ones with M4.
 */
#ifndef FIVECHECK_MOTION_CUTTER_HAND_H
#define FIVECHECK_MOTION_CUTTER_HAND_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/canon.h"
#include "machine/setup.h"

/* Of the tool in the spindle. */
struct cutter_hand {
	int tool;
	enum tool_hand hand;	/* HAND_UNKNOWN likewise of what is no cutter that turns */
	bool decides;	/* the hand is not given, and what remains of the stock depends on it */
	bool matters;	/* the hand is not given, and a part may be touched */
};

/* setup may be NULL. */
void cutter_hand_init(struct cutter_hand *hand, const struct setup *setup, int tool);

/* Does the spindle turn against the cutter's hand? Then it rubs, and cuts nothing. */
bool cutter_hand_reversed(const struct cutter_hand *hand, const struct canon_move *move);

/* M3 is taken to be right for a cutter whose hand is not given. With M4 a feed asks for it. */
static inline bool cutter_hand_is_asked(const struct canon_move *move)
{
	return move->spindle_turns && move->turn == TURN_COUNTERCLOCKWISE && move->kind != CANON_RAPID;
}

/*
 * Of a move that asks for the hand: with a stock the program is not supported without, reported (false); with a part a
 * warning says once what is taken for granted.
 */
bool cutter_hand_ask(struct cutter_hand *hand, struct diag *diag, struct srcloc at);

#endif
