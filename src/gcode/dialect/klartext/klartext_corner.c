#include "gcode/dialect/klartext/klartext_corner.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/units.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/dialect/klartext/klartext_lexis.h"
#include "gcode/dialect/klartext/klartext_value.h"
#include "gcode/execute/motion_commands.h"
#include "geom/tolerance.h"

/* Bytes that are enough for a block number and a word. */
#define LOOK_AHEAD 32

/* ------------------------------------------------------------- looking ahead */

static bool begins_corner(const char *text, size_t length)
{
	size_t at = 0;

	while (at < length && (text[at] == ' ' || text[at] == '\t' || (text[at] >= '0' && text[at] <= '9')))
		at++;
	return length - at >= 3 && (!strncmp(text + at, "RND", 3) || !strncmp(text + at, "CHF", 3)) &&
	       (length - at == 3 || !isalpha((unsigned char)text[at + 3]));
}

bool klartext_corner_follows(struct interp *interp)
{
	struct klartext *klartext = klartext_of(interp);
	struct reader *reader = &interp->program.source->reader;
	const struct position next = source_next(interp->program.source);
	const long furthest = reader->furthest;
	const char *text;
	bool corner;

	if (reader_peek(reader, LOOK_AHEAD, &text))
		return begins_corner(text, LOOK_AHEAD);
	/* The next line is not in the buffer: reading it moves the one in hand. */
	strbuf_clear(&klartext->line);
	strbuf_addf(&klartext->line, "%s", interp->at.text);
	interp->at.text = strbuf_text(&klartext->line);
	corner = reader_next(reader, &text) == READER_LINE && begins_corner(text, strlen(text));
	reader_seek(reader, next.offset, next.line);
	reader->furthest = furthest;
	return corner;
}

/* -------------------------------------------------------------------- corners */

bool klartext_corner_check_none(struct interp *interp)
{
	const struct klartext_corner *corner = &klartext_of(interp)->corner;
	const struct line_place at = {interp->at.diag, interp->at.file, corner->line, ""};

	return !corner->waits ||
	       fault(&at, corner->column, "RND and CHF need a straight line in the plane behind them");
}

bool klartext_corner_hold(struct interp *interp, const struct klartext_target *target, const struct klartext_path *path)
{
	struct klartext *klartext = klartext_of(interp);
	struct comp_item item = {.kind = COMP_PAUSE,
				 .move = {.kind = path->rapid ? CANON_RAPID : CANON_FEED, .feed = path->feed}};
	vec3 end = klartext_frame_position(interp, target->point);

	if (path->arc || target->turns)
		return fault(&interp->at, 1,
			     "RND and CHF behind a circle or a move of a rotary axis are not supported yet");
	motion_commands_fill(interp, &item.move);
	item.move.end = interp->state.canonical;
	item.move.end.v[SLOT_X] = end.x;
	item.move.end.v[SLOT_Y] = end.y;
	item.move.end.v[SLOT_Z] = end.z;
	if (!motion_commands_enqueue(interp, &item))
		return false;
	state_set_position(&interp->state, SLOT_X, end.x);
	state_set_position(&interp->state, SLOT_Y, end.y);
	state_set_position(&interp->state, SLOT_Z, end.z);
	klartext->moved = true;
	klartext->programmed = target->point;
	klartext->corner = (struct klartext_corner){.waits = true, .line = interp->at.line, .column = 1};
	return true;
}

bool klartext_corner_read(struct lexer *lexer, bool chamfer)
{
	struct interp *interp = lexer->context;
	struct klartext_corner *corner = &klartext_of(interp)->corner;
	int column = klartext_column(lexer);
	double feed = 0;

	if (!corner->waits || corner->size > 0)
		return fault(lexer->at, column, "%s needs a straight line right before it", chamfer ? "CHF" : "RND");
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

/* Sends what was kept back, its first move ending at the corner's start. */
static bool release(struct interp *interp, vec3 end)
{
	struct comp_queue *queue = &interp->comp.queue;
	bool good = true;

	for (size_t i = 0; i < queue->count && good; i++) {
		struct comp_item *item = &queue->items[i];
		const struct canon_move *move = &item->move;

		if (item->kind == COMP_BLOCK) {
			good = canon_tell_block(
			    interp->sink, &(struct canon_block){move->file, move->line, item->text, move->number});
			continue;
		}
		if (i == 0) {
			item->move.end.v[SLOT_X] = end.x;
			item->move.end.v[SLOT_Y] = end.y;
			item->move.end.v[SLOT_Z] = end.z;
		}
		good = canon_tell_move(interp->sink, &item->move);
	}
	comp_queue_release(queue);
	return good;
}

static void put_position(struct interp *interp, vec3 at)
{
	state_set_position(&interp->state, SLOT_X, at.x);
	state_set_position(&interp->state, SLOT_Y, at.y);
	state_set_position(&interp->state, SLOT_Z, at.z);
}

/* Directions into the corner and out of it, and how far they are cut off. False: reported. */
static bool find_legs(struct interp *interp, const struct klartext_path *before, const struct klartext_path *after,
		      vec3 *in, vec3 *out, double *leg, double *turn)
{
	const struct klartext_corner *corner = &klartext_of(interp)->corner;
	vec3 ways[2] = {vec3_sub(before->end, before->start), vec3_sub(after->end, after->start)};
	double lengths[2] = {vec3_norm(ways[0]), vec3_norm(ways[1])};

	if (after->arc)
		return fault(&interp->at, 1, "RND and CHF in front of a circle are not supported yet");
	if (!(lengths[0] > SAME_POINT) || !(lengths[1] > SAME_POINT) || fabs(ways[0].z) > SAME_POINT ||
	    fabs(ways[1].z) > SAME_POINT)
		return fault(&interp->at, 1, "RND and CHF need two straight lines in the plane of X and Y");
	*in = vec3_scale(1 / lengths[0], ways[0]);
	*out = vec3_scale(1 / lengths[1], ways[1]);
	*turn = atan2(in->x * out->y - in->y * out->x, vec3_dot(*in, *out));
	if (fabs(*turn) > radians(179.999))
		return fault(&interp->at, 1, "the path goes back the way it has come: there is no corner to cut off");
	*leg = corner->chamfer ? corner->size : corner->size * tan(fabs(*turn) / 2);
	if (*leg > fmin(lengths[0], lengths[1]) + SAME_POINT)
		return fault(&interp->at, 1,
			     "the %s of %.6g mm does not fit between these lines, which are %.6g and %.6g mm long",
			     corner->chamfer ? "chamfer" : "rounding", corner->size, lengths[0], lengths[1]);
	return true;
}

/* An arc, or a straight line, from the present position to the other end of the corner. */
static bool cut_off(struct interp *interp, const struct klartext_path *arc, vec3 end)
{
	struct klartext_target target = {.point = end, .others = interp->state.position};

	return klartext_of(interp)->corner.chamfer ? klartext_move_line(interp, &target, false, &arc->feed)
						   : klartext_move_arc(interp, &target, arc);
}

/*
 * iTNC 530 user's manual, "Corner rounding RND": a tangential arc; "Inserting a chamfer CHF": the chamfer's side
 * length, which is taken for what is cut off from each line.
 */
bool klartext_corner_make(struct interp *interp, struct klartext_path *path)
{
	struct klartext *klartext = klartext_of(interp);
	struct klartext_corner *corner = &klartext->corner;
	struct klartext_path arc = {.known = true, .arc = true, .normal = {0, 0, 1}, .feed = klartext->last.feed};
	vec3 in, out, first, second;
	double leg, turn;

	if (!(corner->size > 0))
		return klartext_corner_check_none(interp);
	if (klartext->last.rapid || path->rapid)
		return fault(&interp->at, 1, "RND and CHF beside a move at FMAX are not supported");
	if (!find_legs(interp, &klartext->last, path, &in, &out, &leg, &turn) ||
	    !klartext_move_check_arc(interp, &arc, 1))
		return false;
	corner->waits = false;
	first = vec3_mad(klartext->last.end, -leg, in);
	second = vec3_mad(klartext->last.end, leg, out);
	put_position(interp, klartext_frame_position(interp, first));
	if (!release(interp, klartext_frame_position(interp, first)))
		return false;
	path->start = second;
	if (!(fabs(turn) > 0))
		return true;
	arc.centre = vec3_mad(first, corner->size * (turn > 0 ? 1 : -1), vec3_cross((vec3){0, 0, 1}, in));
	arc.sweep = turn;
	arc.feed.linear = corner->feed > 0 ? corner->feed : arc.feed.linear;
	return cut_off(interp, &arc, second);
}
