#include "gcode/dialect/klartext/klartext_pattern.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/klartext_cycle.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/dialect/klartext/klartext_lexis.h"
#include "gcode/dialect/klartext/klartext_move.h"
#include "gcode/dialect/klartext/klartext_parameter.h"
#include "gcode/dialect/klartext/klartext_value.h"

/* ------------------------------------------------------------------- points */

static bool add_point(struct interp *interp, int column, vec3 point)
{
	struct klartext_points *points = &klartext_of(interp)->points;

	if (points->count == KLARTEXT_POINTS_MAX)
		return fault(&interp->at, column, "a pattern has at most %d points", KLARTEXT_POINTS_MAX);
	points->items[points->count++] = point;
	return true;
}

static vec3 polar(vec3 from, double radius, double angle)
{
	return (vec3){from.x + radius * math_cos_degrees(angle), from.y + radius * math_sin_degrees(angle), from.z};
}

/* Columns along an angle and rows across it; in every second row back again, if `zigzag`. */
static bool add_lines(struct interp *interp, int column, vec3 start, const double spacing[2], const int count[2],
		      double angle, bool zigzag)
{
	for (int row = 0; row < count[1]; row++) {
		for (int i = 0; i < count[0]; i++) {
			int at = zigzag && row % 2 == 1 ? count[0] - 1 - i : i;

			if (!add_point(interp, column,
				       polar(polar(start, at * spacing[0], angle), row * spacing[1], angle + 90)))
				return false;
		}
	}
	return true;
}

static bool add_circle(struct interp *interp, int column, vec3 centre, double diameter, double start, double step,
		       int count)
{
	for (int i = 0; i < count; i++) {
		if (!add_point(interp, column, polar(centre, diameter / 2, start + i * step)))
			return false;
	}
	return true;
}

/* -------------------------------------------------------------------- calls */

static bool rapid_to(struct interp *interp, vec3 point)
{
	const struct klartext_target target = {.point = point, .others = interp->state.position};

	return klartext_move_line(interp, &target, true, &(struct canon_feed){0});
}

/* Over the points at a height that is given, or the highest one where the tool stands between two of them. */
static bool call_at_points(struct interp *interp, int column, double height, bool low)
{
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_cycle defined = klartext->cycle;
	const struct klartext_call_of call = {.interp = interp, .cycle = &defined, .column = column};
	double surface = 0;
	bool good = true;

	if (defined.number == 0 || !defined.by_q || !klartext_parameter_find(&call, 203, &surface))
		return fault(&interp->at, column, "a pattern needs a cycle with Q203 that has been defined before it");
	for (int i = 0; i < klartext->points.count && good; i++) {
		const vec3 point = klartext->points.items[i];
		vec3 at = klartext_frame_point(interp);

		at.z = i > 0 && low ? at.z : height;
		good = rapid_to(interp, at);
		at.x = point.x;
		at.y = point.y;
		good = good && rapid_to(interp, at);
		memset(interp->comp.loose, 0, sizeof(interp->comp.loose));
		klartext_cycle_set(&klartext->cycle, "Q203", surface + point.z / interp->state.scale);
		good = good && klartext_cycle_carry_out(interp, column);
	}
	klartext->cycle = defined;
	return good;
}

/*
 * TNC 640 user's manual, "CYCL CALL PAT": between the points the tool is at the clearance height: where it stands in Z,
 * or the second set-up clearance, whichever is higher.
 */
bool klartext_pattern_call(struct interp *interp, int column)
{
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_call_of call = {.interp = interp, .cycle = &klartext->cycle, .column = column};
	double height = klartext_frame_point(interp).z, highest = 0, surface, second;

	if (klartext->points.count == 0)
		return fault(&interp->at, column, "CYCL CALL PAT, but no PATTERN DEF has given points");
	if (!klartext_cycle_check_values(interp, column, true))
		return false;
	if (klartext->cycle.number && klartext->cycle.by_q) {
		if (!klartext_parameter_length(&call, 203, &surface) || !klartext_parameter_length(&call, 204, &second))
			return false;
		for (int i = 0; i < klartext->points.count; i++)
			highest = fmax(highest, klartext->points.items[i].z);
		height = fmax(height, surface + highest + second);
	}
	return call_at_points(interp, column, height, false);
}

/*
 * "POLAR PATTERN (Cycle 220)", "CARTESIAN PATTERN (Cycle 221)": Q200, Q203 and Q204 count in place of the cycle's;
 * between the points the tool is at the set-up clearance, or with Q301=1 at the second one.
 */
static bool call_with(struct interp *interp, const struct klartext_call_of *pattern)
{
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_cycle defined = klartext->cycle;
	double clearance, surface, second;
	bool high, good;

	if (!klartext_parameter_need(pattern, 200, &clearance) || !klartext_parameter_need(pattern, 203, &surface) ||
	    !klartext_parameter_need(pattern, 204, &second))
		return false;
	if (!klartext_cycle_check_values(interp, pattern->column, false))
		return false;
	high = !same_double(klartext_parameter_or(pattern, 301, 1), 0);
	klartext_cycle_set(&klartext->cycle, "Q200", clearance);
	klartext_cycle_set(&klartext->cycle, "Q203", surface);
	klartext_cycle_set(&klartext->cycle, "Q204", high ? second : clearance);
	good = call_at_points(interp, pattern->column, (surface + second) * interp->state.scale, !high);
	klartext->cycle = defined;
	return good;
}

static bool whole(const struct klartext_call_of *call, int q, int *value)
{
	double number;

	if (!klartext_parameter_need(call, q, &number))
		return false;
	if (!(number >= 1 && number <= KLARTEXT_POINTS_MAX) || !same_double(floor(number), number))
		return fault(&call->interp->at, call->column, "Q%d is a whole number from 1 to %d", q,
			     KLARTEXT_POINTS_MAX);
	*value = (int)number;
	return true;
}

bool klartext_pattern_circle(struct interp *interp, const struct klartext_cycle *cycle)
{
	const struct klartext_call_of call = {.interp = interp, .cycle = cycle, .column = cycle->column};
	double diameter, start, end, step;
	vec3 centre = {0, 0, 0};
	int count;

	if (!klartext_parameter_length(&call, 216, &centre.x) || !klartext_parameter_length(&call, 217, &centre.y) ||
	    !klartext_parameter_length(&call, 244, &diameter) || !klartext_parameter_need(&call, 245, &start) ||
	    !klartext_parameter_need(&call, 246, &end) || !klartext_parameter_need(&call, 247, &step) ||
	    !whole(&call, 241, &count))
		return false;
	if (same_double(klartext_parameter_or(&call, 365, 0), 1))
		return fault(&interp->at, cycle->column,
			     "CYCL DEF 220 with Q365=1, on circles from point to point, is not "
			     "supported yet");
	/* A step of 0: the points are spread between the angles; the whole circle has no point twice. */
	if (same_double(step, 0))
		step = (end - start) / (same_double(fabs(end - start), 360) ? count : fmax(1, count - 1));
	klartext_of(interp)->points.count = 0;
	return add_circle(interp, cycle->column, centre, diameter, start, step, count) && call_with(interp, &call);
}

bool klartext_pattern_lines(struct interp *interp, const struct klartext_cycle *cycle)
{
	const struct klartext_call_of call = {.interp = interp, .cycle = cycle, .column = cycle->column};
	vec3 start = {0, 0, 0};
	double spacing[2], angle;
	int count[2];

	if (!klartext_parameter_length(&call, 225, &start.x) || !klartext_parameter_length(&call, 226, &start.y) ||
	    !klartext_parameter_length(&call, 237, &spacing[0]) ||
	    !klartext_parameter_length(&call, 238, &spacing[1]) || !whole(&call, 242, &count[0]) ||
	    !whole(&call, 243, &count[1]) || !klartext_parameter_need(&call, 224, &angle))
		return false;
	klartext_of(interp)->points.count = 0;
	return add_lines(interp, cycle->column, start, spacing, count, angle, true) && call_with(interp, &call);
}

/* -------------------------------------------------------------- definitions */

enum point_word {
	WORD_X,
	WORD_Y,
	WORD_Z,
	WORD_D,
	WORD_DX,
	WORD_DY,
	WORD_NUM,
	WORD_NUMX,
	WORD_NUMY,
	WORD_ROT,
	WORD_ROTX,
	WORD_ROTY,
	WORD_START,
	WORD_STEP,
	WORD_COUNT
};

struct item {
	bool given[WORD_COUNT];
	double value[WORD_COUNT];
	int column;
};

/* "(X+25 Y+33.5 Z+0)" */
static bool read_item(struct lexer *lexer, struct item *item)
{
	static const char *const names[] = {"X",    "Y",    "Z",   "D",	   "DX",   "DY",    "NUM",
					    "NUMX", "NUMY", "ROT", "ROTX", "ROTY", "START", "STEP"};
	const struct interp *interp = lexer->context;

	*item = (struct item){.column = klartext_column(lexer)};
	while (lexer_peek(lexer) >= '0' && lexer_peek(lexer) <= '9')
		lexer_take(lexer);
	if (lexer_peek(lexer) != '(')
		return fault(lexer->at, klartext_column(lexer), "'(' is needed here");
	lexer_take(lexer);
	while (lexer_peek(lexer) != ')') {
		const int column = klartext_column(lexer);
		char name[KLARTEXT_WORD];
		int word = 0;

		klartext_word(lexer, name);
		while (word < WORD_COUNT && strcmp(names[word], name) != 0)
			word++;
		if (word == WORD_COUNT)
			return fault(lexer->at, column, "this is no word of a pattern");
		if (!klartext_value(lexer, &item->value[word]))
			return false;
		item->given[word] = true;
		if (word <= WORD_DY)
			item->value[word] *= interp->state.scale;
	}
	lexer_take(lexer);
	return true;
}

static bool has(struct lexer *lexer, const struct item *item, const int *words, int count)
{
	for (int i = 0; i < count; i++) {
		if (!item->given[words[i]])
			return fault(lexer->at, item->column, "a word of this pattern is missing");
	}
	return true;
}

static bool find_count(struct lexer *lexer, const struct item *item, int word, int *count)
{
	const double value = item->value[word];

	if (!(value >= 1 && value <= KLARTEXT_POINTS_MAX) || !same_double(floor(value), value))
		return fault(lexer->at, item->column, "a number of points is a whole number from 1 to %d",
			     KLARTEXT_POINTS_MAX);
	*count = (int)value;
	return true;
}

/* TNC 640 user's manual, "PATTERN DEF": single points, a row, a pattern of rows, a circle, a part of a circle. */
static bool add_item(struct lexer *lexer, const char *kind, const struct item *item)
{
	struct interp *interp = lexer->context;
	const double *v = item->value;
	const vec3 start = {v[WORD_X], v[WORD_Y], v[WORD_Z]};
	const int base[] = {WORD_X, WORD_Y, WORD_D, WORD_NUM};
	int count[2] = {1, 1};

	if (!strcmp(kind, "POS"))
		return has(lexer, item, base, 2) && add_point(interp, item->column, start);
	if (!strcmp(kind, "ROW"))
		return has(lexer, item, base, 4) && find_count(lexer, item, WORD_NUM, &count[0]) &&
		       add_lines(interp, item->column, start, (double[2]){v[WORD_D], 0}, count, v[WORD_ROT], false);
	if (!strcmp(kind, "PAT")) {
		if (!same_double(v[WORD_ROTX], 0) || !same_double(v[WORD_ROTY], 0))
			return fault(lexer->at, item->column, "PAT with ROTX or ROTY is not supported yet");
		return has(lexer, item, (const int[]){WORD_X, WORD_Y, WORD_DX, WORD_DY, WORD_NUMX, WORD_NUMY}, 6) &&
		       find_count(lexer, item, WORD_NUMX, &count[0]) && find_count(lexer, item, WORD_NUMY, &count[1]) &&
		       add_lines(interp, item->column, start, (double[2]){v[WORD_DX], v[WORD_DY]}, count, v[WORD_ROT],
				 true);
	}
	if (!strcmp(kind, "CIRC"))
		return has(lexer, item, base, 4) && find_count(lexer, item, WORD_NUM, &count[0]) &&
		       add_circle(interp, item->column, start, v[WORD_D], v[WORD_START], 360.0 / count[0], count[0]);
	return has(lexer, item, base, 4) && find_count(lexer, item, WORD_NUM, &count[0]) &&
	       add_circle(interp, item->column, start, v[WORD_D], v[WORD_START], v[WORD_STEP], count[0]);
}

static bool read_items(struct lexer *lexer)
{
	while (!klartext_ends(lexer)) {
		const int column = klartext_column(lexer);
		char kind[KLARTEXT_WORD];
		struct item item;

		klartext_word(lexer, kind);
		if (strcmp(kind, "POS") != 0 && strcmp(kind, "ROW") != 0 && strcmp(kind, "PAT") != 0 &&
		    strcmp(kind, "CIRC") != 0 && strcmp(kind, "PITCHCIRC") != 0)
			return fault(lexer->at, column, "PATTERN DEF reads POS, ROW, PAT, CIRC and PITCHCIRC");
		if (!read_item(lexer, &item) || !add_item(lexer, kind, &item))
			return false;
	}
	return true;
}

bool klartext_pattern_define(struct lexer *lexer)
{
	struct interp *interp = lexer->context;

	if (!klartext_take(lexer, "DEF"))
		return fault(lexer->at, klartext_column(lexer), "PATTERN needs DEF");
	klartext_of(interp)->points.count = 0;
	klartext_of(interp)->points.line = lexer->at->line;
	return read_items(lexer);
}

bool klartext_pattern_go_on(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext_points *points = &klartext_of(interp)->points;

	if (points->line == 0 || lexer->at->line != points->line + 1)
		return fault(lexer->at, 1, "points of a pattern belong behind PATTERN DEF");
	points->line = lexer->at->line;
	return read_items(lexer);
}
