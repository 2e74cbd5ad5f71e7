/* gcode_case.h - runs a program text through the interpreter and writes down what it makes of it. */
#ifndef GCODE_CASE_H
#define GCODE_CASE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/strbuf.h"
#include "base/units.h"
#include "gcode/dialect/dialects.h"
#include "gcode/interp.h"
#include "suite.h"

struct gcode_case {
	struct gcode_config config;
	bool show_feed, show_blend, show_spread, show_turn_spread;
	int stop_at;	/* the sink wants no more after so many moves; 0: never */
	bool refuse_tcp;
	/* What came of it. */
	struct strbuf moves;	/* a line a move, of the machine's axes, in mm and degrees */
	struct strbuf blocks;	/* "line:moves:text" */
	struct strbuf messages;
	struct diag diag;
	int count;
	long lines;
	struct kinematics_tcp tcp;
};

static inline void case_note(void *context, const struct diag_entry *entry)
{
	diag_format(&((struct gcode_case *)context)->messages, entry);
}

/* A linear machine in X Y Z with rotary A and C. */
static inline void case_init(struct gcode_case *c)
{
	*c = (struct gcode_case){.config.dialect = &dialect_linuxcnc, .diag = {.handle = case_note}};
	for (int slot = SLOT_X; slot <= SLOT_C; slot++)
		c->config.has_axis[slot] = slot != SLOT_B;
	/* The parameters of a control that has them, so that short programs can be read. */
	c->config.controller.least_input = 1;
	c->config.controller.power_on_units = POWER_ON_MM;
	c->config.controller.power_on_distance = POWER_ON_ABSOLUTE;
	c->config.controller.power_on_plane = POWER_ON_XY;
}

static inline void case_release(struct gcode_case *c)
{
	strbuf_release(&c->moves);
	strbuf_release(&c->blocks);
	strbuf_release(&c->messages);
}

static inline double tidy(double value)
{
	return fabs(value) < 5e-10 ? 0 : value;
}

static inline void case_write_arc(struct gcode_case *c, const struct canon_arc *arc)
{
	strbuf_addf(&c->moves, " centre %.9g %.9g %.9g normal %g %g %g sweep %.9g", tidy(arc->centre.x),
		    tidy(arc->centre.y), tidy(arc->centre.z), tidy(arc->normal.x), tidy(arc->normal.y), tidy(arc->normal.z),
		    degrees(arc->sweep));
}

static inline bool case_move(struct gcode_case *c, const struct canon_move *move)
{
	static const char *const names[] = {"rapid", "feed", "arc", "dwell", "tool"};

	/* Its tests are those of the whole program. */
	if (move->kind == CANON_SPINDLE_STOP)
		return true;

	strbuf_addf(&c->moves, "%s", names[move->kind]);
	if (move->kind == CANON_DWELL)
		strbuf_addf(&c->moves, " %.9g", move->seconds);
	if (move->kind == CANON_TOOL_CHANGE)
		strbuf_addf(&c->moves, " %d", move->tool);
	for (int slot = 0; slot < SLOT_COUNT && move->kind <= CANON_ARC; slot++) {
		double v = move->end.v[slot];

		if (c->config.has_axis[slot])
			strbuf_addf(&c->moves, " %.9g", tidy(slot_is_rotary(slot) ? degrees(v) : v));
	}
	if (move->kind == CANON_ARC)
		case_write_arc(c, &move->arc);
	if (c->show_feed && move->feed.inverse_time)
		strbuf_addf(&c->moves, " in %.9g s", move->feed.seconds);
	else if (c->show_feed && move->kind != CANON_RAPID)
		strbuf_addf(&c->moves, " at %.9g %.9g", move->feed.linear, degrees(move->feed.angular));
	if (c->show_blend)
		strbuf_addf(&c->moves, move->blend ? " blend %.9g" : " exact", move->blend_tolerance);
	if (c->show_blend && move->blend_turn > 0)
		strbuf_addf(&c->moves, " turn %.9g", degrees(move->blend_turn));
	if (c->show_spread && move->spread[0] + move->spread[1] + move->spread[2] > 0)
		strbuf_addf(&c->moves, " spread %.9g %.9g %.9g", move->spread[0], move->spread[1], move->spread[2]);
	if (c->show_turn_spread)
		strbuf_addf(&c->moves, " turned by %.4f %.4f %.4f", degrees(move->turn_spread[0]),
			    degrees(move->turn_spread[1]), degrees(move->turn_spread[2]));
	strbuf_addf(&c->moves, "%s%s\n", move->apart ? " apart" : "", move->tcp ? " tcp" : "");
	return ++c->count != c->stop_at;
}

/*
 * The control of a table that turns with C about the machine's Z, tool along
 * Z: the machine stands at R(C - C0) p + length, where p is the position under TCP.
 */
static inline void case_turn(axis_values *position, double angle, double rise)
{
	double x = position->v[SLOT_X], y = position->v[SLOT_Y];

	position->v[SLOT_X] = cos(angle) * x - sin(angle) * y;
	position->v[SLOT_Y] = sin(angle) * x + cos(angle) * y;
	position->v[SLOT_Z] += rise;
}

static inline bool case_tcp(void *context, const struct kinematics_tcp *tcp, struct srcloc loc, axis_values *position)
{
	struct gcode_case *c = context;

	if (c->refuse_tcp) {
		diag_error(&c->diag, loc, "no TCP here");
		return false;
	}
	if (c->tcp.on)
		case_turn(position, position->v[SLOT_C] - c->tcp.rotary_zero.v[SLOT_C], c->tcp.length);
	if (tcp->on)
		case_turn(position, tcp->rotary_zero.v[SLOT_C] - position->v[SLOT_C], -tcp->length);
	c->tcp = *tcp;
	strbuf_addf(&c->moves, "tcp %s length %.9g zero A%.9g C%.9g\n", tcp->on ? "on" : "off", tcp->length,
		    degrees(tcp->rotary_zero.v[SLOT_A]), degrees(tcp->rotary_zero.v[SLOT_C]));
	return true;
}

/*
 * The control of case_turn's table, with A on it that tilts the tool's direction
 * about X: direction = (0, sin A, cos A).
 */
static inline bool case_orient(void *context, struct srcloc loc, struct kinematics_orientation *orientation)
{
	struct gcode_case *c = context;

	if (fabs(orientation->direction.x) > 1e-9) {
		diag_error(&c->diag, loc, "no such plane here");
		return false;
	}
	orientation->rotary.v[SLOT_A] = atan2(orientation->direction.y, orientation->direction.z);
	strbuf_addf(&c->moves, "orient %.9g %.9g %.9g\n", tidy(orientation->direction.x),
		    tidy(orientation->direction.y), tidy(orientation->direction.z));
	return true;
}

/* The same table, and A standing still on it. */
static inline bool case_table_point(void *context, struct srcloc loc, axis_values *place)
{
	struct gcode_case *c = context;

	if (c->refuse_tcp) {
		diag_error(&c->diag, loc, "nothing is carried here");
		return false;
	}
	case_turn(place, place->v[SLOT_C], 0);
	return true;
}

/* The same of A for controls that choose themselves: C can stand anywhere only where the tool stands upright. */
static inline bool case_orientations(void *context, struct srcloc loc, const struct kinematics_orientation *orientation,
				     struct kinematics_solutions *solutions)
{
	struct kinematics_orientation copy = *orientation;

	*solutions = (struct kinematics_solutions){.count = 1, .primary = SLOT_A};
	if (!case_orient(context, loc, &copy))
		return false;
	solutions->items[0] = (struct kinematics_solution){.rotary = copy.rotary, .within_limits = true};
	solutions->items[0].free[SLOT_C] = fabs(orientation->direction.y) < 1e-9;
	return true;
}

/* Z is the tool's axis and ends at 500. */
static inline bool case_direction(void *context, struct srcloc loc, const axis_values *rotary_zero,
				  const axis_values *rotary, vec3 *direction)
{
	(void)context;
	(void)loc;
	(void)rotary_zero;
	*direction = (vec3){0, sin(rotary->v[SLOT_A]), cos(rotary->v[SLOT_A])};
	return true;
}

/* The table of case_turn on A, which tilts it about X. */
static inline bool case_turn_of(void *context, struct srcloc loc, struct kinematics_turn *turn)
{
	const mat3 a = mat3_turn((vec3){1, 0, 0}, -turn->rotary.v[SLOT_A]), c = mat3_turn((vec3){0, 0, 1}, -turn->rotary.v[SLOT_C]);

	(void)context;
	(void)loc;
	turn->turn = mat3_mul(&c, &a);
	turn->tool = turn->turn.z;
	return true;
}

/*
 * A turns by as much as the tool, and never lies at a pole; pieces of more than a third are too long. In a turn by 80
 * degrees C goes from 0 to 90 in the middle, as beside a pole.
 */
static inline bool case_great_circle(void *context, struct srcloc loc, struct kinematics_great_circle *piece)
{
	const double whole = atan2(piece->to.y, piece->to.z) - atan2(piece->from.y, piece->from.z);

	(void)context;
	(void)loc;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		piece->beside[slot] = piece->s1 - piece->s0 > 1.0 / 3 ? 1 : slot == SLOT_A ? 1e-6 : 0;
	piece->rotary.v[SLOT_A] += whole * (piece->s1 - piece->s0);
	if (fabs(degrees(whole) - 80) < 1e-6)
		piece->rotary.v[SLOT_C] = piece->s1 > 0.5 ? radians(90) : 0;
	return true;
}

static inline bool case_retract(void *context, struct srcloc loc, struct kinematics_retract *retract)
{
	(void)context;
	(void)loc;
	retract->position.v[SLOT_Z] = retract->to_limit ? 500 : retract->position.v[SLOT_Z] + retract->distance;
	return true;
}

static inline struct kinematics case_kinematics(struct gcode_case *c)
{
	return (struct kinematics){
		.context = c, .tcp = case_tcp, .orient = case_orient, .orientations = case_orientations,
		.direction = case_direction, .turn = case_turn_of, .great_circle = case_great_circle, .retract = case_retract, .table_point = case_table_point};
}

static inline bool case_event(void *context, const struct canon_event *event)
{
	struct gcode_case *c = context;
	const struct canon_block *block = event->of.block;

	if (event->kind == CANON_MOVE)
		return case_move(c, event->of.move);
	strbuf_addf(&c->blocks, "%ld:%d:%s\n", block->line, block->moves, block->text);
	return true;
}

static inline bool case_run_stream(struct gcode_case *c, FILE *in)
{
	struct canon_sink sink = {.context = c, .event = case_event};
	struct kinematics kinematics = case_kinematics(c);
	struct interp *interp;
	bool good;

	c->diag.context = c;
	interp = interp_new(&c->config, &kinematics, &sink, &c->diag);
	good = interp_run(interp, in, "p.nc");
	c->lines = interp_lines(interp);
	interp_free(interp);
	return good;
}

static inline bool case_run_bytes(struct gcode_case *c, const char *bytes, size_t length)
{
	FILE *in = tmpfile();
	bool good;

	ck_assert_ptr_nonnull(in);
	ck_assert_uint_eq(fwrite(bytes, 1, length, in), length);
	rewind(in);
	good = case_run_stream(c, in);
	fclose(in);
	return good;
}

static inline bool case_run(struct gcode_case *c, const char *program)
{
	return case_run_bytes(c, program, strlen(program));
}

/* The program must run to its end, make these moves, and say nothing. */
static inline void case_expect(struct gcode_case *c, const char *program, const char *moves)
{
	bool good = case_run(c, program);

	ck_assert_str_eq(strbuf_text(&c->messages), "");
	ck_assert_str_eq(strbuf_text(&c->moves), moves);
	ck_assert(good);
	case_release(c);
}

/* The same on a fresh machine. */
static inline void expect_moves(const char *program, const char *moves)
{
	struct gcode_case c;

	case_init(&c);
	case_expect(&c, program, moves);
}

#endif
