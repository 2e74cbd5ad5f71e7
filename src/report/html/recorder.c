#include "report/html/recorder.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "check/step.h"
#include "motion/motion_modes.h"
#include "report/format/format_units.h"
#include "report/html/report_data.h"
#include "report/html/shown_body.h"
#include "report/writers/ndjson.h"
#include "report/writers/text.h"

/* A block within this many blocks before a finding gets a plane, however long the program is. */
enum { BESIDE_FINDING = 16 };

/* The triangles beside a plane are the nearest ones to within this share: the exact ones cost several times as much. */
#define PLANE_SHARE 0.8

/* mm/s: no axis is faster; a higher feed carries no information. */
#define FEED_SHOWN 1e6

/* ------------------------------------------------------------------- path */

static void keep_later(int64_t *row, const int64_t *next, size_t columns)
{
	memcpy(row, next, columns * sizeof(*row));
}

double recorder_axis_scale(const struct axis *axis)
{
	return axis->rotary ? RECORD_ANGLE : RECORD_LENGTH;
}

static int64_t whole(double value, double scale)
{
	return llround(value / scale);
}

/* The index of a file. The check uses one pointer for each file name; the program itself is identified by its name. */
static size_t file_index(struct recorder *recorder, const char *name)
{
	for (size_t i = recorder->file_count; i-- > 0;) {
		if (recorder->files[i].interned == name)
			return i;
	}
	for (size_t i = 0; i < recorder->file_count; i++) {
		if (strcmp(recorder->files[i].name, name) != 0)
			continue;
		recorder->files[i].interned = name;
		return i;
	}
	recorder->files =
	    mem_grow(recorder->files, &recorder->file_capacity, recorder->file_count + 1, sizeof(*recorder->files));
	recorder->files[recorder->file_count++] = (struct recorded_file){name, mem_strndup(name, strlen(name))};
	return recorder->file_count - 1;
}

static void add_row(struct recorder *recorder, const struct motion_step *step, double time, const axis_values *at,
		    int class)
{
	const struct machine *machine = recorder->scene->machine;
	int64_t row[RECORDED_COLUMNS_MAX] = {
		[PATH_TIME] = whole(time, RECORD_TIME),
		[PATH_BLOCK] = recorder->blocks + 1,
		[PATH_LINE] = step->line,
		[PATH_FILE] = (int64_t)file_index(recorder, step->file),
		[PATH_TOOL] = step->tool,
		[PATH_CLASS] = class,
		[PATH_MODES] = recorder->mode,
		[PATH_FEED] = whole(60 * fmin(recorder->feed, FEED_SHOWN), RECORD_FEED),
	};

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		row[PATH_AXES + i] =
		    whole(format_units_value(axis->slot, at->v[axis->slot]), recorder_axis_scale(axis));
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
	if (!recorder->path.rows)
		recorder->start = recorder->block_from = step->time;
	if (!recorder->path.rows || whole(step->time, RECORD_TIME) > whole(recorder->now, RECORD_TIME))
		add_row(recorder, step, step->time, &step->span.q0, 0);
	recorder->now = step->time + step->seconds;
	recorder->position = step->span.q1;
	recorder->tool = step->tool;
	add_row(recorder, step, recorder->now, &step->span.q1, class_of(step));
}

static void on_modes(struct recorder *recorder, const struct motion_modes *told)
{
	struct motion_modes modes = *told;

	recorder->feed = told->feed;
	modes.feed = 0;
	for (size_t i = recorder->mode_count; i-- > 0;) {
		if (motion_modes_same(&recorder->modes[i], &modes)) {
			recorder->mode = (int64_t)i;
			return;
		}
	}
	recorder->mode = -1;
	if (recorder->mode_count == MODES_MAX)
		return;
	recorder->modes =
	    mem_grow(recorder->modes, &recorder->mode_capacity, recorder->mode_count + 1, sizeof(*recorder->modes));
	recorder->modes[recorder->mode_count] = modes;
	recorder->mode = (int64_t)recorder->mode_count++;
}

static void on_block(struct recorder *recorder, const struct motion_block *block)
{
	const long number = ++recorder->blocks;

	recorder->ends[number % BLOCK_ENDS] = (struct block_end){
		number, block->file, block->line, recorder->block_from, recorder->now, recorder->position,
		recorder->tool, INFINITY, -1,
	};
	recorder->block_from = recorder->now;
}

static bool on_event(void *context, const struct motion_event *event)
{
	struct recorder *recorder = context;

	if (event->kind == MOTION_STEP)
		on_step(recorder, &event->of.step);
	else if (event->kind == MOTION_MODES)
		on_modes(recorder, &event->of.modes);
	else if (event->kind == MOTION_BLOCK)
		on_block(recorder, &event->of.block);
	return true;
}

/* --------------------------------------------------------------- findings */

static int link_of_slot(const struct machine *machine, int slot)
{
	const struct axis *axis = machine_axis(machine, slot);

	return axis ? (int)(axis - machine->axes) + 1 : 0;
}

/* The pose of a body's mesh. */
static xform mesh_pose(const struct scene *scene, int body, const axis_values *q)
{
	const struct body *it = scene->bodies[body].body;
	const xform link = machine_pose(scene->machine, it->link, q);

	return xform_mul(&link, &it->placement);
}

static void nearest_of(struct recorder *recorder, const struct scene_pair *pair, const axis_values *q,
		       double share, struct nearest_triangles *nearest)
{
	const struct body_pair bodies = scene_pair_bodies(recorder->scene, pair);

	sweep_nearest_triangles(&recorder->sweep, &bodies, q, share, nearest);
}

static void add_triangles(struct recorder *recorder, struct recorded_finding *finding)
{
	const struct scene_pair *pair = shown_pair(recorder->scene, finding->a, finding->b);
	struct nearest_triangles nearest;
	xform pose;

	/* The triangles of the blank are not those of the remaining stock. */
	if (!pair || pair->stock)
		return;
	nearest_of(recorder, pair, &finding->axes, 1, &nearest);
	pose = mesh_pose(recorder->scene, pair->a, &finding->axes);
	for (int k = 0; k < 3; k++) {
		finding->triangles[0][k] = xform_apply(&pose, nearest.a.p[k]);
		finding->triangles[1][k] = xform_apply(&pose, nearest.b.p[k]);
	}
	finding->has_triangles = true;
}

/* The number of the finding's block: the first one of its line that ends after it. 0: unknown. */
static long block_of(const struct recorder *recorder, const struct finding *finding)
{
	const long oldest = recorder->blocks >= BLOCK_ENDS ? recorder->blocks - BLOCK_ENDS + 1 : 1;
	long found = 0;

	for (long n = recorder->blocks; n >= oldest; n--) {
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
	struct block_end *end = &recorder->ends[number % BLOCK_ENDS];
	const struct scene_pair *pair;

	if (!number || finding->kind == FINDING_LIMIT || finding->clearance >= end->found)
		return;
	pair = shown_pair(scene, shown_body_named(scene, finding->a), shown_body_named(scene, finding->b));
	end->found = finding->clearance;
	end->found_pair = pair ? pair - scene->pairs : -1;
}

static char *text_of(struct strbuf *text)
{
	char *copy = mem_strndup(strbuf_text(text), text->length);

	strbuf_release(text);
	return copy;
}

void recorder_finding(struct recorder *recorder, const struct finding *finding, struct finding_style style)
{
	const struct scene *scene = recorder->scene;
	const long block = block_of(recorder, finding);
	struct strbuf message = {0}, text = {0};
	struct recorded_finding *it;

	style.colour = false;
	bound_block(recorder, finding, block);
	if (recorder->finding_count == FINDINGS_MAX) {
		recorder->findings_left_out++;
		return;
	}
	recorder->findings = mem_grow(recorder->findings, &recorder->finding_capacity, recorder->finding_count + 1,
				      sizeof(*recorder->findings));
	it = &recorder->findings[recorder->finding_count++];
	text_sentence(&message, finding);
	format_units_add_plain(&text, finding->text);
	*it = (struct recorded_finding){
		.object = ndjson_finding_object(scene->machine, finding, style),
		.message = text_of(&message),
		.file = mem_strndup(finding->file, strlen(finding->file)),
		.text = text_of(&text),
		.kind = finding->kind,
		.status = style.status,
		.line = finding->line,
		.block = block,
		.time = finding->time,
		.stock_time = finding->stock_time,
		.fraction = finding->fraction,
		.axes = finding->axes,
		.tool = finding->tool,
		.a = finding->kind == FINDING_LIMIT ? -1 : shown_body_named(scene, finding->a),
		.b = finding->kind == FINDING_LIMIT ? -1 : shown_body_named(scene, finding->b),
		.link = finding->kind == FINDING_LIMIT ? link_of_slot(scene->machine, finding->slot) : 0,
		.point = finding->point,
	};
	if (it->a >= 0 && it->b >= 0)
		add_triangles(recorder, it);
	recorder->stock.time = recorder_first(recorder)->stock_time;
	/* A file that only calls others moves nothing, and would be missing from the list. */
	for (size_t i = 0; i < finding->caller_count; i++)
		file_index(recorder, finding->callers[i].file);
}

const struct recorded_finding *recorder_first(const struct recorder *recorder)
{
	for (size_t i = 0; i < recorder->finding_count; i++) {
		if (recorder->findings[i].status == FINDING_FAILS)
			return &recorder->findings[i];
	}
	return recorder->finding_count ? &recorder->findings[0] : NULL;
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
	for (size_t i = recorder->finding_count; i-- > 0;) {
		const long block = recorder->findings[i].block;

		if (number <= block && number > block - BESIDE_FINDING)
			return true;
	}
	return false;
}

/* Removes every second one of the wishes at regular intervals. */
static void thin_wishes(struct recorder *recorder)
{
	size_t kept = 0, turn = 0;

	for (size_t i = 0; i < recorder->wish_count; i++) {
		if (recorder->wishes[i].forced || turn++ % 2 == 0)
			recorder->wishes[kept++] = recorder->wishes[i];
	}
	recorder->wish_count = kept;
	recorder->plane_stride *= 2;
}

/* Most wishes are dropped later: a plane is made when the remaining wishes are known. */
static void wish_for_plane(struct recorder *recorder, const struct block_end *end, size_t pair, bool forced)
{
	if (recorder->wish_count - recorder->wishes_forced >= PLANES_MAX)
		thin_wishes(recorder);
	recorder->wishes =
	    mem_grow(recorder->wishes, &recorder->wish_capacity, recorder->wish_count + 1, sizeof(*recorder->wishes));
	recorder->wishes[recorder->wish_count++] = (struct plane_wish){*end, pair, forced};
	recorder->wishes_forced += forced;
}

static void make_plane(struct recorder *recorder, const struct plane_wish *wish)
{
	const struct scene *scene = recorder->scene;
	const struct scene_pair *pair = &scene->pairs[wish->pair];
	struct nearest_triangles nearest;
	vec3 middle, normal;
	int64_t *row;

	nearest_of(recorder, pair, &wish->at.axes, PLANE_SHARE, &nearest);
	if (!(nearest.distance > RECORD_NORMAL))
		return;
	middle = xform_apply(&scene->bodies[pair->a].body->placement, vec3_lerp(nearest.on_a, nearest.on_b, 0.5));
	normal = mat3_apply(&scene->bodies[pair->a].body->placement.rotation,
			    vec3_scale(1 / nearest.distance, vec3_sub(nearest.on_b, nearest.on_a)));
	row = recorder->planes[recorder->plane_count++];
	row[PLANE_TIME] = whole(wish->at.to, RECORD_TIME);
	row[PLANE_PAIR] = (int64_t)wish->pair;
	row[PLANE_POINT] = whole(middle.x, RECORD_LENGTH);
	row[PLANE_POINT + 1] = whole(middle.y, RECORD_LENGTH);
	row[PLANE_POINT + 2] = whole(middle.z, RECORD_LENGTH);
	row[PLANE_NORMAL] = whole(normal.x, RECORD_NORMAL);
	row[PLANE_NORMAL + 1] = whole(normal.y, RECORD_NORMAL);
	row[PLANE_NORMAL + 2] = whole(normal.z, RECORD_NORMAL);
	row[PLANE_DISTANCE] = whole(nearest.distance, RECORD_CLEARANCE);
}

static void make_planes(struct recorder *recorder)
{
	recorder->planes = mem_alloc((recorder->wish_count + 1) * sizeof(*recorder->planes));
	for (size_t i = 0; i < recorder->wish_count; i++)
		make_plane(recorder, &recorder->wishes[i]);
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
	row[CLEARANCE_TIME] = whole(end->to, RECORD_TIME);
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
	if (least < recorder->least) {
		recorder->least = least;
		recorder->least_pair = pair;
		recorder->least_at = *end;
		recorder->least_file = file_index(recorder, end->file);
	}
	beside = recorder->wishes_forced < PLANES_MAX && is_beside_finding(recorder, block->number);
	if (beside || block->number % recorder->plane_stride == 0)
		wish_for_plane(recorder, end, pair, beside);
}

bool recorder_nearest_point(struct recorder *recorder, vec3 *point)
{
	const struct scene_pair *pair = &recorder->scene->pairs[recorder->least_pair];
	const axis_values *axes = &recorder->least_at.axes;
	struct nearest_triangles nearest;
	xform pose;

	if (!(recorder->least < recorder->cap))
		return false;
	nearest_of(recorder, pair, axes, 1, &nearest);
	pose = mesh_pose(recorder->scene, pair->a, axes);
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
		.least = cap,
		.bound = cap,
		.position = machine_home(scene->machine),
		.tool = scene->setup ? scene->setup->initial_tool : 0,
		.ends = mem_zalloc(BLOCK_ENDS, sizeof(struct block_end)),
		.plane_stride = 1,
		.mode = -1,
		.stock = {.time = INFINITY},
	};
	file_index(recorder, program);
	recorded_table_init(&recorder->path, PATH_AXES + scene->machine->axis_count, keep_later);
	recorded_table_init(&recorder->clearance, CLEARANCE_COLUMNS, keep_least);
}

void recorder_release(struct recorder *recorder)
{
	for (size_t i = 0; i < recorder->finding_count; i++) {
		struct recorded_finding *it = &recorder->findings[i];

		json_decref(it->object);
		free(it->message);
		free(it->file);
		free(it->text);
	}
	for (size_t i = 0; i < recorder->file_count; i++)
		free(recorder->files[i].name);
	free(recorder->findings);
	free(recorder->files);
	free(recorder->ends);
	free(recorder->modes);
	free(recorder->wishes);
	free(recorder->planes);
	recorded_table_release(&recorder->path);
	recorded_table_release(&recorder->clearance);
	mesh_release(&recorder->stock.mesh);
	sweep_release(&recorder->sweep);
}

bool recorder_close(struct recorder *recorder, int *error)
{
	const bool path = recorded_table_close(&recorder->path);
	const bool clearance = recorded_table_close(&recorder->clearance);

	make_planes(recorder);
	if (!path || !clearance)
		*error = path ? recorder->clearance.error : recorder->path.error;
	return path && clearance;
}
