#include "gcode/dialect/klartext/path/klartext_approach.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/machine/klartext_m.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/moves/klartext_tangent.h"
#include "gcode/dialect/klartext/path/klartext_corner.h"
#include "gcode/dialect/klartext/path/klartext_pole.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "geom/tolerance.h"

/*
 * iTNC 530 user's manual, "Contour approach and departure": the contour begins at PA and ends at PE. PH is the point
 * between the start of APPR and PA; PN is the end of DEP. LT: a straight line of length LEN that touches the contour.
 * LN: a straight line across the contour, as long as LEN and the tool's radius together. CT: a circle of radius R
 * through the angle CCA that touches the contour. LCT: the same circle and a straight line that touches the circle. At
 * the PN of LT and CT the tool's centre is at the programmed point. "Important positions for approach and departure":
 * if Z is programmed, the tool first goes to PH or PN in the plane, then to its height. Newer controls move all axes at
 * once to the PH of LCT. Both ways of LCT are checked.
 */

/* ------------------------------------------------------------------ geometry */

static int side_of(const struct interp *interp)
{
	return interp->comp.side;
}

/* An arc of the contour about `centre`, from one point to another. */
static struct klartext_path arc_between(const struct klartext_path *like, vec3 start, vec3 end, vec3 centre, int turn)
{
	struct klartext_path arc = *like;
	const double from = math_atan2(start.y - centre.y, start.x - centre.x),
		     to = math_atan2(end.y - centre.y, end.x - centre.x);
	double sweep = fmod(turn * (to - from), 2 * PI);

	sweep = sweep <= 1e-9 ? sweep + 2 * PI : sweep;
	arc.known = arc.arc = true;
	arc.rapid = false;
	arc.start = start;
	arc.end = end;
	arc.centre = (vec3){centre.x, centre.y, start.z};
	arc.normal = (vec3){0, 0, 1};
	arc.sweep = turn * sweep;
	return arc;
}

static struct klartext_path line_between(const struct klartext_path *like, vec3 start, vec3 end)
{
	struct klartext_path line = *like;

	line.known = true;
	line.arc = false;
	line.start = start;
	line.end = end;
	return line;
}

static bool go(struct interp *interp, const struct klartext_path *path)
{
	const struct klartext_target target = {.point = path->end, .others = interp->state.position};

	return klartext_comp_go(interp, &target, path);
}

/* ---------------------------------------------------------------------- words */

static const char *const kinds[] = {"LT", "LN", "CT", "LCT"};

/* LT, LN, CT or LCT; a P in front of it means polar coordinates. */
static bool read_kind(struct lexer *lexer, enum klartext_way *kind, bool *polar)
{
	const int column = lexer_next_column(lexer);
	char word[KLARTEXT_WORD];
	const char *bare = word;

	klartext_word(lexer, word);
	*polar = word[0] == 'P';
	bare += *polar;
	for (size_t i = 0; i < sizeof(kinds) / sizeof(kinds[0]); i++) {
		if (!strcmp(bare, kinds[i])) {
			*kind = (enum klartext_way)i;
			return true;
		}
	}
	return fault(lexer->at, column, "APPR and DEP need LT, LN, CT or LCT, or PLT, PLN, PCT or PLCT");
}

static struct klartext_way_words way_words(const struct klartext_words *words)
{
	return (struct klartext_way_words){.length = words->length,
					   .size = words->size,
					   .centre_angle = words->centre_angle,
					   .comp = words->comp,
					   .comp_column = words->comp_column,
					   .size_column = words->size_column,
					   .first_column = words->first_column};
}

static bool check_words(struct interp *interp, const struct klartext_words *words, enum klartext_way kind, bool departs)
{
	if (words->axes & ~(1U << SLOT_X | 1U << SLOT_Y | 1U << SLOT_Z))
		return fault(&interp->at, words->first_column, "APPR and DEP have coordinates of X, Y and Z alone");
	if ((kind == KLARTEXT_WAY_LT || kind == KLARTEXT_WAY_LN) && !(words->has_length && words->length > 0))
		return fault(&interp->at, words->first_column, "%s needs LEN, more than 0", kinds[kind]);
	if (kind == KLARTEXT_WAY_CT &&
	    !(words->has_centre_angle && words->centre_angle > 0 && words->centre_angle < 360))
		return fault(&interp->at, words->first_column, "CT needs CCA, between 0 and 360 degrees");
	if ((kind == KLARTEXT_WAY_CT || kind == KLARTEXT_WAY_LCT) && !(words->has_size && fabs(words->size) > 0))
		return fault(&interp->at, words->first_column, "%s needs the radius of its circle in R", kinds[kind]);
	if (kind == KLARTEXT_WAY_LCT && words->size < 0)
		return fault(&interp->at, words->size_column, "R of LCT must be more than 0");
	return klartext_m_check_harmless(interp, words, departs ? "beside DEP" : "beside APPR", departs);
}

/* The point that the words name. */
static bool find_point(struct interp *interp, const struct klartext_words *words, bool polar, vec3 *point)
{
	const vec3 here = klartext_frame_point(interp);
	struct klartext_target target;
	struct klartext_path path = {.start = here};

	if (!klartext_move_target(interp, words, &target))
		return false;
	if (polar && !klartext_pole_point(interp, words, &path, &target))
		return false;
	*point = target.point;
	return true;
}

/* ----------------------------------------------------------------------- APPR */

bool klartext_approach_read(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext *klartext = klartext_of(interp);
	struct klartext_approach *approach = &klartext->approach;
	struct klartext_words words;
	struct klartext_path path = {.known = true};
	enum klartext_way kind;
	vec3 point;
	bool polar;

	if (!read_kind(lexer, &kind, &polar) || !klartext_words_read(lexer, &words) ||
	    !check_words(interp, &words, kind, false))
		return false;
	if (klartext_comp_is_selected(interp))
		return fault(lexer->at, words.first_column, "APPR under radius compensation: DEP or R0 comes first");
	if (words.comp != KLARTEXT_RL && words.comp != KLARTEXT_RR)
		return fault(lexer->at, words.first_column, "APPR needs RL or RR");
	if (!klartext_comp_check_known(interp, words.first_column, "APPR") || !klartext_m_start(interp, &words) ||
	    !klartext_move_feed(interp, &words, &path.rapid, &path.feed) || !find_point(interp, &words, polar, &point))
		return false;
	if (path.rapid)
		return fault(lexer->at, words.feed_column, "APPR cannot be moved at FMAX; it needs F");
	path.column = words.first_column;
	path.start = klartext_frame_point(interp);
	path.end = point;
	approach->waits = true;
	approach->kind = kind;
	approach->words = way_words(&words);
	approach->path = path;
	approach->rapid_before = klartext->last.rapid;
	approach->line = interp->at.line;
	klartext->programmed = point;
	klartext_move_put(interp, point);
	klartext->last.known = false;
	return true;
}

void klartext_approach_keep_line(struct interp *interp)
{
	struct strbuf *text = &klartext_of(interp)->approach.text;

	if (interp->at.line != klartext_of(interp)->approach.line)
		return;
	strbuf_clear(text);
	strbuf_addf(text, "%s", interp->at.text);
}

bool klartext_approach_check_none(struct interp *interp)
{
	struct klartext_approach *approach = &klartext_of(interp)->approach;
	const struct line_place at = {interp->at.diag, interp->at.file, approach->line, ""};

	if (!approach->waits)
		return true;
	/* The fault is reported once only. */
	approach->waits = false;
	return fault(&at, 1, "APPR needs a straight line or a circle in the plane of X and Y right behind it");
}

/* Finds PH and the path from PH to PA. The tool's centre at PH is found for LCT only. False: reported. */
static bool find_approach(struct interp *interp, vec3 direction, struct klartext_tangent_helper *helper,
			  struct klartext_path *last)
{
	const struct klartext_approach *approach = &klartext_of(interp)->approach;
	const struct klartext_way_words *words = &approach->words;
	const vec3 point = approach->path.end;
	const int side = side_of(interp);
	struct klartext_tangent_circle circle;

	switch (approach->kind) {
	case KLARTEXT_WAY_LT:
		helper->contour = vec3_mad(point, -words->length, direction);
		*last = line_between(&approach->path, helper->contour, point);
		return true;
	case KLARTEXT_WAY_LN:
		helper->contour =
		    vec3_mad(point, words->length + interp->comp.radius, klartext_tangent_across(direction, side));
		*last = line_between(&approach->path, helper->contour, point);
		return true;
	default:
		break;
	}
	if (!klartext_tangent_circle_find(interp, point, direction, words, &circle))
		return false;
	if (approach->kind == KLARTEXT_WAY_LCT) {
		if (!klartext_tangent_touch(interp, approach->path.start, &circle, words, circle.turn, helper))
			return false;
	} else {
		helper->contour =
		    vec3_add(circle.centre, klartext_tangent_turned(vec3_sub(point, circle.centre),
								    -circle.turn * radians(words->centre_angle)));
		helper->contour.z = point.z;
	}
	*last = arc_between(&approach->path, helper->contour, point, circle.centre, circle.turn);
	return true;
}

static bool changes_height(vec3 from, vec3 to)
{
	return fabs(from.z - to.z) > SAME_POINT;
}

/* Moves all axes at once to the end and back: the control may choose this way, too. */
static bool go_and_return(struct interp *interp, const struct klartext_path *path)
{
	struct klartext_path back = *path;

	back.start = path->end;
	back.end = path->start;
	return klartext_comp_move_bare(interp, path) && klartext_comp_move_bare(interp, &back);
}

/* Moves in the plane first, then along Z; `send` makes each move. */
static bool go_to_height(struct interp *interp, const struct klartext_path *path,
			 bool (*send)(struct interp *interp, const struct klartext_path *path))
{
	struct klartext_path level = *path, down = *path;

	level.end.z = down.start.z = path->start.z;
	down.start.x = path->end.x;
	down.start.y = path->end.y;
	return send(interp, &level) && (!changes_height(path->start, path->end) || send(interp, &down));
}

/* From PS to PH and from there to PA. */
static bool carry_out(struct interp *interp, vec3 direction)
{
	const struct klartext_approach *approach = &klartext_of(interp)->approach;
	struct klartext_path first, straight, last = {.known = false};
	struct klartext_tangent_helper helper;
	int side;

	if (!klartext_comp_begin(interp, approach->words.comp, approach->words.comp_column) ||
	    !find_approach(interp, direction, &helper, &last))
		return false;
	first = line_between(&approach->path, approach->path.start, helper.contour);
	first.rapid = approach->rapid_before;
	straight = first;
	straight.end = helper.tool;
	side = interp->comp.side;
	interp->comp.side = 0;
	if (approach->kind == KLARTEXT_WAY_LCT && changes_height(first.start, first.end) &&
	    !go_and_return(interp, &straight))
		return false;
	if (approach->kind != KLARTEXT_WAY_LN) {
		interp->comp.side = side;
		return go_to_height(interp, &first, go) && go(interp, &last);
	}
	/* The tool's centre goes to PH without compensation. */
	if (!go_to_height(interp, &first, klartext_comp_move_bare))
		return false;
	interp->comp.side = side;
	return go(interp, &last);
}

bool klartext_approach_make(struct interp *interp, const struct klartext_path *first)
{
	struct klartext_approach *approach = &klartext_of(interp)->approach;
	const struct line_place at = interp->at;
	const int moves = interp->moves;
	vec3 direction;
	bool good;

	if (!klartext_move_start_direction(first, &direction) || !klartext_tangent_flatten(&direction) ||
	    first->rapid || (first->arc && !(first->normal.z > 0.5)))
		return klartext_approach_check_none(interp);
	approach->waits = false;
	interp->at.line = approach->line;
	interp->at.text = strbuf_text(&approach->text);
	interp->moves = 0;
	klartext_move_put(interp, approach->path.start);
	good = carry_out(interp, direction) && cutter_comp_end_block(interp);
	interp->at = at;
	interp->moves = moves;
	return good;
}

/* ------------------------------------------------------------------------ DEP */

/* Along Z to the height of DEP, where the tool has left the contour. */
static bool rise(struct interp *interp, const struct klartext_path *like, double height)
{
	struct klartext_target target = {.point = klartext_frame_point(interp), .others = interp->state.position};

	if (!(fabs(target.point.z - height) > SAME_POINT))
		return true;
	target.point.z = height;
	return klartext_move_line(interp, &target, false, &like->feed);
}

/*
 * Moves to PN at its height, then back to the start and to PN again with all axes at once: the control may choose
 * either way.
 */
static bool rise_both_ways(struct interp *interp, const struct klartext_path *line, double height)
{
	const vec3 high = {line->end.x, line->end.y, height}, points[3] = {high, line->start, high};

	if (!changes_height(line->start, high))
		return true;
	for (int i = 0; i < 3; i++) {
		const struct klartext_target target = {.point = points[i], .others = interp->state.position};
		struct canon_move move = {.kind = CANON_FEED, .feed = line->feed};

		if (!klartext_move_turning(interp, &target, &move))
			return false;
	}
	return true;
}

/* A circle, and then a straight line to PN. */
static bool leave_by_circle_and_line(struct interp *interp, const struct klartext_way_words *words, vec3 direction,
				     vec3 point, const struct klartext_path *like)
{
	const vec3 here = klartext_frame_point(interp);
	struct klartext_path arc, line;
	struct klartext_tangent_circle circle;
	struct klartext_tangent_helper end;

	if (!klartext_tangent_circle_find(interp, here, direction, words, &circle) ||
	    !klartext_tangent_touch(interp, point, &circle, words, -circle.turn, &end))
		return false;
	arc = arc_between(like, here, end.contour, circle.centre, circle.turn);
	line = line_between(like, end.contour, point);
	line.end.z = here.z;
	if (!go(interp, &arc) || !klartext_comp_leave(interp, &line, words->first_column) || !go(interp, &line))
		return false;
	line.start = end.tool;
	return rise_both_ways(interp, &line, point.z);
}

/* Departs from PE; LT and CT end beside the contour. */
static bool leave(struct interp *interp, const struct klartext_way_words *words, enum klartext_way kind, vec3 point,
		  const struct klartext_path *like)
{
	const vec3 here = klartext_frame_point(interp);
	const int side = side_of(interp);
	struct klartext_path path;
	struct klartext_tangent_circle circle;
	vec3 direction, end;

	if (!klartext_move_end_direction(&klartext_of(interp)->last, &direction) ||
	    !klartext_tangent_flatten(&direction))
		return fault(&interp->at, words->first_column, "DEP needs a path block of the contour right before it");
	switch (kind) {
	case KLARTEXT_WAY_LN:
		path = line_between(
		    like, here,
		    vec3_mad(here, words->length + interp->comp.radius, klartext_tangent_across(direction, side)));
		return klartext_comp_leave(interp, &path, words->first_column) && go(interp, &path);
	case KLARTEXT_WAY_LT:
		path = line_between(like, here, vec3_mad(here, words->length, direction));
		break;
	case KLARTEXT_WAY_CT:
		if (!klartext_tangent_circle_find(interp, here, direction, words, &circle))
			return false;
		end = vec3_add(circle.centre, klartext_tangent_turned(vec3_sub(here, circle.centre),
								      circle.turn * radians(words->centre_angle)));
		end.z = here.z;
		path = arc_between(like, here, end, circle.centre, circle.turn);
		break;
	default:
		return leave_by_circle_and_line(interp, words, direction, point, like);
	}
	return go(interp, &path) && klartext_comp_leave_standing(interp, words->first_column);
}

bool klartext_approach_depart(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext_words words;
	struct klartext_way_words way;
	struct klartext_path path = {.known = true};
	enum klartext_way kind;
	vec3 point = klartext_frame_point(interp);
	bool polar;

	if (!read_kind(lexer, &kind, &polar) || !klartext_words_read(lexer, &words) ||
	    !check_words(interp, &words, kind, true))
		return false;
	if (!klartext_comp_is_selected(interp))
		return fault(lexer->at, words.first_column,
			     "DEP without radius compensation (RL, RR) is not supported");
	if (!klartext_corner_check_none(interp) || !klartext_m_start(interp, &words) ||
	    !klartext_move_feed(interp, &words, &path.rapid, &path.feed))
		return false;
	if (kind != KLARTEXT_WAY_LCT && (words.axes & ~(1U << SLOT_Z) || words.has_radius || words.has_angle))
		return fault(lexer->at, words.first_column, "only DEP LCT names its end in X and Y");
	if (!find_point(interp, &words, polar, &point))
		return false;
	path.column = words.first_column;
	if (path.rapid)
		return fault(lexer->at, words.feed_column, "DEP cannot be moved at FMAX; it needs F");
	way = way_words(&words);
	if (!leave(interp, &way, kind, point, &path) || !rise(interp, &path, point.z))
		return false;
	klartext_of(interp)->last.known = false;
	return klartext_m_end(interp, &words);
}
