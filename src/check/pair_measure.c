#include "check/pair_measure.h"

#include <math.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "scene/static_query.h"

bool pair_measure_applies(const struct pair_check *check)
{
	return check->watch.steps == STEP_ANY;
}

static void add_room(struct pair_check *check, long block, long last, double most)
{
	check->clearances = mem_grow(check->clearances, &check->clearance_capacity, check->clearance_count + 1,
				     sizeof(*check->clearances));
	check->clearances[check->clearance_count++] = (struct pair_check_clearance){block, last, most, most, false};
}

static struct pair_check_clearance *last_room(const struct pair_check *check)
{
	return check->clearance_count ? &check->clearances[check->clearance_count - 1] : NULL;
}

/*
 * Starts the clearance of the step's block, if the block is new. Distances above `most` do not matter. least_only:
 * blocks without a smaller distance are left out.
 */
static void start_room(struct pair_check *check, long block, double most, bool least_only)
{
	struct pair_check_clearance *last = last_room(check);

	if (last && last->last == block) {
		if (last->block == block)
			return;
		/* The rest of the block may lower its clearance. */
		last->last--;
		add_room(check, block, block, last->most);
		return;
	}
	if (last && least_only && !(last->clearance < last->most))
		check->clearance_count--;
	add_room(check, block, block, most);
	block_clearance_start(&check->methods->block, most);
}

/* block_clearance uses only surfaces. While one body may be inside the other, test this. */
static void measure_inside(struct pair_check *check, const struct motion_step *step)
{
	struct block_clearance *block = &check->methods->block;
	vec3 point;

	block->maybe_inside = !(block->pair.bound > 0);
	if (!block->maybe_inside && static_query_contained(check->scene, &check->scene->pairs[check->pair],
							   &step->span.q0, &point) == INSIDE_YES) {
		block->pair.bound = 0;
		block->maybe_inside = true;
	}
}

/* mm: the largest cap of this number of steps from `from` on. */
static double most_of(const struct measure_plan *plan, const struct batch *batch, size_t from, size_t steps)
{
	const size_t to = from + steps < batch->step_count ? from + steps : batch->step_count;
	double largest = 0;

	for (size_t i = from; i < to && largest < plan->largest; i++)
		largest = larger(largest, plan->most[i]);
	return largest;
}

/*
 * Have all steps of the box of this size from step i on at least their cap? `proved`: mm, proved for all steps so far.
 */
static bool box_clears(struct block_clearance *block, const struct batch *batch, enum batch_box size, size_t i,
		       const struct measure_plan *plan, double proved)
{
	const struct batch_chunk *box = batch_box_from(batch, size, i);
	const size_t steps = batch_box_steps(size);
	const double largest = box ? most_of(plan, batch, i, steps) : 0;

	return box && (proved >= largest || block_clearance_clears(block, box, largest, steps, size == BOX_CHUNK));
}

/*
 * The end of the largest box that begins with step i and whose steps have at least their cap; i: there is none.
 * `proved`: mm, proved for all steps so far.
 */
static size_t clear_to(struct block_clearance *block, const struct batch *batch, size_t i,
		       const struct measure_plan *plan, double proved)
{
	size_t to = i;

	if (box_clears(block, batch, BOX_CHUNK, i, plan, proved))
		to += CHUNK_STEPS;
	else if (box_clears(block, batch, BOX_PIECE, i, plan, proved))
		to += PIECE_STEPS;
	return to < batch->step_count ? to : batch->step_count;
}

/*
 * Stores the cap for all blocks that begin in the steps before `to`, from step i on. The entry begins with a block that
 * has steps, so that it still does if start_room shortens it to one block.
 */
static void add_clear(struct pair_check *check, const struct batch *batch, double cap, size_t i, size_t to)
{
	const long end = batch->steps[to - 1].block;
	struct pair_check_clearance *last = last_room(check);

	if (last && last->last == end)
		return;
	if (last && !(last->clearance < cap)) {
		last->last = end;
	} else {
		while (last && batch->steps[i].block == last->last)
			i++;
		add_room(check, batch->steps[i].block, end, cap);
	}
	check->methods->block.pair.bound = cap;
}

/* Must steps be examined one by one, although each of them has at least its cap? */
static bool needs_each_step(const struct pair_check *check, const struct check_options *options)
{
	const struct block_clearance *block = &check->methods->block;

	return !options->least_clearances &&
	       (check->watch.past_limits_only || block->maybe_inside ||
		(check->clearance_count && !(block->pair.bound > 0)));
}

static enum clearance_accuracy accuracy_of(const struct check_options *options, bool rough)
{
	if (!options->least_clearances)
		return CLEARANCE_SHARP;
	return rough ? CLEARANCE_ROUGH : CLEARANCE_COARSE;
}

/* Node pairs examined by measuring, including searches for planes. */
static long looked_at(const struct pair_check *check, const struct sweep *sweep)
{
	return sweep->visits + check->methods->block.pair.planes.visits;
}

/*
 * mm: if only least clearances are measured, the distance that the check has proved for all steps so far; 0: no more
 * than the required one. A pair that was once found too close has no more than that.
 */
static double proved_so_far(const struct pair_check *check, const struct check_options *options)
{
	const double proved = strategy_proven(&check->methods->strategy);

	if (!options->least_clearances || check->watch.past_limits_only || !(check->measuring.up_to > 0) ||
	    isinf(proved))
		return 0;
	return proved > check->scene->pairs[check->pair].clearance ? proved : 0;
}

/*
 * Lowers the clearance of the step's block to the measured distance, or to the one proved for all steps (0: none).
 * `measured`: the proved distance is not enough.
 */
static void measure_step(struct pair_check *check, struct sweep *sweep, const struct batch_step *step, bool measured,
			 double proved, enum clearance_accuracy accuracy, const struct check_options *options)
{
	struct pair_check_clearance *clearance = &check->clearances[check->clearance_count - 1];
	struct block_clearance *block = &check->methods->block;
	const double before = block->pair.bound;

	if (measured || !(proved > 0))
		block_clearance_step(block, sweep, &step->motion, options->tolerance, accuracy);
	else
		block->pair.bound = 0;
	if (proved > 0)
		block->pair.bound = larger(block->pair.bound, smaller(before, proved));
	if (block->pair.bound < before)
		clearance->so_far = !measured && proved > 0;
}

/*
 * mm: a step with at least this proved distance needs no check; INFINITY: every step needs one. With a smaller cap no
 * step reaches the distance, and if the smallest clearance is wanted the check itself finds it.
 */
static double clear_from(const struct pair_check *check, const struct check_options *options)
{
	const double needed = check->scene->pairs[check->pair].clearance + options->tolerance;

	if (options->least_clearances || check->watch.past_limits_only || check->measuring.up_to > 0 ||
	    !(options->block_clearance_cap > needed))
		return INFINITY;
	return needed;
}

/* Step i must be checked, because the measurement has not proved enough. */
static void leave_open(struct pair_check *check, size_t i)
{
	check->open = mem_grow(check->open, &check->open_capacity, check->open_count + 1, sizeof(*check->open));
	check->open[check->open_count++] = i;
}

long pair_measure(struct pair_check *check, struct sweep *sweep, const struct batch *batch,
		  const struct measure_plan *plan, const struct check_options *options)
{
	const long before = looked_at(check, sweep);
	const double proved = proved_so_far(check, options), enough = clear_from(check, options);
	struct block_clearance *block = &check->methods->block;
	size_t clear = 0;

	check->clearance_count = check->open_count = 0;
	check->measured_first = pair_measure_applies(check) && !isinf(enough);
	for (size_t i = 0; i < batch->step_count && pair_measure_applies(check); i++) {
		const struct batch_step *step = &batch->steps[i];
		const struct batch_chunk *chunk = &batch->chunks[i / CHUNK_STEPS];

		if (i % CHUNK_STEPS == 0 && check->watch.past_limits_only && !chunk->beyond) {
			i += CHUNK_STEPS - 1;
			continue;
		}
		if (i % PIECE_STEPS == 0 && i >= clear)
			clear = clear_to(block, batch, i, plan, proved);
		if (i < clear && !needs_each_step(check, options)) {
			if (!options->least_clearances)
				add_clear(check, batch, plan->largest, i, clear);
			i = clear - 1;
			continue;
		}
		if (check->watch.past_limits_only && !step->beyond)
			continue;
		start_room(check, step->block, plan->most[i], options->least_clearances);
		if (i >= clear) {
			const bool spent = looked_at(check, sweep) - before > plan->effort;
			const enum measure_wish wish = plan->wishes[i];

			measure_step(check, sweep, step, wish == MEASURE_NEAREST || (wish == MEASURE_CURVE && !spent),
				     proved, accuracy_of(options, spent), options);
		}
		if (block->maybe_inside || !(block->pair.bound > 0))
			measure_inside(check, &step->motion);
		if (check->measured_first && !(block->pair.bound > enough))
			leave_open(check, i);
		check->clearances[check->clearance_count - 1].clearance = block->pair.bound;
	}
	if (check->measured_first)
		check->measured_steps += (long)(batch->step_count - check->open_count);
	return looked_at(check, sweep) - before;
}
