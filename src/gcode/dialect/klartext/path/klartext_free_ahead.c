#include "gcode/dialect/klartext/path/klartext_free_ahead.h"

#include "base/math/math_functions.h"
#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/text/klartext_skip.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/dialect/klartext/words/klartext_free_words.h"

/* The words of FCT that are not words of FK. */
struct others {
	double radius; /* without conversion; 0: none */
	int turn;
};

/*
 * Takes one word: R, DR, an end or a feed rate; an end and a feed rate do not change the circle. False: it is another
 * word.
 */
static bool take_other(struct lexer *lexer, struct others *others)
{
	double unused;

	if (klartext_take(lexer, "DR+") || klartext_take(lexer, "DR-")) {
		others->turn = lexer->at->text[lexer->position - 1] == '+' ? 1 : -1;
		return true;
	}
	if (klartext_take(lexer, "R"))
		return klartext_value_follows(lexer) && klartext_value(lexer, &others->radius);
	return (klartext_take(lexer, "X") || klartext_take(lexer, "Y") || klartext_take(lexer, "F")) &&
	       klartext_value_follows(lexer) && klartext_value(lexer, &unused);
}

/* Reads the words of FCT. False: they do not determine its circle, or one of them is not supported here. */
static bool read_circle(struct lexer *lexer, struct klartext_free_circle *circle)
{
	const struct interp *interp = lexer->context;
	struct klartext_free free = klartext_of(interp)->free;
	struct others others = {0};
	const double *v = free.value;

	klartext_free_words_clear(&free);
	while (!klartext_ends(lexer)) {
		bool taken = false;

		if (klartext_free_words_relation(lexer) || !klartext_free_words_take(lexer, &free, &taken) ||
		    (!taken && !take_other(lexer, &others)))
			return false;
	}
	circle->turn = others.turn;
	circle->radius = others.radius * interp->state.scale;
	circle->centre = (vec3){v[KLARTEXT_FREE_CCX], v[KLARTEXT_FREE_CCY], 0};
	if (free.has_pole && free.has[KLARTEXT_FREE_CCPR] && free.has[KLARTEXT_FREE_CCPA])
		circle->centre =
		    (vec3){free.pole[0] + v[KLARTEXT_FREE_CCPR] * math_cos_degrees(v[KLARTEXT_FREE_CCPA]),
			   free.pole[1] + v[KLARTEXT_FREE_CCPR] * math_sin_degrees(v[KLARTEXT_FREE_CCPA]), 0};
	else if (!free.has[KLARTEXT_FREE_CCX] || !free.has[KLARTEXT_FREE_CCY])
		return false;
	return circle->radius > 0 && circle->turn != 0;
}

/* Reads one line; *done is set if no further line is needed. False: the line does not determine the end. */
static bool read_line(struct lexer *lexer, struct klartext_free_ahead *ahead, bool *done)
{
	bool slash;

	klartext_skip_head(lexer, &slash);
	if (!slash && (klartext_ends(lexer) || lexer_peek(lexer) == '*'))
		return true;
	if (!slash && klartext_take(lexer, "FLT") && klartext_ends(lexer) && !ahead->line) {
		ahead->line = true;
		return true;
	}
	*done = !slash && klartext_take(lexer, "FCT") && read_circle(lexer, &ahead->circle);
	return *done;
}

bool klartext_free_ahead_read(struct interp *interp, struct klartext_free_ahead *ahead)
{
	struct reader *reader = &interp->program.source->reader;
	const struct reader_mark mark = reader_mark(reader);
	const char *text;
	bool done = false;

	*ahead = (struct klartext_free_ahead){0};
	program_keep_line(&interp->program, &interp->at);
	while (!done && reader_next(reader, &text) == READER_LINE) {
		struct line_place at = interp->at;
		struct lexer lexer = klartext_lexer(interp);

		at.line = reader->line;
		at.text = text;
		lexer.at = &at;
		lexer.position = 0;
		if (!read_line(&lexer, ahead, &done))
			break;
	}
	reader_return(reader, &mark);
	return done;
}
