#include "gcode/dialect/klartext/cycles/klartext_define.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_contour.h"
#include "gcode/dialect/klartext/cycles/klartext_pattern.h"
#include "gcode/dialect/klartext/cycles/klartext_tolerance.h"
#include "gcode/dialect/klartext/flow/klartext_builder_cycle.h"
#include "gcode/dialect/klartext/frames/klartext_frame_cycle.h"
#include "gcode/dialect/klartext/frames/klartext_preset.h"
#include "gcode/dialect/klartext/planes/klartext_plane.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/dialect/klartext/words/klartext_cycle_words.h"
#include "gcode/dialect/klartext/words/klartext_global.h"
#include "gcode/execute/motion_commands.h"

/* How a cycle takes effect. */
enum cycle_use {
	USE_CALLED, /* when CYCL CALL, M99 or M89 calls it */
	USE_DEFINED, /* where it is defined */
	USE_IGNORED /* never: it moves no axis */
};

struct cycle_row {
	short number;
	enum cycle_use use;
	bool (*run)(struct interp *interp, const struct klartext_cycle *cycle); /* for USE_DEFINED */
};

static bool dwell(struct interp *interp, const struct klartext_cycle *cycle)
{
	double seconds = cycle->count ? cycle->words[cycle->count - 1].value : 0;

	return seconds >= 0
		   ? motion_commands_emit(interp, &(struct canon_move){.kind = CANON_DWELL, .seconds = seconds})
		   : fault(&interp->at, cycle->column, "a dwell cannot be negative");
}

/* iTNC 530 and TNC 640 user's manuals, cycle programming. Sorted by number. */
static const struct cycle_row rows[] = {
    {1, USE_CALLED, NULL},
    {2, USE_CALLED, NULL},
    {3, USE_CALLED, NULL},
    {4, USE_CALLED, NULL},
    {5, USE_CALLED, NULL},
    {7, USE_DEFINED, klartext_frame_cycle_shift},
    {8, USE_DEFINED, klartext_frame_cycle_mirror},
    {9, USE_DEFINED, dwell},
    {10, USE_DEFINED, klartext_frame_cycle_rotate},
    {11, USE_DEFINED, klartext_frame_cycle_scale},
    {12, USE_CALLED, NULL},
    {13, USE_IGNORED, NULL}, /* orients the spindle */
    {14, USE_DEFINED, NULL},
    {17, USE_CALLED, NULL},
    {19, USE_DEFINED, klartext_plane_cycle},
    {20, USE_DEFINED, klartext_contour_data},
    {21, USE_CALLED, NULL},
    {22, USE_CALLED, NULL},
    {23, USE_CALLED, NULL},
    {24, USE_CALLED, NULL},
    {26, USE_DEFINED, klartext_frame_cycle_scale_axes},
    {32, USE_DEFINED, klartext_tolerance_set},
    {200, USE_CALLED, NULL},
    {201, USE_CALLED, NULL},
    {202, USE_CALLED, NULL},
    {203, USE_CALLED, NULL},
    {204, USE_CALLED, NULL},
    {205, USE_CALLED, NULL},
    {206, USE_CALLED, NULL},
    {207, USE_CALLED, NULL},
    {208, USE_CALLED, NULL},
    {209, USE_CALLED, NULL},
    {210, USE_CALLED, NULL},
    {211, USE_CALLED, NULL},
    {212, USE_CALLED, NULL},
    {213, USE_CALLED, NULL},
    {214, USE_CALLED, NULL},
    {215, USE_CALLED, NULL},
    {220, USE_DEFINED, klartext_pattern_circle},
    {221, USE_DEFINED, klartext_pattern_lines},
    {230, USE_CALLED, NULL},
    {232, USE_CALLED, NULL},
    {233, USE_CALLED, NULL},
    {240, USE_CALLED, NULL},
    {241, USE_CALLED, NULL},
    {247, USE_DEFINED, klartext_preset_select},
    {251, USE_CALLED, NULL},
    {252, USE_CALLED, NULL},
    {253, USE_CALLED, NULL},
    {254, USE_CALLED, NULL},
    {256, USE_CALLED, NULL},
    {257, USE_CALLED, NULL},
    {258, USE_CALLED, NULL},
    {262, USE_CALLED, NULL},
    {263, USE_CALLED, NULL},
    {264, USE_CALLED, NULL},
    {265, USE_CALLED, NULL},
    {267, USE_CALLED, NULL},
    {270, USE_IGNORED, NULL}, /* data for cycle 25 */
    {271, USE_IGNORED, NULL}, /* data for cycles 272 to 274 and 277 */
};

static const struct cycle_row *find_row(int number)
{
	for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
		if (rows[i].number == number)
			return &rows[i];
	}
	return NULL;
}

/* --------------------------------------------------------------------- ends */

static bool finish(struct interp *interp)
{
	struct klartext_cycles *cycles = &klartext_of(interp)->cycles;
	struct klartext_cycle *definition = &cycles->definition;
	const struct cycle_row *row = find_row(definition->number);

	definition->open = false;
	if (definition->global)
		return klartext_global_take(interp, definition);
	if (definition->refused) {
		cycles->active = *definition;
		return true;
	}
	if (row ? row->use == USE_CALLED : klartext_builder_cycle_is_called(definition->number)) {
		cycles->active = *definition;
		cycles->modal = false;
		return true;
	}
	if (!row)
		return klartext_builder_cycle_run(interp, definition);
	/* Each line of an older cycle has already taken effect. */
	return row->use != USE_DEFINED || !definition->by_q || row->run(interp, definition);
}

bool klartext_define_end(struct interp *interp)
{
	return !klartext_of(interp)->cycles.definition.open || finish(interp);
}

/* --------------------------------------------------------------------- lines */

bool klartext_define_goes_on(struct lexer *lexer, bool numbered)
{
	const struct interp *interp = lexer->context;
	const struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;

	/* QS500="TEXT" of cycle 225. */
	if (definition->open && definition->by_q && !numbered && klartext_string_follows(lexer))
		return definition->number == 225;
	/* In a program without block numbers, Q parameters from Q200 on belong to the cycle. */
	return definition->open && definition->by_q && !numbered && klartext_cycle_words_is_q(lexer) &&
	       (definition->numbered || definition->number < 200 || lexer->at->text[lexer->position + 1] >= '2');
}

bool klartext_define_line(struct lexer *lexer)
{
	struct interp *interp = lexer->context;

	if (klartext_string_follows(lexer))
		return klartext_string_assign(lexer);
	return klartext_cycle_words_read(lexer, &klartext_of(interp)->cycles.definition);
}

/* Skips the name of a cycle; its number identifies it. */
static void skip_name(struct lexer *lexer)
{
	while (!klartext_ends(lexer) && !klartext_cycle_words_is_q(lexer))
		lexer_take(lexer);
}

/* Skips a name in line n.0: the values of an older cycle follow in the next lines. */
static bool skip_name_of_lines(struct lexer *lexer)
{
	while (!klartext_ends(lexer)) {
		const char *text = lexer->at->text + lexer->position;

		if ((text[0] == '+' || text[0] == '-') && ascii_is_digit(text[1]))
			return fault(lexer->at, lexer_column(lexer),
				     "a value behind the name of a cycle: values stand in the lines .1 and on");
		lexer_take(lexer);
	}
	return true;
}

/* Some contour cycles with Q parameters have numbers below 200, among the older cycles. */
static bool is_by_q(int number)
{
	return number >= 200 || (number >= 20 && number <= 25) || (number >= 27 && number <= 29) || number == 39;
}

static bool begin(struct lexer *lexer, int number, int column)
{
	struct interp *interp = lexer->context;
	const struct cycle_row *row = find_row(number);
	const bool known = row || klartext_builder_cycle_is_known(interp, number);

	/*
	 * It is not known whether CYCL CALL would call this cycle, so the cycle defined before can no longer be called.
	 */
	if (!row)
		klartext_of(interp)->cycles.active.number = 0;
	klartext_of(interp)->cycles.definition =
	    (struct klartext_cycle){.numbered = klartext_of(interp)->lines.numbered,
				    .number = number,
				    .open = true,
				    .refused = !known,
				    .by_q = is_by_q(number),
				    .line = lexer->at->line,
				    .column = column};
	return known || klartext_builder_cycle_refuse(lexer, number, column);
}

/* "12.1 PGM NAME". */
static bool read_program(struct lexer *lexer)
{
	struct klartext *klartext = klartext_of(lexer->context);

	if (!klartext_take(lexer, "PGM"))
		return fault(lexer->at, lexer_next_column(lexer), "CYCL DEF 12.1 needs PGM and a name");
	return klartext_name(lexer, "a program's name", klartext->cycles.program, KLARTEXT_NAME) &&
	       klartext_expect_end(lexer);
}

/* Line 7.0 begins a definition. Each of the lines 7.1, 7.2 ... adds to it and takes effect at once. */
static bool read_part(struct lexer *lexer, int number, int part, int column)
{
	struct interp *interp = lexer->context;
	struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;
	int count;

	if (part == 0) {
		if (!begin(lexer, number, column))
			return false;
		if (number == 14)
			klartext_of(interp)->contour.count = 0;
		if (number == 12)
			klartext_of(interp)->cycles.program[0] = '\0';
		return skip_name_of_lines(lexer);
	}
	if (!definition->open || definition->number != number || definition->by_q)
		return fault(lexer->at, column, "CYCL DEF %d.%d, but no %d.0 has begun the cycle", number, part,
			     number);
	count = definition->count;
	definition->part = part;
	definition->line = lexer->at->line;
	definition->column = column;
	if (number == 14)
		return klartext_contour_labels(lexer);
	if (number == 12)
		return read_program(lexer);
	if (!klartext_cycle_words_read(lexer, definition))
		return false;
	if (find_row(number) && find_row(number)->use == USE_DEFINED) {
		struct klartext_cycle one = *definition;

		/* The words of this line alone. */
		one.count -= count;
		memmove(one.words, &one.words[count], (size_t)one.count * sizeof(one.words[0]));
		definition->count = count;
		return find_row(number)->run(interp, &one);
	}
	return true;
}

bool klartext_define_probe(struct lexer *lexer)
{
	const int column = lexer_next_column(lexer);
	struct klartext_cycle *definition = &klartext_of(lexer->context)->cycles.definition;
	double value;
	int number;

	if (!klartext_value(lexer, &value))
		return false;
	/* Older cycles are written in lines n.0 and n.1. Only the first line is reported. */
	if (definition->refused && value > definition->number && value < definition->number + 1) {
		while (!klartext_ends(lexer))
			lexer_take(lexer);
		return true;
	}
	if (!(value >= 0 && value <= 9999) || !same_double(floor(value), value))
		return fault(lexer->at, column, "TCH PROBE needs the number of a cycle, 0 to 9999");
	number = (int)value;
	if (number < 400) {
		*definition = (struct klartext_cycle){.number = number, .refused = true};
		return fault(lexer->at, column,
			     "TCH PROBE %d: where the probe stops is not known before the program runs; to check the "
			     "program, leave it out, and assign what it measures by FN 0",
			     number);
	}
	if (!klartext_define_end(lexer->context) || !begin(lexer, number, column))
		return false;
	skip_name(lexer);
	return klartext_cycle_words_read(lexer, &klartext_of(lexer->context)->cycles.definition);
}

bool klartext_define_read(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer), number;
	size_t digits;
	const char *text = lexer->at->text + lexer->position;

	digits = strspn(text, "0123456789");
	if (digits == 0 || digits > 4)
		return fault(lexer->at, column, "CYCL DEF needs the number of a cycle");
	for (number = 0; digits > 0; digits--, lexer_take(lexer))
		number = 10 * number + (lexer->at->text[lexer->position] - '0');
	/* "9 .0", as some posts write it. */
	lexer_peek(lexer);
	text = lexer->at->text + lexer->position;
	if (*text == '.' && ascii_is_digit(text[1])) {
		lexer->position += 2;
		return read_part(lexer, number, text[1] - '0', column);
	}
	if (!klartext_define_end(interp) || !begin(lexer, number, column))
		return false;
	if (!klartext_of(interp)->cycles.definition.by_q)
		return fault(lexer->at, column, "CYCL DEF %d is written in lines %d.0, %d.1 and on", number, number,
			     number);
	skip_name(lexer);
	return klartext_cycle_words_read(lexer, &klartext_of(interp)->cycles.definition);
}

bool klartext_define_read_global(struct lexer *lexer)
{
	struct klartext *klartext = klartext_of(lexer->context);
	const int column = lexer_next_column(lexer);
	int number;

	if (!klartext_take(lexer, "DEF"))
		return fault(lexer->at, column, "GLOBAL needs DEF");
	if (!klartext_integer(lexer, "the number of GLOBAL DEF", 0, 9999, &number) ||
	    !klartext_global_check(lexer, number, column) || !klartext_define_end(lexer->context))
		return false;
	klartext->cycles.definition = (struct klartext_cycle){.numbered = klartext->lines.numbered,
							      .number = number,
							      .open = true,
							      .global = true,
							      .by_q = true,
							      .line = lexer->at->line,
							      .column = column};
	skip_name(lexer);
	return klartext_cycle_words_read(lexer, &klartext->cycles.definition);
}
