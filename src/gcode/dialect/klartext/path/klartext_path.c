#include "gcode/dialect/klartext/path/klartext_path.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_cycle.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/machine/klartext_m.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/path/klartext_approach.h"
#include "gcode/dialect/klartext/path/klartext_corner.h"
#include "geom/tolerance.h"

/* Moves on a circle whose plane is not certain. Refused where another element needs the direction of the circle. */
static bool make_open(struct interp *interp, const struct klartext_words *words, const struct klartext_target *target,
		      struct klartext_path *path)
{
	struct klartext *klartext = klartext_of(interp);

	if (klartext_comp_is_selected(interp) || words->comp == KLARTEXT_RL || words->comp == KLARTEXT_RR ||
	    klartext->corner.waits || klartext->approach.waits || klartext_corner_follows(interp))
		return fault(
		    &interp->at, words->first_column,
		    "CC with X, Y and Z leaves open in which plane this circle lies: under radius compensation "
		    "and beside RND and CHF it has to be known; leave one of them out");
	if (!klartext_comp_check_known(interp, words->first_column, "a circle"))
		return false;
	path->known = false;
	klartext->last = *path;
	return klartext_move_within(interp, target, path);
}

bool klartext_path_make(struct interp *interp, const struct klartext_words *words, const struct klartext_target *target,
			struct klartext_path *path)
{
	struct klartext *klartext = klartext_of(interp);
	bool beside, corner;

	if (path->open)
		return make_open(interp, words, target, path);
	path->crossing = words->m_count && klartext_words_m(words, 97);
	path->column = words->first_column;
	if (path->arc && !klartext_comp_check_known(interp, words->first_column, "a circle"))
		return false;
	if (klartext->approach.waits && !klartext_approach_make(interp, path))
		return false;
	beside = klartext_comp_is_selected(interp);
	if (klartext->corner.waits && !klartext_corner_make(interp, words, path))
		return false;
	if (!klartext_comp_switch(interp, words, path))
		return false;
	klartext->last = *path;
	corner = klartext_corner_follows(interp);
	if (corner && klartext_comp_is_selected(interp) && !beside)
		return fault(&interp->at, words->comp_column,
			     "RND and CHF right behind the block that starts radius compensation are not supported");
	if (corner)
		return klartext_corner_hold(interp, words, target, path);
	if (!klartext_comp_go(interp, target, path))
		return false;
	klartext_comp_settle(interp, words);
	return true;
}

/* Refuses words that neither a circle nor a polar line can have. False: reported. */
static bool check_words(struct interp *interp, const struct klartext_words *words)
{
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if (klartext_words_has(words, slot))
			return fault(&interp->at, words->column[slot],
				     "%c in a circle or in polar coordinates is not supported", AXIS_LETTERS[slot]);
	}
	if (words->spatial)
		return fault(&interp->at, words->first_column,
			     "a spatial angle (AXIS SPAT) in a circle or in polar coordinates is not supported");
	if (words->has_length || words->has_centre_angle)
		return fault(&interp->at, words->first_column, "LEN and CCA belong to APPR and DEP");
	if (klartext_m_machine(words))
		return fault(&interp->at, klartext_m_machine(words)->column, "M%d belongs to straight lines (L)",
			     klartext_m_machine(words)->number);
	return true;
}

bool klartext_path_run(struct lexer *lexer, klartext_path_shape shape)
{
	struct interp *interp = lexer->context;
	struct klartext_path path = {.known = true};
	struct klartext_target target;
	struct klartext_words words;

	if (!klartext_words_read(lexer, &words) || !check_words(interp, &words) || !klartext_m_start(interp, &words) ||
	    !klartext_move_feed(interp, &words, &path.rapid, &path.feed) ||
	    !klartext_move_target(interp, &words, &target))
		return false;
	if (!klartext_move_check(interp, &target, words.first_column))
		return false;
	path.start = klartext_frame_point(interp);
	if (!shape(interp, &words, &target, &path))
		return false;
	path.end = target.point;
	if (path.arc && path.rapid)
		return fault(&interp->at, words.feed_column, "a circle cannot be moved at FMAX; it needs F");
	if (path.arc && !klartext_move_check_arc(interp, &path, words.first_column))
		return false;
	return klartext_path_make(interp, &words, &target, &path) && klartext_cycle_call_modal(interp, &words, true) &&
	       klartext_m_end(interp, &words);
}
