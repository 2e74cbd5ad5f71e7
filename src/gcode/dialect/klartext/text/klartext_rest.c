#include "gcode/dialect/klartext/text/klartext_rest.h"

#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/text/klartext_skip.h"

/* Is this a blank line, a comment, or a byte that ends a transmission? */
static bool says_nothing(struct lexer *lexer)
{
	const char byte = lexer_peek(lexer);

	return klartext_ends(lexer) || byte == '%' || byte == '*' || byte == '\x1a';
}

bool klartext_rest_check(struct interp *interp)
{
	struct reader *reader = &interp->program.source->reader;
	bool cautioned = false;
	const char *text;

	program_keep_line(&interp->program, &interp->at);
	while (reader_next(reader, &text) == READER_LINE) {
		struct line_place at = interp->at;
		struct lexer lexer = klartext_lexer(interp);

		at.line = reader->line;
		at.text = text;
		lexer.at = &at;
		klartext_skip_number(&lexer);
		if (klartext_take(&lexer, "BEGIN") && klartext_take(&lexer, "PGM"))
			return fault(&at, 1,
				     "another program begins behind END PGM, and the control reads none of it: give "
				     "each program as a file of its own");
		if (cautioned || says_nothing(&lexer))
			continue;
		caution(&at, 1, "text behind END PGM: the control reads none of it");
		cautioned = true;
	}
	return true;
}
