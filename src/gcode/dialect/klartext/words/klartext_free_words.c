#include "gcode/dialect/klartext/words/klartext_free_words.h"

#include <string.h>

#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"

/* Words that refer to other elements or to points of the element; they are not supported. */
static const char *const relations[] = {"RX",  "RY",  "RAN", "RPR", "RPA", "RCCX", "RCCY", "RCCPR",
					"RCCPA", "PAR", "DP",  "PDX", "PDY", "PX",  "PY",  "P1X",
					"P1Y", "P2X", "P2Y", "P3X", "P3Y", NULL};

const char *klartext_free_words_relation(struct lexer *lexer)
{
	for (int i = 0; relations[i]; i++) {
		if (klartext_take(lexer, relations[i]))
			return relations[i];
	}
	return NULL;
}

bool klartext_free_words_take(struct lexer *lexer, struct klartext_free *free, bool *taken)
{
	static const char *const names[KLARTEXT_FREE_COUNT] = {"AN",   "IAN", "LEN", "PR", "PA", "CCX", "CCY",
							       "CCPR", "CCPA", "CCA", "CLSD"};
	static const bool lengths[KLARTEXT_FREE_COUNT] = {
	    [KLARTEXT_FREE_LEN] = true, [KLARTEXT_FREE_PR] = true,  [KLARTEXT_FREE_CCX] = true,
	    [KLARTEXT_FREE_CCY] = true, [KLARTEXT_FREE_CCPR] = true};
	const struct interp *interp = lexer->context;

	for (int i = 0; i < KLARTEXT_FREE_COUNT; i++) {
		if (!klartext_take(lexer, names[i]))
			continue;
		*taken = free->has[i] = true;
		if (i == KLARTEXT_FREE_CLOSED) {
			free->value[i] = lexer_peek(lexer) == '-' ? -1 : 1;
			if (lexer_peek(lexer) == '+' || lexer_peek(lexer) == '-')
				lexer_take(lexer);
			return true;
		}
		if (!klartext_value(lexer, &free->value[i]))
			return false;
		free->value[i] *= lengths[i] ? interp->state.scale : 1;
		return true;
	}
	return true;
}

void klartext_free_words_clear(struct klartext_free *free)
{
	memset(free->has, 0, sizeof(free->has));
	memset(free->value, 0, sizeof(free->value));
}

bool klartext_free_words_split(struct lexer *lexer, struct klartext_free *free, struct strbuf *rest)
{
	const char *text = lexer->at->text;
	struct lexer ahead = *lexer;
	size_t copied = 0;

	klartext_free_words_clear(free);
	while (!klartext_ends(&ahead)) {
		const int column = lexer_next_column(&ahead);
		char word[KLARTEXT_WORD];
		const char *relation;
		bool taken = false;
		size_t start;

		start = ahead.position;
		relation = klartext_free_words_relation(&ahead);
		if (relation)
			return fault(lexer->at, column, "%s: points and relations of FK are not supported",
				     relation);
		if (!klartext_free_words_take(&ahead, free, &taken))
			return false;
		if (taken) {
			strbuf_addf(rest, "%.*s%*s", (int)(start - copied), text + copied,
				    (int)(ahead.position - start), "");
			copied = ahead.position;
		} else if (klartext_word(&ahead, word) == 0) {
			lexer_take(&ahead);
		}
	}
	strbuf_addf(rest, "%s", text + copied);
	return true;
}
