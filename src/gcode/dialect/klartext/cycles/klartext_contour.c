#include "gcode/dialect/klartext/cycles/klartext_contour.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_region.h"
#include "gcode/dialect/klartext/flow/klartext_label.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/dialect/klartext/words/klartext_words.h"

/* ------------------------------------------------------------- definitions */

/* "CONTOUR LABEL1 /2 /3" in any language: only the numbers are read. */
bool klartext_contour_labels(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext_contour *contour = &klartext_of(interp)->contour;
	char word[KLARTEXT_WORD];

	while (!klartext_ends(lexer)) {
		const int column = lexer_next_column(lexer);
		int label;

		if (lexer_peek(lexer) == '/')
			lexer_take(lexer);
		else if (!klartext_value_follows(lexer) && klartext_word(lexer, word) == 0)
			return fault(lexer->at, column, "CYCL DEF 14.1 needs the numbers of labels, as in LABEL1 /2");
		if (!klartext_value_follows(lexer))
			continue;
		if (!klartext_integer(lexer, "a label", 1, 65535, &label))
			return false;
		if (contour->count == KLARTEXT_CONTOURS_MAX)
			return fault(lexer->at, column, "CYCL DEF 14 has at most %d labels", KLARTEXT_CONTOURS_MAX);
		contour->labels[contour->count++] = label;
	}
	return true;
}

/* "P1 = LBL 1": a pocket (P) or an island (I). False: reported. */
static bool read_contour(struct lexer *lexer, int *label)
{
	const int column = lexer_next_column(lexer);
	char kind[KLARTEXT_WORD];
	int number;

	klartext_word(lexer, kind);
	if ((strcmp(kind, "P") != 0 && strcmp(kind, "I") != 0) || !klartext_value_follows(lexer) ||
	    !klartext_integer(lexer, "the number of a contour", 1, KLARTEXT_CONTOURS_MAX, &number) ||
	    lexer_peek(lexer) != '=')
		return fault(lexer->at, column, "CONTOUR DEF reads contours as P1 = LBL 1 and I2 = LBL 2");
	lexer_take(lexer);
	if (!klartext_take(lexer, "LBL") || !klartext_value_follows(lexer))
		return fault(lexer->at, lexer_next_column(lexer),
			     "CONTOUR DEF reads contours of labels with a number, as in P1 = LBL 1");
	return klartext_integer(lexer, "a label", 1, 65535, label);
}

/*
 * TNC 640 user's manual, "CONTOUR DEF": it names contours as CYCL DEF 14 does and says which are pockets and which are
 * islands.
 */
bool klartext_contour_define(struct lexer *lexer)
{
	struct klartext_contour *contour = &klartext_of(lexer->context)->contour;

	if (!klartext_take(lexer, "DEF"))
		return fault(lexer->at, lexer_next_column(lexer), "CONTOUR needs DEF");
	contour->count = 0;
	while (!klartext_ends(lexer)) {
		const int column = lexer_next_column(lexer);
		int label;

		if (!read_contour(lexer, &label))
			return false;
		if (contour->count == KLARTEXT_CONTOURS_MAX)
			return fault(lexer->at, column, "CONTOUR DEF has at most %d contours", KLARTEXT_CONTOURS_MAX);
		contour->labels[contour->count++] = label;
	}
	return true;
}

bool klartext_contour_data(struct interp *interp, const struct klartext_cycle *cycle)
{
	klartext_of(interp)->contour.data = *cycle;
	return true;
}

/* ------------------------------------------------------------- the contour */

/* The box around the part of a contour that has been read; programmed coordinates, mm. */
struct outline {
	bool begun; /* a point is known */
	bool has[2]; /* X and Y are known */
	double at[2]; /* where the part ends */
	bool has_pole;
	double pole[2];
	double low[2], high[2];
};

static void include(struct outline *outline, const double point[2], double about)
{
	for (int i = 0; i < 2; i++) {
		outline->low[i] = outline->begun ? fmin(outline->low[i], point[i] - about) : point[i] - about;
		outline->high[i] = outline->begun ? fmax(outline->high[i], point[i] + about) : point[i] + about;
	}
	outline->begun = true;
}

static bool take_point(struct outline *outline, struct lexer *lexer, const struct klartext_words *words)
{
	for (int slot = SLOT_X; slot <= SLOT_Y; slot++) {
		const bool increment = words->increments & 1U << slot;

		if (!klartext_words_has(words, slot))
			continue;
		if (increment && !outline->has[slot])
			return fault(lexer->at, words->column[slot], "a contour begins with absolute coordinates");
		outline->at[slot] = words->value[slot] + (increment ? outline->at[slot] : 0);
		outline->has[slot] = true;
	}
	return (outline->has[0] && outline->has[1]) ||
	       fault(lexer->at, words->first_column, "a contour begins with coordinates of X and Y");
}

static bool take_pole(struct outline *outline, struct lexer *lexer, const struct klartext_words *words)
{
	outline->has_pole = true;
	if (!words->axes && outline->has[0] && outline->has[1]) {
		memcpy(outline->pole, outline->at, sizeof(outline->pole));
		return true;
	}
	for (int slot = SLOT_X; slot <= SLOT_Y; slot++) {
		const bool increment = words->increments & 1U << slot;

		if (!klartext_words_has(words, slot) || (increment && !outline->has[slot]))
			return fault(lexer->at, words->first_column, "CC of a contour needs X and Y");
		outline->pole[slot] = words->value[slot] + (increment ? outline->at[slot] : 0);
	}
	return true;
}

static double from_pole(const struct outline *outline)
{
	return math_hypot(outline->at[0] - outline->pole[0], outline->at[1] - outline->pole[1]);
}

static void go_polar(struct outline *outline, double radius, double angle)
{
	outline->at[0] = outline->pole[0] + radius * math_cos_degrees(angle);
	outline->at[1] = outline->pole[1] + radius * math_sin_degrees(angle);
	outline->has[0] = outline->has[1] = true;
	include(outline, outline->at, 0);
}

static bool take_polar_line(struct outline *outline, struct lexer *lexer, const struct klartext_words *words)
{
	if (!outline->has_pole)
		return fault(lexer->at, words->first_column, "no CC has given the centre");
	if (!words->has_radius || !words->has_angle || words->radius_increment || words->angle_increment)
		return fault(lexer->at, words->first_column, "LP of a contour needs PR and PA");
	go_polar(outline, words->radius, words->angle);
	return true;
}

/* Takes the whole circle about the pole, although the path may be an arc of it. */
static bool take_circle(struct outline *outline, struct lexer *lexer, const struct klartext_words *words)
{
	if (!outline->has_pole || !outline->has[0] || !outline->has[1])
		return fault(lexer->at, words->first_column, "no CC has given the centre");
	include(outline, outline->pole, from_pole(outline));
	return true;
}

static bool take_polar_circle(struct outline *outline, struct lexer *lexer, const struct klartext_words *words)
{
	double start = 0;

	if (!take_circle(outline, lexer, words))
		return false;
	if (!words->has_angle)
		return fault(lexer->at, words->first_column, "CP needs PA or IPA");
	if (words->angle_increment)
		start = math_atan2_degrees(outline->at[1] - outline->pole[1], outline->at[0] - outline->pole[0]);
	go_polar(outline, from_pole(outline), start + words->angle);
	return true;
}

/* L, C, and CR: all points of the circle of CR are at most two radii from its end. */
static bool take_path(struct outline *outline, struct lexer *lexer, const struct klartext_words *words,
		      const char *word)
{
	const bool by_radius = !strcmp(word, "CR");

	if (!(words->axes & (1U << SLOT_X | 1U << SLOT_Y)))
		return true;
	if (!strcmp(word, "C") && !take_circle(outline, lexer, words))
		return false;
	if (!take_point(outline, lexer, words))
		return false;
	include(outline, outline->at, by_radius ? 2 * fabs(words->size) : 0);
	return true;
}

/* Reads one block of a contour. RND and CHF are ignored: they stay inside the corner that they cut off. */
static bool take_block(void *context, struct lexer *lexer)
{
	struct outline *outline = context;
	struct klartext_words words;
	char word[KLARTEXT_WORD];
	int column;

	while (ascii_is_digit(lexer_peek(lexer)))
		lexer_take(lexer);
	if (klartext_ends(lexer) || lexer_peek(lexer) == '*')
		return true;
	column = lexer_next_column(lexer);
	klartext_word(lexer, word);
	if (!strcmp(word, "RND") || !strcmp(word, "CHF"))
		return true;
	if (strcmp(word, "L") != 0 && strcmp(word, "C") != 0 && strcmp(word, "CC") != 0 && strcmp(word, "CR") != 0 &&
	    strcmp(word, "LP") != 0 && strcmp(word, "CP") != 0)
		return fault(lexer->at, column, "%s in a contour of CYCL DEF 14 is not supported", word);
	if (!klartext_words_read(lexer, &words))
		return false;
	if (!strcmp(word, "CC"))
		return take_pole(outline, lexer, &words);
	if (!strcmp(word, "LP"))
		return take_polar_line(outline, lexer, &words);
	return !strcmp(word, "CP") ? take_polar_circle(outline, lexer, &words)
				   : take_path(outline, lexer, &words, word);
}

static bool find_outline(const struct klartext_call_of *call, struct outline *outline)
{
	const struct klartext_contour *contour = &klartext_of(call->interp)->contour;

	*outline = (struct outline){.begun = false};
	if (!contour->count)
		return fault(&call->interp->at, call->column, "CYCL DEF %d, but no CYCL DEF 14 has named contours",
			     call->cycle->number);
	for (int i = 0; i < contour->count; i++) {
		char name[16];

		outline->has[0] = outline->has[1] = outline->has_pole = false;
		snprintf(name, sizeof(name), "%d", contour->labels[i]);
		if (!klartext_label_read_section(call->interp, name, call->column, take_block, outline))
			return false;
	}
	return outline->begun ||
	       fault(&call->interp->at, call->column, "the contours of CYCL DEF 14 have no coordinates");
}

/* ------------------------------------------------------------------- cycles */

/* Q1, Q5, Q6 and Q7 of cycle 20: depth, surface, set-up clearance, and the height of moves between contours. */
static bool find_heights(const struct klartext_call_of *data, struct klartext_region *region)
{
	double depth, surface, clearance, height;

	if (!klartext_parameter_length(data, 1, &depth) || !klartext_parameter_length(data, 5, &surface) ||
	    !klartext_parameter_length(data, 6, &clearance) || !klartext_parameter_length(data, 7, &height))
		return false;
	if (depth > 0 || clearance < 0)
		return fault(&data->interp->at, data->column,
			     "CYCL DEF 20: the depth Q1 cannot be positive, nor the set-up clearance Q6 negative");
	region->nothing = same_double(depth, 0);
	region->top = surface + clearance;
	region->bottom = surface + depth - fmax(0, -klartext_parameter_length_or(data, 4, 0));
	region->clear = fmax(height, region->top);
	return true;
}

static bool check(const struct klartext_call_of *call, const struct klartext_call_of *data)
{
	if (data->cycle->number != 20)
		return fault(&call->interp->at, call->column, "CYCL DEF %d without CYCL DEF 20", call->cycle->number);
	if (klartext_frame_is_scaled(call->interp))
		return fault(&call->interp->at, call->column,
			     "CYCL DEF %d while a scaling is in force: the size of what it mills is then not known "
			     "here; cancel the scaling first",
			     call->cycle->number);
	return true;
}

/*
 * iTNC 530 user's manual, "SIDE FINISHING (Cycle 24)": if the allowance Q3 of cycle 20 is greater than the sum of Q14
 * and the tool's radius, the cycle also mills outside an island that has no pocket around it. False: reported.
 */
static bool check_outside(const struct klartext_call_of *call, const struct klartext_call_of *data, double radius)
{
	const double allowance = klartext_parameter_length_or(data, 3, 0);

	return call->cycle->number != 24 || !(allowance > 0) ||
	       !(allowance > klartext_parameter_length_or(call, 14, 0) + radius) ||
	       fault(&call->interp->at, call->column,
		     "CYCL DEF 24 with an allowance Q3 above Q14 and the radius of the tool mills outside of its "
		     "contours, too: how far is not known here; program the contour with RL or RR instead");
}

/*
 * iTNC 530 user's manual, "SL cycles": the tool clears the inside of pockets, and its centre keeps the distance of its
 * radius from their edge. A negative allowance (Q3, Q14) lets it go farther out.
 */
bool klartext_contour_make(const struct klartext_call_of *call)
{
	struct interp *interp = call->interp;
	const struct klartext_call_of data = {
	    .interp = interp, .cycle = &klartext_of(interp)->contour.data, .column = call->column};
	const struct tool *tool = tool_table_find(&interp->tools, interp->state.tool);
	/* Cycle 21 drills at the points where the mill of Q13 plunges. The mill may be smaller than the drill. */
	const bool mills = call->cycle->number != 21;
	const double radius =
	    tool && mills ? fmax(0, tool->diameter / 2 + fmin(0, klartext_of(interp)->tool.delta_radius)) : 0;
	const double more =
	    fmax(0, -klartext_parameter_length_or(&data, 3, 0)) + fmax(0, -klartext_parameter_length_or(call, 14, 0));
	struct klartext_region region = {.centre = klartext_frame_point(interp), .fixed = true};
	struct outline outline;

	if (!check(call, &data) || !check_outside(call, &data, radius) || !find_heights(&data, &region) ||
	    !find_outline(call, &outline) ||
	    !klartext_parameter_feed(call, mills ? 12 : 11, &region.feed))
		return false;
	if (region.nothing)
		return true;
	if (!(region.feed > 0))
		return fault(&interp->at, call->column, "a cycle without a feed rate");
	region.centre.x = (outline.low[0] + outline.high[0]) / 2;
	region.centre.y = (outline.low[1] + outline.high[1]) / 2;
	for (int i = 0; i < 2; i++)
		region.half[i] = fmax(0, (outline.high[i] - outline.low[i]) / 2 - radius) + more;
	return klartext_region_carry_out(call, &region);
}
