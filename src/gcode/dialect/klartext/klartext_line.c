#include "gcode/dialect/klartext/klartext_line.h"

#include <string.h>

#include "gcode/dialect/klartext/cycles/klartext_define.h"
#include "gcode/dialect/klartext/klartext_statement.h"
#include "gcode/dialect/klartext/path/klartext_approach.h"
#include "gcode/dialect/klartext/path/klartext_corner.h"
#include "gcode/dialect/klartext/text/klartext_join.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/text/klartext_skip.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"

/* "%NAME G71" begins a program in DIN/ISO, which these controls read as well. */
static bool refuse_iso(struct lexer *lexer)
{
	return fault(lexer->at, lexer_next_column(lexer),
		     "this is a DIN/ISO program of the control (%%NAME G71); only Klartext is supported");
}

/* Blocks of loops and calls are counted. */
static bool count_block(struct interp *interp)
{
	return !klartext_of(interp)->calls.jumped ||
	       program_count(&interp->program, interp->config->read.max_blocks, &interp->at);
}

/* After M2 and M30 only subprograms follow, up to END PGM: their lines are skipped. */
static bool pass_by(struct lexer *lexer)
{
	return !klartext_take(lexer, "END") || klartext_statement_end(lexer);
}

static bool check_begun(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	const struct klartext *klartext = klartext_of(interp);
	char byte = lexer_peek(lexer);

	if (klartext->lines.begun || klartext_take(lexer, "BEGIN"))
		return true;
	if (byte == '%')
		return refuse_iso(lexer);
	return fault(lexer->at, lexer_next_column(lexer),
		     "a Klartext program begins with BEGIN PGM, which says MM or INCH");
}

/*
 * May this block stand between a corner, or APPR, and the path after it? The block that waits needs that path: blocks
 * between them may change Q parameters, but must not move an axis.
 */
static bool may_follow_corner(const struct lexer *before)
{
	static const char *const words[] = {"RND", "CHF", "CC", "L", "LP", "C", "CR", "CT", "CP", "CTP",
					    "FL",  "FLT", "FC", "FCT", "LBL", "FN"};
	struct lexer lexer = *before;
	char word[KLARTEXT_WORD];

	klartext_word(&lexer, word);
	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++) {
		if (!strcmp(word, words[i]))
			return true;
	}
	return word[0] == 'Q';
}

static bool is_like_block(const struct lexer *before)
{
	struct lexer lexer = *before;
	char word[KLARTEXT_WORD];

	klartext_word(&lexer, word);
	return word[0] == 'Q' || klartext_statement_is_known(word) ||
	       klartext_statement_starts_word(word, lexer.at->text[lexer.position]);
}

/*
 * Is this line a comment, or does it continue a comment that ends in '~'? Only a line without a block number continues
 * a comment, and only a comment with a block number. So a numbered block is never taken for a comment.
 */
static bool is_comment(struct lexer *lexer, bool numbered)
{
	struct klartext_lines *lines = &klartext_of(lexer->context)->lines;
	const char byte = lexer_peek(lexer);
	const bool begins = byte == ';' || byte == '*', goes_on = lines->comment_goes_on && !numbered;

	lines->comment_goes_on = (goes_on || (begins && numbered)) && klartext_continues(lexer->at->text);
	return byte == '\0' || begins || goes_on;
}

/*
 * Does this line hold words without a block, behind a block whose comment ends in '~'? The words may belong to the
 * comment or to the block, and they would change the block's move.
 */
static bool may_belong_before(struct lexer *lexer, bool numbered)
{
	struct klartext *klartext = klartext_of(lexer->context);
	const char *text = lexer->at->text;
	const bool behind = klartext->lines.tail_goes_on && !numbered;
	struct lexer look = *lexer;
	char word[KLARTEXT_WORD];

	klartext->lines.tail_goes_on = strchr(text, ';') && klartext_continues(text);
	if (behind)
		klartext_word(&look, word);
	return behind && !klartext->cycles.definition.open && !klartext_statement_is_known(word) &&
	       klartext_statement_starts_word(word, text[look.position]);
}

static bool take_line(struct lexer *lexer, bool *bare)
{
	struct interp *interp = lexer->context;
	bool numbered = klartext_skip_number(lexer);
	const size_t start = lexer->position;
	char byte = lexer_peek(lexer);

	klartext_of(interp)->lines.numbered = numbered;
	*bare = true;
	if (klartext_of(interp)->lines.comment_goes_on && !numbered && is_like_block(lexer))
		return fault(lexer->at, lexer_next_column(lexer),
			     "'~' has this line belong to the comment before it, but it reads like a block: take the "
			     "'~' away, or begin the line with ';'");
	if (is_comment(lexer, numbered)) {
		klartext_of(interp)->lines.tail_goes_on = false;
		return true;
	}
	if (may_belong_before(lexer, numbered))
		return fault(lexer->at, lexer_next_column(lexer),
			     "'~' behind the comment of the block before leaves open whether this line belongs to it: "
			     "take the '~' away, or write it before the comment's ';' and without the comment");
	if (klartext_of(interp)->lines.behind_end)
		return pass_by(lexer);
	if (!count_block(interp) || !check_begun(lexer))
		return false;
	lexer->position = start;
	lexer_peek(lexer);
	if (byte == '/' && interp->config->read.block_delete)
		return true;
	if (byte == '/') {
		lexer_take(lexer);
		klartext_of(interp)->lines.numbered |= klartext_skip_number(lexer);
		if (klartext_ends(lexer) || lexer_peek(lexer) == '*')
			return true;
	}
	if (klartext_of(interp)->corner.waits && !may_follow_corner(lexer))
		return klartext_corner_check_none(interp);
	if (klartext_of(interp)->approach.waits && !may_follow_corner(lexer))
		return klartext_approach_check_none(interp);
	if (klartext_define_goes_on(lexer, numbered)) {
		*bare = false;
		return klartext_define_line(lexer);
	}
	return klartext_statement_run(lexer, bare);
}

/*
 * Ends a definition before this line unless the line continues it. Without '~' only a line of parameters continues it.
 */
static bool end_definition(struct interp *interp, const struct lexer *before)
{
	struct lexer lexer = *before;
	struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;
	bool numbered, slash;

	numbered = klartext_skip_head(&lexer, &slash);
	if (klartext_ends(&lexer) || klartext_define_goes_on(&lexer, numbered))
		return true;
	if ((klartext_take(&lexer, "CYCL") || klartext_take(&lexer, "CYCLE")) && !definition->by_q &&
	    !klartext_take(&lexer, "CALL"))
		return true;
	return klartext_define_end(interp);
}

/* An empty line, or a comment without a block number, which may stand between the lines of a definition. */
static bool says_nothing(const char *text)
{
	const char first = text[strspn(text, " \t")];

	return first == '\0' || first == ';';
}

/* Is this a definition in one line, or the last line of a definition with '~'? */
static bool ends_definition(const struct interp *interp)
{
	const struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;
	const bool in_one = definition->count > 0 && definition->line == interp->at.line;

	return definition->open && definition->by_q && !klartext_continues(interp->at.text) &&
	       (in_one || (definition->continued && !says_nothing(interp->at.text)));
}

bool klartext_line_run(struct interp *interp, bool *done)
{
	struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;
	struct lexer lexer;
	bool bare, good;

	*done = true;
	interp->moves = 0;
	if (klartext_skip_definition(interp))
		return true;
	if (!klartext_join(interp, klartext_statement_begins))
		return false;
	lexer = klartext_lexer(interp);
	/*
	 * A fault of the definition is not a fault of the current line, which may be a label. So the line is carried
	 * out.
	 */
	good = !definition->open || end_definition(interp, &lexer);
	if (!good && !interp->config->read.all_faults)
		return false;
	if (!take_line(&lexer, &bare) || !good)
		return false;
	klartext_of(interp)->sync.holds &= interp->moves == 0;
	definition->continued |= definition->open && definition->count > 0 && klartext_continues(interp->at.text);
	if (ends_definition(interp) && !klartext_define_end(interp))
		return false;
	if (klartext_of(interp)->corner.waits && !bare) {
		klartext_corner_keep_line(interp);
		return true;
	}
	if (klartext_of(interp)->approach.waits && !bare) {
		klartext_approach_keep_line(interp);
		return true;
	}
	/* A block without any move does not count as a block without a move in the plane. */
	interp->comp.moved |= interp->moves == 0;
	return bare || cutter_comp_end_block(interp);
}
