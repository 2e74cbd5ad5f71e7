#include "gcode/dialect/sinumerik/cycles/sinumerik_contour.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/block/sinumerik_tool.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_argument.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_program.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_save.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_seek.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/path/sinumerik_comp.h"

/* Arguments of CYCLE72 after RTP, RFP, SDIS and DP, without the name of the contour. */
enum { FAL = 5, FFP1 = 7, VARI = 9, RL = 10, AS1 = 11, LP1 = 12, AS2 = 14, LP2 = 15, DISPLAY = 20, ALTERNATIVE = 21 };

/* The units of VARI that mean a chamfer. */
#define CHAMFER 5

/*
 * In tool radii: the largest distance to which a sharp corner may be extended if the tool does not move around it
 * (angles up to 2.4 radians, comp_turn.c).
 */
#define DRAWN_OUT 3.0

/* Radians: a smaller change of direction is not a corner. */
#define TANGENT 1e-3

/* Radians: the largest angle of one chord of a circle. */
#define CHORD 0.2

static enum axis_slot across(const struct sinumerik_contour *contour)
{
	return contour->plane == G17 ? SLOT_Z : contour->plane == G18 ? SLOT_Y : SLOT_X;
}

static double middle(const struct sinumerik_contour *contour)
{
	return (contour->safe + contour->bottom) / 2;
}

/* ------------------------------------------------------------ which contour */

/* 840D sl, "CYCLE62", TYP: 0 a subprogram, 1 the name of a contour, 2 two labels, 3 two labels in a subprogram. */
bool sinumerik_contour_select(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_text *texts = sinumerik->passed.texts;
	struct sinumerik_contour *contour = &sinumerik->contour;
	const double type = sinumerik->passed.count > 1 ? sinumerik->passed.numbers[1] : 0;
	char *name = contour->name.bytes;
	const size_t size = sizeof(contour->name.bytes);
	int length = 0;

	for (size_t i = sinumerik->passed.count; i < 4; i++)
		sinumerik->passed.texts[i].bytes[0] = '\0';
	if (!(type >= 0 && type <= 2) || !same_double(floor(type), type))
		return fault(&interp->at, column, "CYCLE62 with a contour of type %.9g is not supported, only 0 (a "
						  "subprogram), 1 (a contour's name) and 2 (two labels)", type);
	if (type < 1)
		length = snprintf(name, size, "%s", texts[0].bytes);
	else if (type < 2)
		length = snprintf(name, size, "E_LAB_A_%s:E_LAB_E_%s", texts[0].bytes, texts[0].bytes);
	else
		length = snprintf(name, size, "%s:%s", texts[2].bytes, texts[3].bytes);
	if (length >= (int)size)
		return fault(&interp->at, column, "the name of the contour is too long");
	contour->selected++;
	return true;
}

static bool find_label(struct interp *interp, const char *start, size_t length, int column, struct position *at)
{
	char name[SINUMERIK_NAME + 1] = "";
	bool found;

	for (size_t i = 0; i < length && i < SINUMERIK_NAME; i++)
		name[i] = ascii_upper(start[i]);
	if (!sinumerik_seek_label(interp, name, SINUMERIK_ANYWHERE, column, at, &found))
		return false;
	return found || fault(&interp->at, column, "no line of this program has the label %s of the contour", name);
}

/* Goes to the first block of the contour. After its last block, the line of CYCLE72 is read again. */
static bool call_contour(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_contour *contour = &sinumerik->contour;
	const char *name = contour->name.bytes, *colon = strchr(name, ':');
	const int column = contour->column;
	char program[SINUMERIK_NAME + 1], type;
	struct position first, last;

	sinumerik->passed.count = 0;
	if (colon) {
		if (!find_label(interp, name, (size_t)(colon - name), column, &first) ||
		    !find_label(interp, colon + 1, strlen(colon + 1), column, &last))
			return false;
		if (last.line < first.line)
			return fault(&interp->at, column, "the contour ends before it begins");
		if (!sinumerik_call_repeat(interp, &first, last.line, 1, column))
			return false;
	} else if (!sinumerik_program_name(interp, name, column, program, &type) ||
		   !sinumerik_call_run(interp, program, type, 1, column)) {
		return false;
	}
	if (sinumerik->calls.depth == contour->depth)
		return fault(&interp->at, column, "the contour %s is a program of the builder, which is not known",
			     name);
	sinumerik->calls.items[sinumerik->calls.depth - 1].back = contour->line;
	/* The blocks of a contour need no F. */
	sinumerik_save_modes(interp, &contour->before);
	contour->feed_before = interp->state.feed_linear;
	interp->state.feed_linear = contour->feed * SECONDS_PER_MINUTE;
	contour->on = true;
	return true;
}

/* ---------------------------------------------------------------- arguments */

/* The largest distance of the tool from the contour, and from its ends at the approach and the retraction. */
static bool find_margins(struct sinumerik_contour *contour, const struct sinumerik_arguments *of)
{
	struct interp *interp = of->interp;
	const double radius = sinumerik_tool_radius(interp), leads = fmax(fabs(sinumerik_argument_length(of, LP1)),
									   fabs(sinumerik_argument_length(of, LP2)));
	const bool centred = sinumerik_argument_given(of, RL) && sinumerik_argument_digit(of, RL, 0) == 0;

	if (!centred && !(radius > 0))
		return fault(&interp->at, of->column,
			     "CYCLE72 needs the radius of the tool: give the tool of the setup a <cutter>, or "
			     "diameter=\"\"");
	if (sinumerik_argument_digit(of, AS1, 0) > 3 || sinumerik_argument_digit(of, AS2, 0) > 3)
		return fault(&interp->at, of->column,
			     "CYCLE72 whose approach or retraction (units of _AS1 and _AS2) is not 1, 2 or 3: a way "
			     "that the control chooses is not known");
	contour->beside = fabs(sinumerik_argument_length(of, FAL)) +
			  (centred ? 0 : radius * (sinumerik_comp_rounds(interp) ? 1 : DRAWN_OUT));
	contour->drawn_out = fabs(sinumerik_argument_length(of, FAL)) + (centred ? 0 : radius * DRAWN_OUT);
	/* A line of length LP, measured from the edge of the tool or from its centre; or a half circle of radius LP. */
	contour->ends = contour->beside + 2 * (leads + radius);
	return true;
}

static bool read_arguments(struct interp *interp, struct sinumerik_contour *contour)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const size_t count = sinumerik->passed.count > 0 ? sinumerik->passed.count - 1 : 0;
	const struct sinumerik_arguments of = {interp, "CYCLE72", contour->column, sinumerik->passed.numbers + 1,
					       count};
	const struct sinumerik_modes modes = {.display = DISPLAY, .alternative = ALTERNATIVE};
	struct sinumerik_heights height;

	if (!sinumerik_argument_heights(&of, &modes, &height) || !find_margins(contour, &of))
		return false;
	if (sinumerik_argument_digit(&of, VARI, 0) == CHAMFER)
		return fault(&interp->at, contour->column,
			     "CYCLE72 that makes a chamfer (units of _VARI 5) is not supported: how far beside the "
			     "contour the tool goes is not known");
	contour->clear = fmax(height.clear, height.safe);
	contour->safe = height.safe;
	contour->bottom = height.bottom;
	contour->stays_low = sinumerik_argument_digit(&of, VARI, 2) > 1;
	contour->backward = sinumerik_argument_digit(&of, VARI, 4) > 0;
	contour->feed = sinumerik_argument_or(&of, FFP1, 0) * sinumerik->feed_scale / SECONDS_PER_MINUTE;
	if (!(contour->feed > 0))
		contour->feed = interp->state.feed_linear / SECONDS_PER_MINUTE;
	return contour->feed > 0 || fault(&interp->at, contour->column, "CYCLE72 without a feed rate");
}

bool sinumerik_contour_mill(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_contour *contour = &sinumerik->contour;
	const char *own = sinumerik->passed.count > 0 ? sinumerik->passed.texts[0].bytes : "";
	const struct sinumerik_contour begun = {.line = source_here(interp->program.source),
						.depth = sinumerik->calls.depth,
						.column = column,
						.plane = interp->state.plane,
						.name = contour->name};

	if (contour->on)
		return fault(&interp->at, column, "CYCLE72 in a contour that CYCLE72 follows");
	if (sinumerik_frame_resizes(interp))
		return fault(&interp->at, column, "CYCLE72 while SCALE is in force is not supported");
	if (!own[0] && contour->selected != 1)
		return fault(&interp->at, column,
			     contour->selected ? "CYCLE72 behind several CYCLE62: a contour made of several is not "
						 "supported"
					       : "CYCLE72 without the name of a contour, and without CYCLE62 before "
						 "it");
	*contour = begun;
	if (own[0])
		snprintf(contour->name.bytes, sizeof(contour->name.bytes), "%s", own);
	return read_arguments(interp, contour) && call_contour(interp);
}

/* -------------------------------------------------------------------- moves */

bool sinumerik_contour_is_read(const struct interp *interp)
{
	return sinumerik_of(interp)->contour.on;
}

/* Moves to a place at a height. The tool may be anywhere in a box around the path. */
static bool go(struct interp *interp, const slot_values *to, double height, double aside, double over, double feed)
{
	const struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	double half[SLOT_Z + 1] = {aside, aside, aside};
	slot_values target = *to;

	target.v[across(contour)] = height;
	half[across(contour)] = over;
	return sinumerik_open_place_go(interp, &target, half, feed);
}

/* From the place before the cycle to above an end of the contour, one axis after the other or all at once. */
static bool come_over(struct interp *interp, const slot_values *target)
{
	const struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	const slot_values *from = &contour->from;
	slot_values centre = *from, over_it = *target;
	double half[SLOT_Z + 1];

	over_it.v[across(contour)] = contour->clear;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		centre.v[slot] = (from->v[slot] + over_it.v[slot]) / 2;
		half[slot] = fabs(from->v[slot] - over_it.v[slot]) / 2 +
			     (slot == (int)across(contour) ? 0 : contour->ends);
	}
	return sinumerik_open_place_go(interp, &centre, half, 0);
}

/* Above the first point, and then into the material in every pass. */
static bool approach(struct interp *interp, const slot_values *target)
{
	struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;

	contour->from = *sinumerik_frame_place(interp);
	sinumerik_open_place_take_over(interp);
	contour->begun = true;
	contour->start = *target;
	return come_over(interp, target) &&
	       go(interp, target, contour->clear, contour->ends, 0, 0) &&
	       go(interp, target, contour->bottom, contour->ends, 0, contour->feed) &&
	       go(interp, target, middle(contour), 0, 0, contour->feed);
}

/* A circle is approximated by chords; the distance of the circle is added to the uncertainty. */
static bool go_round(struct interp *interp, const slot_values *target, const struct sinumerik_circle *circle,
		     double aside, double over)
{
	const struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	const enum axis_slot a = contour->plane == G17 ? SLOT_X : contour->plane == G18 ? SLOT_Z : SLOT_Y;
	const enum axis_slot b = contour->plane == G17 ? SLOT_Y : contour->plane == G18 ? SLOT_X : SLOT_Z;
	const slot_values place = *sinumerik_frame_place(interp), straight = sinumerik_frame_straight(interp, &place);
	const double x = straight.v[a] - circle->centre.a, y = straight.v[b] - circle->centre.b;
	const double sweep = fabs(circle->arc.sweep) * (circle->clockwise ? -1 : 1), radius = math_hypot(x, y);
	const int chords = (int)ceil(fabs(sweep) / CHORD);
	const double sagitta = radius * (1 - math_cos(sweep / chords / 2));

	for (int i = 1; i < chords; i++) {
		const double c = math_cos(sweep * i / chords), s = math_sin(sweep * i / chords);
		slot_values at = place;

		at.v[a] += c * x - s * y - x;
		at.v[b] += s * x + c * y - y;
		if (!go(interp, &at, middle(contour), aside + sagitta, over, contour->feed))
			return false;
	}
	return go(interp, target, middle(contour), aside + sagitta, over, contour->feed);
}

/*
 * A corner before this move. It is not documented whether the cycle keeps G450 or extends corners by its own G451:
 * both are covered. If the direction does not change, there is no corner.
 */
static bool go_about_corner(struct interp *interp, const slot_values *target, const struct sinumerik_circle *circle)
{
	struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	const enum axis_slot a = contour->plane == G17 ? SLOT_X : contour->plane == G18 ? SLOT_Z : SLOT_Y;
	const enum axis_slot b = contour->plane == G17 ? SLOT_Y : contour->plane == G18 ? SLOT_X : SLOT_Z;
	const slot_values place = *sinumerik_frame_place(interp);
	const slot_values from = sinumerik_frame_straight(interp, &place);
	const slot_values to = sinumerik_frame_straight(interp, target);
	const vec3 before = contour->heading, way = {to.v[a] - from.v[a], to.v[b] - from.v[b], 0};
	const double turn = circle ? (circle->clockwise ? -1 : 1) : 0;
	vec3 start = way, end = way;

	if (circle) {
		start = (vec3){turn * (circle->centre.b - from.v[b]), turn * (from.v[a] - circle->centre.a), 0};
		end = (vec3){turn * (circle->centre.b - to.v[b]), turn * (to.v[a] - circle->centre.a), 0};
	}
	if (!(vec3_norm(start) > 0))
		return true;
	contour->heading = vec3_unit(end);
	if (!(vec3_norm(before) > 0) || vec3_norm(vec3_sub(before, vec3_unit(start))) < TANGENT)
		return true;
	return go(interp, &place, middle(contour), contour->drawn_out, (contour->safe - contour->bottom) / 2,
		  contour->feed);
}

static bool check_move(struct interp *interp, const slot_values *target, const struct sinumerik_circle *circle)
{
	const struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	const slot_values *place = sinumerik_frame_place(interp);
	const int column = interp->block.g_column[G_MOTION];

	if (interp->state.plane != contour->plane)
		return fault(&interp->at, column, "the contour of CYCLE72 changes the plane");
	if (circle && !circle->in_plane)
		return fault(&interp->at, column, "CIP in the contour of CYCLE72 is not supported");
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const bool in_plane = slot <= SLOT_Z && slot != (int)across(contour);

		if (!in_plane && !same_double(target->v[slot], place->v[slot]))
			return fault(&interp->at, column, "the contour of CYCLE72 moves %c, which is not in its plane",
				     AXIS_LETTERS[slot]);
	}
	return true;
}

/* The column of a word that is not allowed in a contour, or 0. */
static int foreign_word(const struct sinumerik_block *block)
{
	static const enum sinumerik_group groups[] = {SINUMERIK_SUPPRESSION, SINUMERIK_ONCE, SINUMERIK_TRANSFORM,
						      SINUMERIK_SYSTEM, SINUMERIK_FRAME, SINUMERIK_TOOL_FRAME};

	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++) {
		if (block->code[groups[i]] != CODE_NONE)
			return block->code_column[groups[i]];
	}
	for (const char *letter = "TD"; *letter; letter++) {
		if (sinumerik_block_has(block, *letter))
			return block->column[*letter - 'A'];
	}
	if (block->code[SINUMERIK_CUTTER] != CODE_NONE && block->code[SINUMERIK_CUTTER] != G40)
		return block->code_column[SINUMERIK_CUTTER];
	return block->call[0] ? block->call_column : block->modal ? block->modal_column : 0;
}

/* Does the block give both coordinates of the plane, or both polar coordinates, and none of them as an increment? */
static bool names_point(const struct sinumerik_contour *contour, const struct sinumerik_block *block)
{
	bool straight = true;

	if (sinumerik_block_has_address(block, SINUMERIK_AP) && sinumerik_block_has_address(block, SINUMERIK_RP))
		return block->address_way[SINUMERIK_AP] != SINUMERIK_WAY_IC &&
		       block->address_way[SINUMERIK_RP] != SINUMERIK_WAY_IC;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (slot != (int)across(contour))
			straight = straight && sinumerik_block_has(block, AXIS_LETTERS[slot]) &&
				   block->way[AXIS_LETTERS[slot] - 'A'] != SINUMERIK_WAY_IC;
	}
	return straight;
}

/* False: a jump has left the contour before its end, which was reported. */
static bool check_inside(struct interp *interp, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	return !sinumerik->contour.on || sinumerik->calls.depth > sinumerik->contour.depth ||
	       fault(&interp->at, column, "a jump or RET leaves the contour of the CYCLE72 in line %ld",
		     sinumerik->contour.line.line);
}

bool sinumerik_contour_check(struct interp *interp, const struct sinumerik_block *block)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	int column;

	if (!sinumerik_contour_is_read(interp))
		return true;
	if (!check_inside(interp, 1))
		return false;
	column = foreign_word(block);
	sinumerik_of(interp)->contour.names_point = names_point(&sinumerik->contour, block);
	for (int i = 0; i < block->m_count; i++) {
		/* M17 and RET end the contour of a subprogram. A part between labels ends at its label. */
		if ((block->m[i] == 2 || block->m[i] == 17 || block->m[i] == 30) &&
		    sinumerik->calls.items[sinumerik->calls.depth - 1].last_line)
			return fault(&interp->at, block->m_column[i], "the program ends in the contour of CYCLE72");
	}
	return column == 0 || fault(&interp->at, column,
				    "the contour of CYCLE72 has moves of G0, G1, G2 and G3 in its plane, and nothing "
				    "else that acts on them");
}

/* Words relative to the place before the contour are refused: the place of the control's cycle is not known there. */
static bool begin_contour(struct interp *interp, const slot_values *target, bool by_circle)
{
	const struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	const int column = interp->block.g_column[G_MOTION];

	if (by_circle)
		return fault(&interp->at, column,
			     "the contour of CYCLE72 begins with a circle: its first point is not known");
	if (!contour->names_point || interp->state.incremental)
		return fault(&interp->at, column,
			     "the contour of CYCLE72 begins with a point whose coordinates in the plane are not both "
			     "given, absolutely: write G90 and both of them");
	return approach(interp, target);
}

bool sinumerik_contour_take(struct interp *interp, const slot_values *target, const struct sinumerik_circle *circle)
{
	struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	const double over = (contour->safe - contour->bottom) / 2;
	/*
	 * A rounding is between the two blocks, and not farther from either than its radius. The same holds for a
	 * chamfer.
	 */
	const double rounded = interp->block.corner ? interp->block.corner_value * interp->state.scale : 0;
	const double aside = contour->beside + fmax(rounded, contour->rounded);

	interp->block.corner = '\0';
	contour->rounded = rounded;
	if (!check_move(interp, target, circle))
		return false;
	if (!contour->begun)
		return begin_contour(interp, target, circle != NULL);
	if (contour->drawn_out > contour->beside && !go_about_corner(interp, target, circle))
		return false;
	return circle ? go_round(interp, target, circle, aside, over)
		      : go(interp, target, middle(contour), aside, over, contour->feed);
}

/* ---------------------------------------------------------------------- end */

bool sinumerik_contour_waits(struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_contour *contour = &sinumerik->contour;

	return contour->on && sinumerik->calls.depth == contour->depth &&
	       interp->program.source == contour->line.source && interp->at.line == contour->line.line;
}

/* Between passes the tool returns to the start, or the next pass goes the other way: it may end at either end. */
bool sinumerik_contour_end(struct interp *interp)
{
	struct sinumerik_contour *contour = &sinumerik_of(interp)->contour;
	const slot_values end = *sinumerik_frame_place(interp), start = contour->start;
	const double low = contour->stays_low ? contour->bottom : contour->safe;
	double half[SLOT_Z + 1] = {contour->ends, contour->ends, contour->ends};
	slot_values between = end;

	contour->on = false;
	interp->moves = 0;
	if (!contour->begun)
		return fault(&interp->at, contour->column, "the contour %s has no moves", contour->name.bytes);
	half[across(contour)] = 0;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (slot == (int)across(contour))
			continue;
		between.v[slot] = (start.v[slot] + end.v[slot]) / 2;
		half[slot] += fabs(start.v[slot] - end.v[slot]) / 2;
	}
	if (!go(interp, &end, contour->bottom, contour->ends, 0, contour->feed) ||
	    !go(interp, &end, contour->clear, contour->ends, 0, 0) ||
	    (contour->backward && (!come_over(interp, &end) ||
				!go(interp, &end, contour->clear, contour->ends, 0, 0))) ||
	    !go(interp, &start, (low + contour->clear) / 2, contour->ends, (contour->clear - low) / 2, 0) ||
	    !go(interp, &between, contour->clear, contour->ends, (contour->clear - low) / 2, 0))
		return false;
	sinumerik_open_place_set(interp, half);
	interp->state.feed_linear = contour->feed_before;
	return sinumerik_save_restore(interp, &contour->before, contour->column);
}
