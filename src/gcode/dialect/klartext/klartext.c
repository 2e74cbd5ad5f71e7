#include "gcode/dialect/dialects.h"
#include "gcode/dialect/klartext/flow/klartext_flow.h"
#include "gcode/dialect/klartext/klartext_codes.h"
#include "gcode/dialect/klartext/klartext_line.h"
#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/state.h"

/* M91 and tool changes leave the length of TOOL CALL in force. */
static void after_machine_move(struct interp *interp, int code, const bool moved[SLOT_COUNT])
{
	(void)interp;
	(void)code;
	(void)moved;
}

/*
 * Heidenhain iTNC 530 and TNC 640. The dialect reads every line itself (statement), so that only the answers are
 * needed that the engines ask for on behalf of any dialect; all that belongs to G-codes stays unanswered.
 */
const struct dialect dialect_klartext = {
    .name = "klartext",
    .manual = "Heidenhain iTNC 530 and TNC 640 user's manuals, Klartext programming",
    .m_codes = {&klartext_m_codes},
    .words = {&klartext_word_set},
    .traits =
	{
	    .power_on = {.units = G21, .distance = G90, .plane = G17, .feed_mode = G94, .path = G64},
	    .whole_numbers = WHOLE_NUMBERS_UNITS,
	    .known_order = ANSWER_YES,
	    .text_before_percent = ANSWER_NO,
	    .wrap_below_turn = ANSWER_NO,
	    .tool_change_stays = ANSWER_NO,
	    .length_never_moves = ANSWER_YES,
	},
    .after_machine_move = after_machine_move,
    .state_new = klartext_state_new,
    .state_free = klartext_state_free,
    .statement = klartext_line_run,
    .end_of_file = klartext_flow_end_of_file,
    .caller = klartext_flow_caller,
};
