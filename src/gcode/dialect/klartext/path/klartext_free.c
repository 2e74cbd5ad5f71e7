#include "gcode/dialect/klartext/path/klartext_free.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "gcode/dialect/klartext/path/klartext_circle.h"
#include "gcode/dialect/klartext/path/klartext_free_ahead.h"
#include "gcode/dialect/klartext/path/klartext_path.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/dialect/klartext/words/klartext_free_words.h"
#include "gcode/dialect/klartext/words/klartext_words.h"
#include "geom/tolerance.h"

/* mm: the largest difference between two statements of one block about the same thing, because drawings round. */
#define AGREEMENT 0.016

static bool run(struct lexer *lexer, klartext_path_shape shape)
{
	struct strbuf rest = {0};
	struct line_place at = *lexer->at;
	struct lexer others = *lexer;
	bool good = klartext_free_words_split(lexer, &klartext_of(lexer->context)->free, &rest);

	at.text = strbuf_text(&rest);
	others.at = &at;
	good = good && klartext_path_run(&others, shape);
	if (klartext_of(lexer->context)->free.value[KLARTEXT_FREE_CLOSED] < 0)
		klartext_of(lexer->context)->free.has_begin = false;
	strbuf_release(&rest);
	return good;
}

/* --------------------------------------------------------------- solutions */

/* The data of one block. */
struct element {
	struct interp *interp;
	const struct klartext_words *words;
	const struct klartext_free *free;
	const struct klartext_path *path; /* its start */
	bool has_x, has_y, has_direction;
	double x, y; /* mm: the given coordinates of the end */
	vec3 direction; /* at the start, unit */
};

static bool open(const struct element *element, const char *what)
{
	return fault(&element->interp->at, element->words->first_column,
		     "FK: %s, or leaves several solutions: that is not supported; write the end of the element",
		     what);
}

static bool contradict(const struct element *element)
{
	return fault(&element->interp->at, element->words->first_column,
		     "FK: the data of this element contradict each other");
}

/* CLSD-: the element ends where the element with CLSD+ began. */
static bool closes(const struct element *element)
{
	return element->free->value[KLARTEXT_FREE_CLOSED] < 0 && element->free->has_begin;
}

/*
 * Finds the end from X and Y, from PR and PA, or from CLSD- at the end of a closed contour. False: the block does not
 * give it.
 */
static bool has_end(const struct element *element, vec3 *end)
{
	const struct klartext_free *free = element->free;
	const double *v = free->value;

	if (element->has_x && element->has_y) {
		end->x = element->x;
		end->y = element->y;
		return true;
	}
	if (closes(element)) {
		end->x = free->begin[0];
		end->y = free->begin[1];
		return true;
	}
	if (!free->has_pole || !free->has[KLARTEXT_FREE_PR] || !free->has[KLARTEXT_FREE_PA])
		return false;
	end->x = free->pole[0] + v[KLARTEXT_FREE_PR] * math_cos_degrees(v[KLARTEXT_FREE_PA]);
	end->y = free->pole[1] + v[KLARTEXT_FREE_PR] * math_sin_degrees(v[KLARTEXT_FREE_PA]);
	return true;
}

/* Do all given data of the end agree with this point? */
static bool agrees(const struct element *element, vec3 end)
{
	vec3 polar = end;

	if ((element->has_x && fabs(end.x - element->x) > AGREEMENT) ||
	    (element->has_y && fabs(end.y - element->y) > AGREEMENT))
		return false;
	return (!element->free->has[KLARTEXT_FREE_PR] && !closes(element)) ||
	       (has_end(element, &polar) && vec3_norm(vec3_sub(polar, end)) <= AGREEMENT);
}

static bool begin(struct interp *interp, const struct klartext_words *words, const struct klartext_target *target,
		  const struct klartext_path *path, bool tangential, struct element *element)
{
	struct klartext_free *free = &klartext_of(interp)->free;
	vec3 before = {0, 0, 0};
	const bool known = klartext_move_end_direction(&klartext_of(interp)->last, &before) &&
			   fabs(before.z) <= SAME_POINT;

	*element = (struct element){.interp = interp,
				    .words = words,
				    .free = free,
				    .path = path,
				    .has_x = klartext_words_has(words, SLOT_X),
				    .has_y = klartext_words_has(words, SLOT_Y),
				    .x = target->point.x,
				    .y = target->point.y};
	if (free->value[KLARTEXT_FREE_CLOSED] > 0) {
		free->has_begin = true;
		free->begin[0] = path->start.x;
		free->begin[1] = path->start.y;
	}
	if (words->increments || words->has_radius || words->has_angle || klartext_words_has(words, SLOT_Z))
		return fault(&interp->at, words->first_column,
			     "FK reads absolute coordinates of X and Y; increments and Z are not supported");
	if (free->has[KLARTEXT_FREE_PR] != free->has[KLARTEXT_FREE_PA] ||
	    free->has[KLARTEXT_FREE_CCPR] != free->has[KLARTEXT_FREE_CCPA])
		return open(element, "one polar coordinate alone does not determine the element");
	if (free->has[KLARTEXT_FREE_PR] && (element->has_x || element->has_y))
		return open(element, "an end in X or Y and in polar coordinates is not read");
	if ((free->has[KLARTEXT_FREE_PR] || free->has[KLARTEXT_FREE_CCPR]) && !free->has_pole)
		return fault(&interp->at, words->first_column, "polar coordinates of FK need FPOL before them");
	if ((tangential || free->has[KLARTEXT_FREE_IAN]) && !known)
		return fault(&interp->at, words->first_column,
			     "a tangential element needs a path block before it that moves in the plane");
	if (free->has[KLARTEXT_FREE_AN])
		element->direction = (vec3){math_cos_degrees(free->value[KLARTEXT_FREE_AN]),
					    math_sin_degrees(free->value[KLARTEXT_FREE_AN]), 0};
	else if (tangential)
		element->direction = before;
	element->has_direction = free->has[KLARTEXT_FREE_AN] || tangential;
	if (tangential && vec3_norm(vec3_sub(element->direction, before)) > 1e-3)
		return contradict(element);
	if (free->has[KLARTEXT_FREE_IAN])
		return open(element, "an angle that counts from the element before (IAN) is not read");
	return true;
}

/*
 * Finds the point where a tangential element leaves this circle. The element is a straight line that ends at the next
 * circle, or it is the next circle itself. The unit vector n points to the left of the common direction: the element
 * touches each circle at the point centre - turn radius n. False: the two circles have no such tangent.
 */
static bool leave_circle(const struct klartext_free_circle *circle, const struct klartext_free_ahead *ahead, vec3 *end)
{
	const vec3 z = {0, 0, 1},
		   way = {ahead->circle.centre.x - circle->centre.x, ahead->circle.centre.y - circle->centre.y, 0};
	const double across = ahead->circle.turn * ahead->circle.radius - circle->turn * circle->radius;
	const double length = vec3_norm(way);
	double sine;
	vec3 left;

	if (!(length > SAME_POINT) || (ahead->line ? fabs(across) >= length : fabs(fabs(across) - length) > AGREEMENT))
		return false;
	sine = ahead->line ? across / length : across > 0 ? 1 : -1;
	left = vec3_scale(sine / length, way);
	left = vec3_mad(left, sqrt(1 - sine * sine) / length, vec3_cross(z, way));
	*end = vec3_mad(circle->centre, -circle->turn * circle->radius, left);
	return true;
}

/* The end of a straight line that is tangential to the circle after it. False: there is no such circle. */
static bool find_touch(const struct element *element, vec3 *end)
{
	const vec3 start = element->path->start, direction = element->direction;
	struct klartext_free_ahead ahead;
	vec3 way, left;

	if (!klartext_free_ahead_read(element->interp, &ahead) || ahead.line)
		return false;
	way = (vec3){ahead.circle.centre.x - start.x, ahead.circle.centre.y - start.y, 0};
	left = vec3_cross((vec3){0, 0, 1}, direction);
	if (!(vec3_dot(way, direction) > SAME_POINT) ||
	    fabs(vec3_dot(way, left) - ahead.circle.turn * ahead.circle.radius) > AGREEMENT)
		return false;
	*end = vec3_mad(start, vec3_dot(way, direction), direction);
	return true;
}

/*
 * The distance along the direction to the end that one given coordinate determines; not positive: there is no such end.
 */
static double way_along(const struct element *element)
{
	const vec3 start = element->path->start, direction = element->direction;

	if (element->has_x && fabs(direction.x) > DIRECTION_TOLERANCE)
		return (element->x - start.x) / direction.x;
	if (element->has_y && fabs(direction.y) > DIRECTION_TOLERANCE)
		return (element->y - start.y) / direction.y;
	return element->free->has[KLARTEXT_FREE_LEN] ? element->free->value[KLARTEXT_FREE_LEN] : 0;
}

static bool solve_line(const struct element *element, struct klartext_target *target)
{
	const vec3 start = element->path->start;
	vec3 end = start, way;

	if (!has_end(element, &end)) {
		if (!element->has_direction)
			return open(element, "the block does not say where its line ends");
		if (!element->has_x && !element->has_y && !element->free->has[KLARTEXT_FREE_LEN]) {
			if (!find_touch(element, &end))
				return open(element, "the block does not say where its line ends");
		} else if (!(way_along(element) > 0)) {
			return contradict(element);
		} else {
			end = vec3_mad(start, way_along(element), element->direction);
		}
	}
	way = vec3_sub(end, start);
	if (!agrees(element, end) || !(vec3_norm(way) > SAME_POINT) ||
	    (element->free->has[KLARTEXT_FREE_LEN] &&
	     fabs(vec3_norm(way) - element->free->value[KLARTEXT_FREE_LEN]) > AGREEMENT) ||
	    (element->has_direction &&
	     vec3_norm(vec3_mad(way, -vec3_norm(way), element->direction)) > AGREEMENT))
		return contradict(element);
	target->point.x = end.x;
	target->point.y = end.y;
	return true;
}

/* The centre, from its coordinates, or from the radius and the direction at the start. False: reported. */
static bool find_centre(const struct element *element, vec3 *centre)
{
	const struct klartext_free *free = element->free;
	const double *v = free->value;
	const vec3 z = {0, 0, 1};
	vec3 end = element->path->start;

	*centre = end;
	if (free->has[KLARTEXT_FREE_CCX] && free->has[KLARTEXT_FREE_CCY]) {
		centre->x = v[KLARTEXT_FREE_CCX];
		centre->y = v[KLARTEXT_FREE_CCY];
	} else if (free->has[KLARTEXT_FREE_CCPR]) {
		centre->x = free->pole[0] + v[KLARTEXT_FREE_CCPR] * math_cos_degrees(v[KLARTEXT_FREE_CCPA]);
		centre->y = free->pole[1] + v[KLARTEXT_FREE_CCPR] * math_sin_degrees(v[KLARTEXT_FREE_CCPA]);
	} else if (element->has_direction && element->words->has_size && element->words->size > 0) {
		*centre = vec3_mad(*centre, element->words->direction * element->words->size,
				   vec3_cross(z, element->direction));
	} else if (!element->has_direction || !has_end(element, &end)) {
		return open(element, "the block does not say where the centre of its circle is");
	} else {
		/* The centre lies on the normal at the start and has the same distance from the start and the end. */
		const vec3 across = vec3_cross(z, element->direction), way = vec3_sub(end, element->path->start);

		if (!(fabs(vec3_dot(across, way)) > SAME_POINT))
			return contradict(element);
		*centre = vec3_mad(*centre, vec3_norm2(way) / (2 * vec3_dot(across, way)), across);
	}
	return true;
}

/* Do all given data of the circle agree with this centre? */
static bool circle_agrees(const struct element *element, vec3 centre)
{
	const struct klartext_free *free = element->free;
	const vec3 z = {0, 0, 1}, radius = vec3_sub(element->path->start, centre);
	const vec3 start = vec3_scale(element->words->direction, vec3_cross(z, vec3_unit(radius)));

	return (!element->words->has_size || fabs(vec3_norm(radius) - element->words->size) <= AGREEMENT) &&
	       (!free->has[KLARTEXT_FREE_CCX] || fabs(free->value[KLARTEXT_FREE_CCX] - centre.x) <= AGREEMENT) &&
	       (!free->has[KLARTEXT_FREE_CCY] || fabs(free->value[KLARTEXT_FREE_CCY] - centre.y) <= AGREEMENT) &&
	       (!element->has_direction ||
		vec3_norm(vec3_sub(start, element->direction)) * vec3_norm(radius) <= AGREEMENT);
}

static bool solve_circle(const struct element *element, struct klartext_target *target, struct klartext_path *path)
{
	const double turn = element->free->value[KLARTEXT_FREE_CCA];
	struct klartext_free_ahead ahead;
	vec3 centre, end = path->start, radius;

	if (!element->words->direction)
		return fault(&element->interp->at, element->words->first_column,
			     "FC and FCT need their direction of rotation, DR+ or DR-");
	if (element->free->has[KLARTEXT_FREE_LEN])
		return open(element, "the length of a chord (LEN) does not determine a circle");
	if (!find_centre(element, &centre))
		return false;
	radius = vec3_sub(path->start, centre);
	if (!(vec3_norm(radius) > SAME_POINT) || !circle_agrees(element, centre))
		return contradict(element);
	if (!element->free->has[KLARTEXT_FREE_CCA] && !has_end(element, &end)) {
		const struct klartext_free_circle circle = {centre, vec3_norm(radius), element->words->direction};

		if (!klartext_free_ahead_read(element->interp, &ahead) || !leave_circle(&circle, &ahead, &end))
			return open(element, "the block does not say where its circle ends");
	} else if (element->free->has[KLARTEXT_FREE_CCA] && (closes(element) || !has_end(element, &end))) {
		if (!(turn > 0 && turn < 360))
			return contradict(element);
		const mat3 rotation = mat3_turn((vec3){0, 0, 1}, radians(element->words->direction * turn));

		end = vec3_add(centre, mat3_apply(&rotation, radius));
	} else if (element->free->has[KLARTEXT_FREE_CCA]) {
		return open(element, "a circle with CCA beside its end is not read");
	}
	if (!agrees(element, end))
		return contradict(element);
	target->point.x = end.x;
	target->point.y = end.y;
	return klartext_circle_fill(element->interp, path, target->point, centre, element->words->direction,
				    element->words->first_column);
}

/* ------------------------------------------------------------------ blocks */

static bool shape_line(struct interp *interp, const struct klartext_words *words, struct klartext_target *target,
		       struct klartext_path *path)
{
	struct element element;

	return begin(interp, words, target, path, false, &element) && solve_line(&element, target);
}

static bool shape_line_tangential(struct interp *interp, const struct klartext_words *words,
				  struct klartext_target *target, struct klartext_path *path)
{
	struct element element;

	return begin(interp, words, target, path, true, &element) && solve_line(&element, target);
}

static bool shape_circle(struct interp *interp, const struct klartext_words *words, struct klartext_target *target,
			 struct klartext_path *path)
{
	struct element element;

	return begin(interp, words, target, path, false, &element) && solve_circle(&element, target, path);
}

static bool shape_circle_tangential(struct interp *interp, const struct klartext_words *words,
				    struct klartext_target *target, struct klartext_path *path)
{
	struct element element;

	return begin(interp, words, target, path, true, &element) && solve_circle(&element, target, path);
}

bool klartext_free_line(struct lexer *lexer)
{
	return run(lexer, shape_line);
}

bool klartext_free_line_tangential(struct lexer *lexer)
{
	return run(lexer, shape_line_tangential);
}

bool klartext_free_circle(struct lexer *lexer)
{
	return run(lexer, shape_circle);
}

bool klartext_free_circle_tangential(struct lexer *lexer)
{
	return run(lexer, shape_circle_tangential);
}

bool klartext_free_pole(struct lexer *lexer)
{
	struct klartext_free *free = &klartext_of(lexer->context)->free;
	const unsigned plane = 1U << SLOT_X | 1U << SLOT_Y;
	struct klartext_words words;

	if (!klartext_words_read(lexer, &words))
		return false;
	if (words.axes != plane || words.increments || words.m_count || words.feed || words.comp)
		return fault(lexer->at, words.first_column, "FPOL needs absolute coordinates of X and Y, alone");
	free->has_pole = true;
	free->pole[0] = words.value[SLOT_X];
	free->pole[1] = words.value[SLOT_Y];
	return true;
}

bool klartext_free_select(struct lexer *lexer)
{
	return fault(lexer->at, 1,
		     "FSELECT chooses one of several solutions, which are not worked out here: write the end of the "
		     "element before it");
}
