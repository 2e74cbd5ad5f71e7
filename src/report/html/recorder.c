#include "report/html/recorder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "check/step.h"
#include "motion/motion_modes.h"
#include "report/format/format_units.h"
#include "report/html/record_scales.h"
#include "report/html/shown_body.h"

/* A block within this many blocks before a finding gets a plane, however long the program is. */
enum { BESIDE_FINDING = 16 };

/* mm/s: no axis is faster; a higher feed carries no information. */
#define FEED_SHOWN 1e6

/* ------------------------------------------------------------------- path */

static void keep_later(int64_t *row, const int64_t *next, size_t columns)
{
	memcpy(row, next, columns * sizeof(*row));
}

static void add_row(struct recorder *recorder, const struct motion_step *step, double time, const axis_values *at,
		    int class)
{
	const struct machine *machine = recorder->scene->machine;
	int64_t row[RECORDED_COLUMNS_MAX] = {
		[PATH_TIME] = record_whole(time, RECORD_TIME),
		[PATH_BLOCK] = recorder->read.blocks + 1,
		[PATH_LINE] = step->line,
		[PATH_FILE] = (int64_t)recorded_files_index(&recorder->files, step->file),
		[PATH_TOOL] = step->tool,
		[PATH_CLASS] = class,
		[PATH_MODES] = recorder->modes.current,
		[PATH_FEED] = record_whole(60 * fmin(recorder->modes.feed, FEED_SHOWN), RECORD_FEED),
	};

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		row[PATH_AXES + i] =
		    record_whole(format_units_value(axis->slot, at->v[axis->slot]), record_axis_scale(axis));
	}
	recorded_table_add(&recorder->path, row);
}

static int class_of(const struct motion_step *step)
{
	if (step_is_box(step))
		return 4;
	return step->step_class == STEP_RAPID ? 1 : step->step_class == STEP_FEED_TURNING ? 2 : 3;
}

static void on_step(struct recorder *recorder, const struct motion_step *step)
{
	struct recorded_progress *read = &recorder->read;
	const bool first = !recorder->path.rows;

	if (first)
		read->start = read->block_from = step->time;
	if (first || record_whole(step->time, RECORD_TIME) > record_whole(read->now, RECORD_TIME))
		add_row(recorder, step, step->time, &step->span.q0, 0);
	read->now = step->time + step->seconds;
	read->position = step->span.q1;
	read->tool = step->tool;
	add_row(recorder, step, read->now, &step->span.q1, class_of(step));
}

static void on_modes(struct recorded_modes *modes, const struct motion_modes *told)
{
	struct motion_modes without_feed = *told;

	modes->feed = told->feed;
	without_feed.feed = 0;
	for (size_t i = modes->count; i-- > 0;) {
		if (motion_modes_same(&modes->items[i], &without_feed)) {
			modes->current = (int64_t)i;
			return;
		}
	}
	modes->current = -1;
	if (modes->count == MODES_MAX)
		return;
	modes->items = mem_grow(modes->items, &modes->capacity, modes->count + 1, sizeof(*modes->items));
	modes->items[modes->count] = without_feed;
	modes->current = (int64_t)modes->count++;
}

static void on_block(struct recorder *recorder, const struct motion_block *block)
{
	struct recorded_progress *read = &recorder->read;
	const long number = ++read->blocks;

	recorder->ends[number % BLOCK_ENDS] = (struct block_end){
		number, block->file, block->line, read->block_from, read->now, read->position, read->tool, INFINITY, -1,
	};
	read->block_from = read->now;
}

static bool on_event(void *context, const struct motion_event *event)
{
	struct recorder *recorder = context;

	if (event->kind == MOTION_STEP)
		on_step(recorder, &event->of.step);
	else if (event->kind == MOTION_MODES)
		on_modes(&recorder->modes, &event->of.modes);
	else if (event->kind == MOTION_BLOCK)
		on_block(recorder, &event->of.block);
	return true;
}

/* --------------------------------------------------------------- findings */

/* The number of the finding's block: the first one of its line that ends after it. 0: unknown. */
static long block_of(const struct recorder *recorder, const struct finding *finding)
{
	const long oldest = recorder->read.blocks >= BLOCK_ENDS ? recorder->read.blocks - BLOCK_ENDS + 1 : 1;
	long found = 0;

	for (long n = recorder->read.blocks; n >= oldest; n--) {
		const struct block_end *end = &recorder->ends[n % BLOCK_ENDS];

		if (end->to < finding->time)
			break;
		if (end->line == finding->line)
			found = n;
	}
	return found;
}

/* The curve must not be above a finding: between a cutter and the part no clearance is measured. */
static void bound_block(struct recorder *recorder, const struct finding *finding, long number)
{
	const struct scene *scene = recorder->scene;
	const struct pair_finding *met = &finding->of.pair;
	struct block_end *end = &recorder->ends[number % BLOCK_ENDS];
	const struct scene_pair *pair;

	if (!number || finding->kind == FINDING_LIMIT || met->clearance >= end->found)
		return;
	pair = shown_pair(scene, shown_body_named(scene, met->a), shown_body_named(scene, met->b));
	end->found = met->clearance;
	end->found_pair = pair ? pair - scene->pairs : -1;
}

void recorder_finding(struct recorder *recorder, const struct finding *finding, struct finding_style style)
{
	const long block = block_of(recorder, finding);

	bound_block(recorder, finding, block);
	recorded_findings_add(&recorder->findings, recorder->scene, &recorder->sweep, finding, style, block);
	recorder->stock.time = recorded_findings_first(&recorder->findings)->stock_time;
	/* A file that only calls others moves nothing, and would be missing from the list. */
	for (size_t i = 0; i < finding->caller_count; i++)
		recorded_files_index(&recorder->files, finding->callers[i].file);
}

/* ------------------------------------------------------------- clearances */

static void keep_least(int64_t *row, const int64_t *next, size_t columns)
{
	(void)columns;
	row[CLEARANCE_TIME] = next[CLEARANCE_TIME];
	if (next[CLEARANCE_MOST] > row[CLEARANCE_MOST])
		row[CLEARANCE_MOST] = next[CLEARANCE_MOST];
	if (next[CLEARANCE_LEAST] >= row[CLEARANCE_LEAST])
		return;
	row[CLEARANCE_LEAST] = next[CLEARANCE_LEAST];
	row[CLEARANCE_PAIR] = next[CLEARANCE_PAIR];
}

static bool is_beside_finding(const struct recorder *recorder, long number)
{
	for (size_t i = recorder->findings.count; i-- > 0;) {
		const long block = recorder->findings.items[i].block;

		if (number <= block && number > block - BESIDE_FINDING)
			return true;
	}
	return false;
}

static double thousandths(double clearance)
{
	return floor(clearance / RECORD_CLEARANCE);
}

double recorder_shown(double clearance)
{
	return thousandths(clearance) * RECORD_CLEARANCE;
}

void recorder_block(struct recorder *recorder, const struct check_block *block)
{
	const struct block_end *end = &recorder->ends[block->number % BLOCK_ENDS];
	double least = recorder->cap;
	size_t pair = recorder->scene->pair_count;
	int64_t row[CLEARANCE_COLUMNS];
	bool beside, so_far = false;

	if (end->number != block->number)
		return;
	recorder->checked = end->to;
	if (!block->steps)
		return;
	for (size_t i = 0; i < block->clearance_count; i++) {
		recorder->sampled |= block->clearances[i].so_far;
		if (block->clearances[i].clearance >= least)
			continue;
		least = block->clearances[i].clearance;
		pair = block->clearances[i].pair;
		so_far = block->clearances[i].so_far;
	}
	row[CLEARANCE_TIME] = record_whole(end->to, RECORD_TIME);
	row[CLEARANCE_LEAST] = row[CLEARANCE_MOST] = (int64_t)thousandths(fmin(least, end->found));
	row[CLEARANCE_PAIR] = end->found < least ? end->found_pair
			      : pair < recorder->scene->pair_count ? (int64_t)pair : -1;
	recorded_table_add(&recorder->clearance, row);
	recorder->bound = fmin(recorder->bound, least);
	/*
	 * In such a block the clearance at the position of the bodies was not measured, and another pair may be the
	 * nearest.
	 */
	if (pair == recorder->scene->pair_count || so_far)
		return;
	if (least < recorder->nearest.clearance)
		recorder->nearest = (struct recorded_nearest){
			least, pair, recorded_files_index(&recorder->files, end->file), *end,
		};
	beside = recorded_planes_has_room(&recorder->planes) && is_beside_finding(recorder, block->number);
	if (beside || block->number % recorder->planes.stride == 0)
		recorded_planes_add(&recorder->planes, &(struct plane_wish){end->to, end->axes, pair, beside});
}

bool recorder_is_near(const struct recorder *recorder)
{
	return recorder->nearest.clearance < recorder->cap;
}

double recorder_bound(const struct recorder *recorder)
{
	return fmin(recorder->bound, recorder->nearest.clearance);
}

bool recorder_nearest_point(struct recorder *recorder, vec3 *point)
{
	const struct scene_pair *pair = &recorder->scene->pairs[recorder->nearest.pair];
	const axis_values *axes = &recorder->nearest.end.axes;
	struct nearest_triangles nearest;
	struct body_pair bodies;
	xform pose;

	if (!recorder_is_near(recorder))
		return false;
	bodies = scene_pair_bodies(recorder->scene, pair);
	sweep_nearest_triangles(&recorder->sweep, &bodies, axes, 1, &nearest);
	pose = shown_body_pose(recorder->scene, pair->a, axes);
	*point = xform_apply(&pose, vec3_lerp(nearest.on_a, nearest.on_b, 0.5));
	return true;
}

/* -------------------------------------------------------------------- run */

void recorder_init(struct recorder *recorder, struct scene *scene, const char *program, double cap)
{
	*recorder = (struct recorder){
		.watch = {recorder, on_event},
		.scene = scene,
		.cap = cap,
		.nearest.clearance = cap,
		.bound = cap,
		.read.position = machine_home(scene->machine),
		.read.tool = scene->setup ? scene->setup->initial_tool : 0,
		.ends = mem_zalloc(BLOCK_ENDS, sizeof(struct block_end)),
		.planes.stride = 1,
		.modes.current = -1,
		.stock = {.time = INFINITY},
	};
	recorded_files_index(&recorder->files, program);
	recorded_table_init(&recorder->path, PATH_AXES + scene->machine->axis_count, keep_later);
	recorded_table_init(&recorder->clearance, CLEARANCE_COLUMNS, keep_least);
}

void recorder_release(struct recorder *recorder)
{
	recorded_findings_release(&recorder->findings);
	recorded_files_release(&recorder->files);
	recorded_planes_release(&recorder->planes);
	free(recorder->ends);
	free(recorder->modes.items);
	recorded_table_release(&recorder->path);
	recorded_table_release(&recorder->clearance);
	mesh_release(&recorder->stock.mesh);
	sweep_release(&recorder->sweep);
}

bool recorder_close(struct recorder *recorder, int *error)
{
	const bool path = recorded_table_close(&recorder->path);
	const bool clearance = recorded_table_close(&recorder->clearance);

	recorded_planes_make(&recorder->planes, recorder->scene, &recorder->sweep);
	if (!path || !clearance)
		*error = path ? recorder->clearance.error : recorder->path.error;
	return path && clearance;
}
