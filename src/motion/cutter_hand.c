#include "motion/cutter_hand.h"

static bool has_body(const struct setup *setup, enum body_role role, int tool)
{
	for (size_t i = 0; i < setup->body_count; i++)
		if (setup->bodies[i].role == role && setup->bodies[i].tool == tool)
			return true;
	return false;
}

void cutter_hand_init(struct cutter_hand *hand, const struct setup *setup, int tool)
{
	const struct tool *it = setup ? setup_tool(setup, tool) : NULL;

	*hand = (struct cutter_hand){.tool = tool};
	if (!it || it->kind != TOOL_TURNS || !has_body(setup, ROLE_CUTTER, tool))
		return;
	hand->hand = it->hand;
	hand->decides = it->hand == HAND_UNKNOWN && has_body(setup, ROLE_STOCK, 0);
	hand->matters = it->hand == HAND_UNKNOWN && has_body(setup, ROLE_PART, 0);
}

bool cutter_hand_reversed(const struct cutter_hand *hand, const struct canon_move *move)
{
	return (hand->hand == HAND_RIGHT && move->turn == TURN_COUNTERCLOCKWISE) ||
	       (hand->hand == HAND_LEFT && move->turn == TURN_CLOCKWISE);
}

bool cutter_hand_ask(struct cutter_hand *hand, struct diag *diag, struct srcloc at)
{
	if (hand->decides) {
		diag_error(diag, at,
			   "the spindle turns counterclockwise (M4), and the hand of T%d is not known: set <tool "
			   "number=\"%d\" hand=\"left\"> (it cuts) or hand=\"right\" (it rubs) in the setup",
			   hand->tool, hand->tool);
		return false;
	}
	if (hand->matters)
		diag_warning(diag, at,
			     "the spindle turns counterclockwise (M4), and the hand of T%d is not known: it is assumed "
			     "to be left; set <tool number=\"%d\" hand=\"left\"> or hand=\"right\" in the setup",
			     hand->tool, hand->tool);
	hand->matters = false;
	return true;
}
