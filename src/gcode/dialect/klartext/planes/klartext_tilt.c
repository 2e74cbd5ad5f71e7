#include "gcode/dialect/klartext/planes/klartext_tilt.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/units.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "geom/tolerance.h"

static const vec3 unit_x = {1, 0, 0}, unit_y = {0, 1, 0}, unit_z = {0, 0, 1};

/* Reads a named value that the statement must have. False: reported. */
static bool need(struct lexer *lexer, const char *name, double *value)
{
	if (!klartext_take(lexer, name))
		return fault(lexer->at, lexer_next_column(lexer), "%s is needed here", name);
	return klartext_value(lexer, value);
}

static mat3 turned(vec3 axis, double angle)
{
	return mat3_turn(axis, radians(angle));
}

mat3 klartext_tilt_spatial(const double angle[3])
{
	mat3 x = turned(unit_x, angle[0]), y = turned(unit_y, angle[1]), z = turned(unit_z, angle[2]);

	y = mat3_mul(&y, &x);
	return mat3_mul(&z, &y);
}

static bool read_spatial(struct lexer *lexer, mat3 *tilt)
{
	double angle[3];

	if (!need(lexer, "SPA", &angle[0]) || !need(lexer, "SPB", &angle[1]) || !need(lexer, "SPC", &angle[2]))
		return false;
	*tilt = klartext_tilt_spatial(angle);
	return true;
}

/* "PLANE EULER": turns by EULPR about Z, by EULNU about the new X, and by EULROT about the new Z. */
static bool read_euler(struct lexer *lexer, mat3 *tilt)
{
	double first, second, third;
	mat3 a, b, c;

	if (!need(lexer, "EULPR", &first) || !need(lexer, "EULNU", &second) || !need(lexer, "EULROT", &third))
		return false;
	a = turned(unit_z, first);
	b = turned(unit_x, second);
	c = turned(unit_z, third);
	a = mat3_mul(&a, &b);
	*tilt = mat3_mul(&a, &c);
	return true;
}

/*
 * TNC7 user's manual, "PLANE PROJECTED": the plane cuts ZX at the angle PROPR to X and YZ at the angle PROMIN to Y. A
 * positive PROMIN rises ("PROPR+0 PROMIN+45 ROT+0" is the plane of SPA+45). ROT turns the X of the plane about its Z.
 * Only a figure shows to which side PROPR counts.
 */
static bool read_projected(struct lexer *lexer, mat3 *tilt)
{
	const int column = lexer_next_column(lexer);
	double principal, minor, rotation;
	mat3 turn;

	if (!need(lexer, "PROPR", &principal) || !need(lexer, "PROMIN", &minor) || !need(lexer, "ROT", &rotation))
		return false;
	if (fabs(principal) > 0)
		return fault(
		    lexer->at, column,
		    "PLANE PROJECTED with PROPR other than 0: to which side it counts is not known here; write "
		    "the plane as PLANE SPATIAL or PLANE VECTOR");
	if (!(fabs(minor) < 90))
		return fault(lexer->at, column, "PROMIN is between -90 and 90 degrees");
	*tilt = turned(unit_x, minor);
	turn = turned(unit_z, rotation);
	*tilt = mat3_mul(tilt, &turn);
	return true;
}

/*
 * X is the component of `base` in the plane, Z the direction of the normal. False: the two are parallel, which was
 * reported.
 */
static bool from_vectors(struct lexer *lexer, vec3 base, vec3 normal, int column, mat3 *tilt)
{
	if (!(vec3_norm(normal) > DIRECTION_TOLERANCE) || !(vec3_norm(base) > DIRECTION_TOLERANCE))
		return fault(lexer->at, column, "a vector of length 0 has no direction");
	normal = vec3_unit(normal);
	base = vec3_mad(base, -vec3_dot(base, normal), normal);
	if (!(vec3_norm(base) > DIRECTION_TOLERANCE))
		return fault(lexer->at, column, "the base vector must not be parallel to the normal");
	base = vec3_unit(base);
	*tilt = (mat3){base, vec3_cross(normal, base), normal};
	return true;
}

/*
 * "PLANE VECTOR": B, the base vector, gives the tilted X; N, the normal, gives the tilted Z. The control makes B
 * perpendicular to N (iTNC 530 user's manual).
 */
static bool read_vector(struct lexer *lexer, mat3 *tilt)
{
	int column = lexer_next_column(lexer);
	vec3 b = {0, 0, 0}, n = {0, 0, 0};

	return need(lexer, "BX", &b.x) && need(lexer, "BY", &b.y) && need(lexer, "BZ", &b.z) &&
	       need(lexer, "NX", &n.x) && need(lexer, "NY", &n.y) && need(lexer, "NZ", &n.z) &&
	       from_vectors(lexer, b, n, column, tilt);
}

static bool read_point(struct lexer *lexer, char number, vec3 *point)
{
	char names[3][4] = {"P1X", "P1Y", "P1Z"};

	for (int i = 0; i < 3; i++)
		names[i][1] = number;
	return need(lexer, names[0], &point->x) && need(lexer, names[1], &point->y) && need(lexer, names[2], &point->z);
}

/*
 * "PLANE POINTS": X runs from point 1 to point 2; point 3 lies on the side of positive Y; the system is right-handed.
 */
static bool read_points(struct lexer *lexer, mat3 *tilt)
{
	int column = lexer_next_column(lexer);
	vec3 p[3], base;

	for (int i = 0; i < 3; i++) {
		if (!read_point(lexer, (char)('1' + i), &p[i]))
			return false;
	}
	base = vec3_sub(p[1], p[0]);
	return from_vectors(lexer, base, vec3_cross(base, vec3_sub(p[2], p[0])), column, tilt);
}

/* "PLANE RELATIVE": one more rotation about an axis of the plane in force. */
static bool read_relative(struct lexer *lexer, const mat3 *before, mat3 *tilt)
{
	double angle;
	vec3 axis;
	mat3 turn;

	if (klartext_take(lexer, "SPA"))
		axis = unit_x;
	else if (klartext_take(lexer, "SPB"))
		axis = unit_y;
	else if (klartext_take(lexer, "SPC"))
		axis = unit_z;
	else
		return fault(lexer->at, lexer_next_column(lexer), "PLANE RELATIVE needs SPA, SPB or SPC");
	if (!klartext_value(lexer, &angle))
		return false;
	turn = turned(axis, angle);
	*tilt = mat3_mul(before, &turn);
	return true;
}

/* "PLANE AXIAL A+45 IC-30": an increment counts from the present position of the axis. */
static bool read_axial(struct lexer *lexer, struct klartext_tilt *tilt)
{
	const struct state *state = &((const struct interp *)lexer->context)->state;
	const bool *has_axis = ((const struct interp *)lexer->context)->config->has_axis;

	for (;;) {
		const int column = lexer_next_column(lexer);
		struct lexer ahead = *lexer;
		const bool increment = ascii_upper(lexer_peek(&ahead)) == 'I';
		int slot;

		if (increment)
			lexer_take(&ahead);
		slot = ascii_upper(lexer_peek(&ahead)) - 'A' + SLOT_A;
		if (slot < SLOT_A || slot > SLOT_C)
			break;
		lexer_take(&ahead);
		/* A letter without a value begins another word, such as ABST or COORD. */
		if (!klartext_value_follows(&ahead))
			break;
		if (!has_axis[slot])
			return fault(lexer->at, column, "the machine has no %c axis", AXIS_LETTERS[slot]);
		*lexer = ahead;
		if (!klartext_value(lexer, &tilt->angle[slot]))
			return false;
		tilt->angle[slot] += increment ? state->position.v[slot] - state->offset.v[slot] : 0;
		tilt->axes |= 1U << slot;
	}
	return tilt->axes || fault(lexer->at, lexer_next_column(lexer), "PLANE AXIAL needs A, B or C");
}

bool klartext_tilt_read(struct lexer *lexer, const mat3 *before, struct klartext_tilt *tilt)
{
	int column = lexer_next_column(lexer);
	char kind[KLARTEXT_WORD];

	klartext_word(lexer, kind);
	*tilt = (struct klartext_tilt){.reset = !strcmp(kind, "RESET"), .turn = mat3_identity()};
	if (tilt->reset)
		return true;
	if (!strcmp(kind, "SPATIAL"))
		return read_spatial(lexer, &tilt->turn);
	if (!strcmp(kind, "EULER"))
		return read_euler(lexer, &tilt->turn);
	if (!strcmp(kind, "VECTOR"))
		return read_vector(lexer, &tilt->turn);
	if (!strcmp(kind, "POINTS"))
		return read_points(lexer, &tilt->turn);
	if (!strcmp(kind, "RELATIVE") || !strcmp(kind, "RELATIV"))
		return read_relative(lexer, before, &tilt->turn);
	if (!strcmp(kind, "AXIAL"))
		return read_axial(lexer, tilt);
	if (!strcmp(kind, "PROJECTED"))
		return read_projected(lexer, &tilt->turn);
	return fault(lexer->at, column,
		     "PLANE needs SPATIAL, PROJECTED, AXIAL, EULER, VECTOR, POINTS, RELATIVE or RESET");
}
