#include "gcode/dialect/klartext/klartext_pattern.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/klartext_comp.h"
#include "gcode/dialect/klartext/klartext_cycle.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/dialect/klartext/klartext_lexis.h"
#include "gcode/dialect/klartext/klartext_move.h"
#include "gcode/dialect/klartext/klartext_parameter.h"
#include "gcode/dialect/klartext/klartext_region.h"
#include "gcode/dialect/klartext/klartext_value.h"

/* ------------------------------------------------------------------- points */

bool klartext_pattern_add(struct interp *interp, int column, vec3 point)
{
	struct klartext_points *points = &klartext_of(interp)->points;

	if (points->count == KLARTEXT_POINTS_MAX)
		return fault(&interp->at, column, "a pattern has at most %d points", KLARTEXT_POINTS_MAX);
	points->items[points->count++] = point;
	return true;
}

void klartext_pattern_begin(struct interp *interp)
{
	struct klartext_points *points = &klartext_of(interp)->points;

	points->count = 0;
	points->any_order = points->surface = points->single = false;
}

static vec3 polar(vec3 from, double radius, double angle)
{
	return (vec3){from.x + radius * math_cos_degrees(angle), from.y + radius * math_sin_degrees(angle), from.z};
}

/* Rows of points. */
struct grid {
	vec3 start;
	double spacing[2]; /* along a row, and between rows */
	double angle[2]; /* degrees: of a row, and of the step to the next row */
	int count[2]; /* points of a row, and rows */
	bool zigzag; /* every second row runs backwards */
	bool frame; /* only the points at the edge */
};

static bool add_grid(struct interp *interp, int column, const struct grid *grid)
{
	const int last[2] = {grid->count[0] - 1, grid->count[1] - 1};

	for (int row = 0; row <= last[1]; row++) {
		const vec3 begin = polar(grid->start, row * grid->spacing[1], grid->angle[1]);

		for (int i = 0; i <= last[0]; i++) {
			const int at = grid->zigzag && row % 2 == 1 ? last[0] - i : i;

			if (grid->frame && row > 0 && row < last[1] && at > 0 && at < last[0])
				continue;
			if (!klartext_pattern_add(interp, column, polar(begin, at * grid->spacing[0], grid->angle[0])))
				return false;
		}
	}
	return true;
}

static bool add_circle(struct interp *interp, int column, vec3 centre, double diameter, double start, double step,
		       int count)
{
	for (int i = 0; i < count; i++) {
		if (!klartext_pattern_add(interp, column, polar(centre, diameter / 2, start + i * step)))
			return false;
	}
	return true;
}

/* -------------------------------------------------------------------- calls */

/* How the cycle is carried out at every point. */
struct visit {
	struct interp *interp;
	int column;
	double height; /* of the moves between points, programmed Z in mm */
	bool low; /* between points the tool stays at the height where the cycle has left it */
	bool rapid;
	struct canon_feed feed; /* if not rapid */
};

static bool go_to(const struct visit *visit, vec3 point)
{
	const struct klartext_target target = {.point = point, .others = visit->interp->state.position};

	return klartext_move_line(visit->interp, &target, visit->rapid, &visit->feed);
}

static bool go_up(const struct visit *visit)
{
	vec3 at = klartext_frame_point(visit->interp);

	at.z = visit->height;
	return go_to(visit, at);
}

/* Moves to a height, or at this height, anywhere in a rectangle with these half sides about the tool. */
static bool go_within(const struct visit *visit, double half_x, double half_y, double height)
{
	struct interp *interp = visit->interp;
	const struct canon_move move = {.kind = visit->rapid ? CANON_RAPID : CANON_FEED, .feed = visit->feed};
	const struct parallel_box box = klartext_frame_turned_box(interp, (const double[3]){half_x, half_y, 0});
	vec3 point = klartext_frame_point(interp), at;
	slot_values target = interp->state.position;

	point.z = height;
	at = klartext_frame_position(interp, point);
	target.v[SLOT_X] = at.x;
	target.v[SLOT_Y] = at.y;
	target.v[SLOT_Z] = at.z;
	return parallel_moves_go(interp, &target, &move, &box);
}

/*
 * Covers the moves between the points in any order: the rectangle about the points and the tool, at the height between
 * them. After the last point the tool is above any of them at the height `end`, and as far aside as the cycle leaves
 * it.
 */
static bool cover_rectangle(const struct visit *visit, bool ends, double end)
{
	struct interp *interp = visit->interp;
	const struct klartext_points *points = &klartext_of(interp)->points;
	vec3 low = klartext_frame_point(interp), high = low;
	double half_x, half_y, aside[2];

	if (klartext_frame_is_scaled(interp))
		return fault(&interp->at, visit->column,
			     "FRAME while a scaling is in force is not supported: cancel the scaling first");
	for (int i = 0; i < points->count; i++) {
		low = vec3_min(low, points->items[i]);
		high = vec3_max(high, points->items[i]);
	}
	klartext_region_find_aside(interp, aside);
	if (!go_to(visit, (vec3){(low.x + high.x) / 2, (low.y + high.y) / 2, visit->height}))
		return false;
	memset(interp->comp.loose, 0, sizeof(interp->comp.loose));
	half_x = (high.x - low.x) / 2 + aside[0];
	half_y = (high.y - low.y) / 2 + aside[1];
	if (!go_within(visit, half_x, half_y, ends ? end : visit->height))
		return false;
	if (ends)
		klartext_region_leave_open(interp, half_x, half_y);
	return true;
}

static bool call_at_points(const struct visit *visit)
{
	struct interp *interp = visit->interp;
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_cycle defined = klartext->cycles.active;
	const struct klartext_call_of call = {.interp = interp, .cycle = &defined, .column = visit->column};
	double surface = 0;
	bool good = true;

	if (defined.number == 0 || !defined.by_q || !klartext_parameter_find(&call, 203, &surface))
		return fault(&interp->at, visit->column,
			     "a pattern needs a cycle with Q203 that has been defined before it");
	if (klartext->points.surface && !same_double(surface, 0))
		return fault(&interp->at, visit->column,
			     "the points of the table have a surface in Z, and the cycle has another one in Q203: the "
			     "manual wants Q203=0");
	if (klartext->points.any_order && (!go_up(visit) || !cover_rectangle(visit, false, 0)))
		return false;
	for (int i = 0; i < klartext->points.count && good; i++) {
		const vec3 point = klartext->points.items[i];
		vec3 at = klartext_frame_point(interp);

		at.z = i > 0 && visit->low ? at.z : visit->height;
		good = go_to(visit, at);
		at.x = point.x;
		at.y = point.y;
		good = good && go_to(visit, at);
		memset(interp->comp.loose, 0, sizeof(interp->comp.loose));
		klartext_cycle_set(&klartext->cycles.active, "Q203", surface + point.z / interp->state.scale);
		good = good && klartext_cycle_carry_out(interp, visit->column);
	}
	klartext->cycles.active = defined;
	if (good && klartext->points.any_order) {
		const double end = klartext_frame_point(interp).z;

		good = go_up(visit) && cover_rectangle(visit, true, end);
	}
	return good;
}

/*
 * TNC 640 user's manual, "CYCL CALL PAT": between the points the tool is at the clearance height. This is the higher
 * one of its present Z and the second set-up clearance. F is the feed rate between the points.
 */
bool klartext_pattern_call(struct interp *interp, int column, const struct canon_feed *feed)
{
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_call_of call = {.interp = interp, .cycle = &klartext->cycles.active, .column = column};
	struct visit visit = {
	    .interp = interp, .column = column, .height = klartext_frame_point(interp).z, .rapid = !feed};
	double highest = 0, surface, second;

	if (feed)
		visit.feed = *feed;
	if (klartext->points.count == 0)
		return fault(&interp->at, column,
			     "CYCL CALL PAT, but neither PATTERN DEF nor SEL PATTERN has given points");
	/* Moves between the points are not below the present height of the tool. */
	if (!klartext_cycle_check_values(interp, column, true) ||
	    (klartext->open.height && !klartext_comp_check_known(interp, column, "CYCL CALL PAT")))
		return false;
	if (klartext->cycles.active.number && klartext->cycles.active.by_q) {
		if (!klartext_parameter_length(&call, 203, &surface) || !klartext_parameter_length(&call, 204, &second))
			return false;
		for (int i = 0; i < klartext->points.count; i++)
			highest = fmax(highest, klartext->points.items[i].z);
		visit.height = fmax(visit.height, surface + highest + second);
	}
	return call_at_points(&visit);
}

/*
 * "POLAR PATTERN (Cycle 220)", "CARTESIAN PATTERN (Cycle 221)": their Q200, Q203 and Q204 replace those of the cycle.
 * Between the points the tool is at the set-up clearance, or with Q301=1 at the second one.
 */
static bool call_with(struct interp *interp, const struct klartext_call_of *pattern)
{
	struct klartext_cycles *cycles = &klartext_of(interp)->cycles;
	const struct klartext_cycle defined = cycles->active;
	struct visit visit = {.interp = interp, .column = pattern->column, .rapid = true};
	double clearance, surface, second;
	bool high, good;

	if (!klartext_parameter_need(pattern, 200, &clearance) || !klartext_parameter_need(pattern, 203, &surface) ||
	    !klartext_parameter_need(pattern, 204, &second))
		return false;
	if (!klartext_cycle_check_values(interp, pattern->column, false))
		return false;
	high = !same_double(klartext_parameter_or(pattern, 301, 1), 0);
	klartext_cycle_set(&cycles->active, "Q200", clearance);
	klartext_cycle_set(&cycles->active, "Q203", surface);
	klartext_cycle_set(&cycles->active, "Q204", high ? second : clearance);
	visit.height = (surface + second) * interp->state.scale;
	visit.low = !high;
	good = call_at_points(&visit);
	cycles->active = defined;
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
	/* A step of 0 spreads the points over the angle; on a whole circle the last point is not the first one. */
	if (same_double(step, 0))
		step = (end - start) / (same_double(fabs(end - start), 360) ? count : fmax(1, count - 1));
	klartext_pattern_begin(interp);
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
	const struct grid grid = {.start = start,
				  .spacing = {spacing[0], spacing[1]},
				  .angle = {angle, angle + 90},
				  .count = {count[0], count[1]},
				  .zigzag = true};

	klartext_pattern_begin(interp);
	return add_grid(interp, cycle->column, &grid) && call_with(interp, &call);
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
	bool increment[2]; /* IX, IY */
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
		if (!strcmp(name, "IX") || !strcmp(name, "IY"))
			item->increment[name[1] - 'X'] = true;
		while (word < WORD_COUNT && strcmp(names[word], name + (name[0] == 'I')) != 0)
			word++;
		if (word == WORD_COUNT || (name[0] == 'I' && word > WORD_Y))
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

/*
 * A pattern of rows, or only its edge (FRAME). ROT turns the whole about its start, ROTX only the rows, and ROTY the
 * direction from row to row. The manual does not say in which order the points of a frame come.
 */
static bool add_rows(struct lexer *lexer, const struct item *item, bool frame)
{
	static const int needed[] = {WORD_X, WORD_Y, WORD_DX, WORD_DY, WORD_NUMX, WORD_NUMY};
	struct interp *interp = lexer->context;
	const double *v = item->value;
	struct grid grid = {.start = {v[WORD_X], v[WORD_Y], v[WORD_Z]},
			    .spacing = {v[WORD_DX], v[WORD_DY]},
			    .angle = {v[WORD_ROT] + v[WORD_ROTX], v[WORD_ROT] + v[WORD_ROTY] + 90},
			    .zigzag = !frame,
			    .frame = frame};

	klartext_of(interp)->points.any_order |= frame;
	return has(lexer, item, needed, 6) && find_count(lexer, item, WORD_NUMX, &grid.count[0]) &&
	       find_count(lexer, item, WORD_NUMY, &grid.count[1]) && add_grid(interp, item->column, &grid);
}

/* "POS2 (X+15 IY+6.5 Z+0)": IX and IY count from the POS before this one. */
static bool add_single(struct lexer *lexer, const struct item *item)
{
	struct interp *interp = lexer->context;
	struct klartext_points *points = &klartext_of(interp)->points;
	vec3 point = {item->value[WORD_X], item->value[WORD_Y], item->value[WORD_Z]};

	if ((item->increment[0] || item->increment[1]) && !points->single)
		return fault(lexer->at, item->column, "IX and IY need another POS right before them");
	point.x += item->increment[0] ? points->items[points->count - 1].x : 0;
	point.y += item->increment[1] ? points->items[points->count - 1].y : 0;
	points->single = true;
	return klartext_pattern_add(interp, item->column, point);
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
		return has(lexer, item, base, 2) && add_single(lexer, item);
	klartext_of(interp)->points.single = false;
	if (item->increment[0] || item->increment[1])
		return fault(lexer->at, item->column, "IX and IY belong to POS alone");
	if (!strcmp(kind, "ROW")) {
		struct grid row = {
		    .start = start, .spacing = {v[WORD_D], 0}, .angle = {v[WORD_ROT], 0}, .count = {1, 1}};

		return has(lexer, item, base, 4) && find_count(lexer, item, WORD_NUM, &row.count[0]) &&
		       add_grid(interp, item->column, &row);
	}
	if (!strcmp(kind, "PAT") || !strcmp(kind, "FRAME"))
		return add_rows(lexer, item, !strcmp(kind, "FRAME"));
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
		    strcmp(kind, "FRAME") != 0 && strcmp(kind, "CIRC") != 0 && strcmp(kind, "PITCHCIRC") != 0)
			return fault(lexer->at, column, "PATTERN DEF reads POS, ROW, PAT, FRAME, CIRC and PITCHCIRC");
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
	klartext_pattern_begin(interp);
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
