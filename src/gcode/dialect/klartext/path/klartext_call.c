#include "gcode/dialect/klartext/path/klartext_call.h"

#include "gcode/dialect/klartext/cycles/klartext_cycle.h"
#include "gcode/dialect/klartext/cycles/klartext_pattern.h"
#include "gcode/dialect/klartext/machine/klartext_m.h"
#include "gcode/dialect/klartext/moves/klartext_move.h"
#include "gcode/dialect/klartext/path/klartext_straight.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/words/klartext_words.h"

static bool call_pattern(struct lexer *lexer, int column)
{
	struct interp *interp = lexer->context;
	struct klartext_words words;
	struct canon_feed feed;
	bool rapid;

	if (!klartext_words_read(lexer, &words))
		return false;
	if (words.axes)
		return fault(lexer->at, words.first_column, "CYCL CALL PAT has no coordinates");
	/*
	 * "If you do not enter a feed rate, the control uses the last programmed feed rate". Without any feed rate the
	 * move is a rapid.
	 */
	rapid = !words.feed && !(interp->state.feed_linear > 0);
	if (!rapid && !klartext_move_feed(interp, &words, &rapid, &feed))
		return false;
	return klartext_m_start(interp, &words) && klartext_pattern_call(interp, column, rapid ? NULL : &feed) &&
	       klartext_m_end(interp, &words);
}

bool klartext_call_run(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer);
	struct klartext_words words;
	double shift;

	if (klartext_take(lexer, "PAT"))
		return call_pattern(lexer, column);
	if (klartext_take(lexer, "POS"))
		return klartext_straight_cycle_position(lexer, &shift) &&
		       klartext_cycle_call_shifted(interp, column, shift);
	if (!klartext_words_read(lexer, &words))
		return false;
	if (words.axes)
		return fault(lexer->at, words.first_column, "CYCL CALL with coordinates is written as CYCL CALL POS");
	return klartext_m_start(interp, &words) && klartext_cycle_call(interp, column) &&
	       klartext_m_end(interp, &words);
}
