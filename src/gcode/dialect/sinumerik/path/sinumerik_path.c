#include "gcode/dialect/sinumerik/path/sinumerik_path.h"

#include <math.h>

#include "base/units.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"

/* CYCLE832, S_TOLM: _OFF, _FINISH, _SEMIFIN, _ROUGH, _PRECISION; 10 more: with a tolerance of the orientation. */
#define WITH_ORIENTATION 10
#define MODES_END 20
#define HUNDREDS 100

static void apply(struct interp *interp)
{
	const struct sinumerik_path *path = &sinumerik_of(interp)->path;
	struct state *state = &interp->state;
	const bool within_control = path->compresses || path->code != SINUMERIK_G(641);

	state->blend = path->compresses || path->smooths_orientation || path->code != SINUMERIK_G(60);
	state->blend_turn = radians(path->orientation_tolerance);
	/* With G64 and G644 the dynamics of the axes decide, so no tolerance of the program is a bound. */
	if (path->code == SINUMERIK_G(64) || path->code == SINUMERIK_G(644))
		state->blend_tolerance = 0;
	else if (within_control)
		state->blend_tolerance = path->smoothing * fmax(1, path->rapid_factor);
	else
		state->blend_tolerance = fmax(path->rounding, path->rapid_rounding);
}

/*
 * 840D sl, "Continuous-path mode": ADIS and ADISPOS are the rounding distances of feeds and of rapids. Either may
 * round a corner between a feed and a rapid. STOLF multiplies the tolerances of rapids. OTOL and ATOL limit the
 * rotary axes. Here the largest of them is used for all moves.
 */
void sinumerik_path_set(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik_path *path = &sinumerik_of(interp)->path;
	const struct {
		enum sinumerik_address address;
		bool is_length;
		double *value;
	} words[] = {{SINUMERIK_ADIS, true, &path->rounding},
		     {SINUMERIK_ADISPOS, true, &path->rapid_rounding},
		     {SINUMERIK_CTOL, true, &path->smoothing},
		     {SINUMERIK_OTOL, false, &path->orientation_tolerance},
		     {SINUMERIK_STOLF, false, &path->rapid_factor}};

	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]) && block->addresses; i++) {
		const double value = block->address_value[words[i].address];

		/* A negative value selects the tolerance of the control's parameters again. */
		if (sinumerik_block_has_address(block, words[i].address))
			*words[i].value = fmax(0, words[i].is_length ? sinumerik_target_length(interp, value) : value);
	}
	if (block->code[SINUMERIK_PATH] != CODE_NONE)
		path->code = block->code[SINUMERIK_PATH];
	if (block->code[SINUMERIK_COMPRESSOR] != CODE_NONE)
		path->compresses = block->code[SINUMERIK_COMPRESSOR] == SINUMERIK_COMPON;
	if (block->code[SINUMERIK_ORI_SMOOTHING] != CODE_NONE)
		path->smooths_orientation = block->code[SINUMERIK_ORI_SMOOTHING] == SINUMERIK_ORISON;
	apply(interp);
}

static double argument(const struct sinumerik_passed *passed, size_t i, double otherwise)
{
	return i < passed->count && !isnan(passed->numbers[i]) ? passed->numbers[i] : otherwise;
}

/*
 * 840D sl, "High speed settings (CYCLE832)": the arguments are the tolerance of the contour, the kind of machining,
 * and for the kinds _ORI_... the tolerance of the orientation in degrees. _OFF, or no arguments, cancel the
 * tolerances. The machine's builder decides which of G64 and the like and which compressor the cycle selects; all of
 * them blend.
 */
bool sinumerik_path_smooth(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const double tolerance = argument(&sinumerik->passed, 0, 0), given = argument(&sinumerik->passed, 1, 1);
	/*
	 * Three arguments are the present form. A mode of 100 to 199 is Top Surface, which smooths within the same
	 * tolerance.
	 */
	const double mode =
	    sinumerik->passed.count > 2 && given >= HUNDREDS && given < 2 * HUNDREDS ? given - HUNDREDS : given;
	const bool on = tolerance > 0 && fabs(fmod(mode, WITH_ORIENTATION)) > 0;
	const bool turns = on && mode >= WITH_ORIENTATION && mode < MODES_END;

	/* Before software 4 the mode has six digits; the tens may switch TRAORI on. */
	if (fabs(mode) >= 100 && sinumerik_of(interp)->passed.count > 1 && fmod(floor(fabs(mode) / 10), 10) > 0)
		return fault(&interp->at, column,
			     "the tens of %.15g, the kind of machining of CYCLE832, may switch a transformation; write "
			     "TRAORI or TRAFOOF and leave them 0",
			     mode);
	if (tolerance < 0)
		return fault(&interp->at, column, "the tolerance of CYCLE832 cannot be negative");
	sinumerik->path.smoothing = on ? tolerance * interp->state.scale : 0;
	sinumerik->path.orientation_tolerance = turns ? fmax(0, argument(&sinumerik->passed, 2, 0)) : 0;
	sinumerik->path.code = SINUMERIK_G(642);
	sinumerik->path.compresses = on;
	apply(interp);
	return true;
}
