#include "gcode/dialect/klartext/path/klartext_corner.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/machine/klartext_m.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/execute/arc.h"
#include "gcode/execute/cutter_comp/comp_turn.h"
#include "geom/tolerance.h"

/* The number of bytes that always contain the block number and the first word. */
#define LOOK_AHEAD 32

/* Radians: a path that turns less has no corner to cut off. */
#define FLAT_CORNER 1e-9

/* ------------------------------------------------------------- looking ahead */

static bool begins_corner(const char *text, size_t length)
{
	size_t at = 0;

	while (at < length && (text[at] == ' ' || text[at] == '\t' || ascii_is_digit(text[at])))
		at++;
	return length - at >= 3 && (!strncmp(text + at, "RND", 3) || !strncmp(text + at, "CHF", 3)) &&
	       (length - at == 3 || !ascii_is_letter(text[at + 3]));
}

bool klartext_corner_follows(struct interp *interp)
{
	struct reader *reader = &interp->program.source->reader;
	struct reader_mark mark;
	const char *text;
	bool corner;

	if (reader_peek(reader, LOOK_AHEAD, &text))
		return begins_corner(text, LOOK_AHEAD);
	/* The next line is not in the buffer. */
	program_keep_line(&interp->program, &interp->at);
	mark = reader_mark(reader);
	corner = reader_next(reader, &text) == READER_LINE && begins_corner(text, strlen(text));
	reader_return(reader, &mark);
	return corner;
}

/* -------------------------------------------------------------------- corners */

bool klartext_corner_check_none(struct interp *interp)
{
	struct klartext_corner *corner = &klartext_of(interp)->corner;
	const struct line_place at = {interp->at.diag, interp->at.file, corner->line, ""};

	if (!corner->waits)
		return true;
	/* The fault is reported once only. */
	corner->waits = false;
	return fault(&at, corner->column, "RND and CHF need a line or a circle in the plane behind them");
}

bool klartext_corner_hold(struct interp *interp, const struct klartext_words *words,
			  const struct klartext_target *target, const struct klartext_path *path)
{
	struct klartext *klartext = klartext_of(interp);
	struct klartext_corner *corner = &klartext->corner;

	if (target->turns || words->axes >> SLOT_A)
		return fault(&interp->at, words->first_column,
			     "RND and CHF behind a move of other axes than X, Y and Z are not supported");
	if (!klartext_m_check_harmless(interp, words, "in the block before RND or CHF", false))
		return false;
	corner->waits = true;
	corner->size = corner->feed = 0;
	corner->path = *path;
	corner->path_line = corner->line = interp->at.line;
	corner->column = 1;
	corner->spindle = interp->state.spindle;
	corner->speed_is_zero = interp->state.speed_is_zero;
	klartext_move_put(interp, target->point);
	klartext->tool.moved = true;
	klartext->programmed = target->point;
	return true;
}

void klartext_corner_keep_line(struct interp *interp)
{
	struct klartext_corner *corner = &klartext_of(interp)->corner;
	struct strbuf *text = corner->size > 0 ? &corner->text : &corner->path_text;

	/* CC between the corner and its circle is not a line that a message shows. */
	if (interp->at.line != corner->line)
		return;
	strbuf_clear(text);
	strbuf_addf(text, "%s", interp->at.text);
}

static bool read_corner(struct lexer *lexer, struct klartext_corner *corner, bool chamfer)
{
	struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer);
	double feed = 0;

	if (!corner->waits || corner->size > 0)
		return fault(lexer->at, column, "%s needs a line or a circle right before it", chamfer ? "CHF" : "RND");
	if (!chamfer && !klartext_take(lexer, "R"))
		return fault(lexer->at, column, "RND needs its radius in R");
	if (!klartext_value(lexer, &corner->size))
		return false;
	corner->size *= interp->state.scale;
	if (!(corner->size > 0))
		return fault(lexer->at, column, "%s must be more than 0", chamfer ? "a chamfer" : "the radius of RND");
	if (klartext_take(lexer, "F")) {
		if (!klartext_value(lexer, &feed))
			return false;
		if (!(feed > 0))
			return fault(lexer->at, column, "a feed rate must be more than 0");
		corner->feed = feed * (interp->state.scale > 1 ? interp->state.scale / 10 : 1) / SECONDS_PER_MINUTE;
	}
	corner->chamfer = chamfer;
	corner->line = interp->at.line;
	corner->column = column;
	return klartext_expect_end(lexer);
}

bool klartext_corner_read(struct lexer *lexer, bool chamfer)
{
	struct klartext_corner *corner = &klartext_of(lexer->context)->corner;
	bool good = read_corner(lexer, corner, chamfer);

	/* What is reported of this line is not reported again of the block before it. */
	corner->waits = corner->waits && good;
	return good;
}

/* -------------------------------------------------------------------- shape */

/* A corner between the held block and the next one, in the plane of X and Y of programmed coordinates. */
struct shape {
	vec3 first, last; /* where it starts and ends */
	vec3 centre; /* of a rounding */
	double turn; /* radians about Z */
};

static struct plane_point flat(vec3 v)
{
	return (struct plane_point){v.x, v.y};
}

static struct comp_way way_of(const struct klartext_path *path, double side)
{
	struct comp_way way = {.is_arc = path->arc, .point = flat(path->start)};

	if (!path->arc)
		return way;
	way.centre = flat(path->centre);
	way.clockwise = path->sweep < 0;
	way.inside = (side > 0) != way.clockwise;
	return way;
}

/* The point where the rounding about this centre touches the path. */
static vec3 touch(const struct klartext_path *path, vec3 corner, vec3 direction, vec3 centre)
{
	if (!path->arc)
		return vec3_mad(corner, vec3_dot(vec3_sub(centre, corner), direction), direction);
	return vec3_mad(path->centre, vec3_norm(vec3_sub(corner, path->centre)),
			vec3_unit(vec3_sub(centre, path->centre)));
}

static double sweep_between(const struct klartext_path *path, vec3 from, vec3 to)
{
	return arc_sweep(flat(from), flat(to), flat(path->centre), path->sweep < 0, 1, 0);
}

/* Does the point lie on the path? Its end is where the corner was. */
static bool reaches(const struct klartext_path *path, vec3 point)
{
	const vec3 way = vec3_sub(path->end, path->start);
	const double share = vec3_dot(vec3_sub(point, path->start), way) / vec3_norm2(way);
	const double slack = SAME_POINT / vec3_norm(way);

	if (!path->arc)
		return share >= -slack && share <= 1 + slack;
	return fabs(sweep_between(path, path->start, point)) <= fabs(path->sweep) && fabs(path->sweep) <= 2 * PI;
}

static bool is_flat(const struct klartext_path *path)
{
	return fabs(path->end.z - path->start.z) <= SAME_POINT && (!path->arc || path->normal.z > 0.5) &&
	       vec3_norm(vec3_sub(path->arc ? path->centre : path->end, path->start)) > SAME_POINT;
}

static bool find_rounding(const struct klartext_path *before, const struct klartext_path *after, vec3 in, vec3 out,
			  double radius, struct shape *shape)
{
	const double side = shape->turn > 0 ? 1 : -1;
	const struct comp_way ways[2] = {way_of(before, side), way_of(after, side)};
	const struct comp_corner_shape corner = {.before = &ways[0],
						 .after = &ways[1],
						 .at = flat(after->start),
						 .ahead = flat(in),
						 .onward = flat(out),
						 .radius = radius,
						 .side = side};
	struct plane_point centre;

	if (!comp_turn_crossing(&corner, &centre))
		return false;
	shape->centre = (vec3){centre.a, centre.b, after->start.z};
	shape->first = touch(before, after->start, in, shape->centre);
	shape->last = touch(after, after->start, out, shape->centre);
	return true;
}

/* False: reported. */
static bool find_shape(struct interp *interp, const struct klartext_path *after, struct shape *shape)
{
	const struct klartext_corner *corner = &klartext_of(interp)->corner;
	const struct klartext_path *before = &corner->path;
	const char *what = corner->chamfer ? "chamfer" : "rounding";
	vec3 in, out;

	if (!is_flat(before) || !is_flat(after) || !klartext_move_end_direction(before, &in) ||
	    !klartext_move_start_direction(after, &out))
		return fault(&interp->at, after->column,
			     "RND and CHF need lines or circles in the plane of X and Y on both sides");
	if (corner->chamfer && (before->arc || after->arc))
		return fault(&interp->at, after->column, "CHF needs straight lines on both sides");
	shape->turn = math_atan2(in.x * out.y - in.y * out.x, vec3_dot(in, out));
	if (fabs(shape->turn) > radians(179.999))
		return fault(&interp->at, after->column,
			     "the path goes back the way it has come: there is no corner to cut off");
	shape->first = shape->last = shape->centre = after->start;
	if (corner->chamfer) {
		shape->first = vec3_mad(after->start, -corner->size, in);
		shape->last = vec3_mad(after->start, corner->size, out);
	} else if (fabs(shape->turn) > FLAT_CORNER && !find_rounding(before, after, in, out, corner->size, shape)) {
		return fault(&interp->at, after->column, "the rounding of %.6g mm does not touch both paths",
			     corner->size);
	}
	if (!corner->chamfer && !(fabs(shape->turn) > FLAT_CORNER))
		return true;
	return (reaches(before, shape->first) && reaches(after, shape->last)) ||
	       fault(&interp->at, after->column, "the %s of %.6g mm is longer than one of the paths beside it", what,
		     corner->size);
}

/* --------------------------------------------------------------------- moves */

/*
 * Carries out the held block up to this point as if it were the current block, then ends the held line and the line of
 * the corner.
 */
static bool release(struct interp *interp, vec3 end)
{
	const struct line_place at = interp->at;
	const enum spindle_turn spindle = interp->state.spindle;
	const bool speed_is_zero = interp->state.speed_is_zero;
	struct klartext_corner *corner = &klartext_of(interp)->corner;
	struct klartext_path path = corner->path;
	struct klartext_target target = {.point = end};
	bool good;

	klartext_move_put(interp, path.start);
	target.others = interp->state.position;
	path.end = end;
	if (path.arc)
		path.sweep = sweep_between(&path, path.start, end);
	interp->at.line = corner->path_line;
	interp->at.text = strbuf_text(&corner->path_text);
	interp->state.spindle = corner->spindle;
	interp->state.speed_is_zero = corner->speed_is_zero;
	good = klartext_comp_go(interp, &target, &path) && cutter_comp_end_block(interp);
	interp->moves = 0;
	interp->at.line = corner->line;
	interp->at.text = strbuf_text(&corner->text);
	interp->comp.moved = true;
	good = good && cutter_comp_end_block(interp);
	interp->at = at;
	interp->state.spindle = spindle;
	interp->state.speed_is_zero = speed_is_zero;
	return good;
}

/* Moves from the present position to the other end of the corner, on an arc or a straight line. */
static bool cut_off(struct interp *interp, const struct shape *shape, const struct klartext_path *after)
{
	const struct klartext_corner *corner = &klartext_of(interp)->corner;
	const struct klartext_target target = {.point = shape->last, .others = interp->state.position};
	struct klartext_path path = {.known = true,
				     .arc = !corner->chamfer,
				     .start = shape->first,
				     .end = shape->last,
				     .centre = shape->centre,
				     .normal = {0, 0, 1},
				     .sweep = shape->turn,
				     .feed = corner->path.feed,
				     .column = after->column};

	if (!(fabs(shape->turn) > FLAT_CORNER))
		return true;
	if (path.arc)
		path.sweep = arc_sweep(flat(path.start), flat(path.end), flat(path.centre), shape->turn < 0, 1, 0);
	path.feed.linear = corner->feed > 0 ? corner->feed : path.feed.linear;
	return (!path.arc || klartext_move_check_arc(interp, &path, after->column)) &&
	       klartext_comp_go(interp, &target, &path);
}

/*
 * iTNC 530 user's manual, "Corner rounding RND": a tangential arc. "Inserting a chamfer CHF": the side length of the
 * chamfer, which is taken as the length cut off each line.
 */
bool klartext_corner_make(struct interp *interp, const struct klartext_words *words, struct klartext_path *path)
{
	struct klartext_corner *corner = &klartext_of(interp)->corner;
	struct shape shape = {.turn = 0};

	if (!(corner->size > 0))
		return klartext_corner_check_none(interp);
	if (corner->path.rapid || path->rapid)
		return fault(&interp->at, path->column, "RND and CHF beside a move at FMAX are not supported");
	if (words->comp != KLARTEXT_R_NONE && klartext_comp_is_selected(interp) != (words->comp != KLARTEXT_R0))
		return fault(&interp->at, words->comp_column,
			     "RND and CHF right before the block that starts or ends radius compensation are not "
			     "supported");
	if (!find_shape(interp, path, &shape))
		return false;
	corner->waits = false;
	if (!release(interp, shape.first) || !cut_off(interp, &shape, path))
		return false;
	path->start = shape.last;
	if (path->arc)
		path->sweep = fabs(path->sweep) >= 2 * PI ? path->sweep : sweep_between(path, path->start, path->end);
	return true;
}
