#include "check/checker.h"

#include <time.h>

#include "base/mem.h"
#include "check/step.h"
#include "scene/static_query.h"

double checker_clock(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The caller holds the lock `telling`. */
static void ask_progress(struct checker *c)
{
	if (!c->sink->progress(c->sink->context, c->checked_line) && !(c->refused > 0))
		c->refused = checker_clock();
}

bool checker_asks(void *context)
{
	struct checker *c = context;
	bool gives_up = false;

	if (c->sink->progress && !pthread_mutex_trylock(&c->telling)) {
		ask_progress(c);
		gives_up = c->refused > 0 && checker_clock() > c->refused + GRACE_SECONDS;
		pthread_mutex_unlock(&c->telling);
	}
	return gives_up || cancel_asked(c->options->read.cancel);
}

bool checker_goes_on(struct checker *c)
{
	bool goes_on;

	if (!c->sink->progress)
		return true;
	pthread_mutex_lock(&c->telling);
	ask_progress(c);
	goes_on = !(c->refused > 0);
	pthread_mutex_unlock(&c->telling);
	return goes_on;
}

bool checker_ends_share(const struct checker *c, double seconds)
{
	return c->program.share_blocks + 1 >= SHARE_BLOCKS && seconds > 0;
}

void checker_end_block(struct checker *c, double seconds)
{
	const bool ends = checker_ends_share(c, seconds);

	c->program.block++;
	c->program.share += ends;
	c->program.share_blocks = ends ? 0 : c->program.share_blocks + 1;
}

/* --------------------------------------------------------------- findings */

/*
 * The contact with its measured distance, if a clearance is required or if the control may leave the path by
 * `tolerance` (NULL: it may not).
 */
static struct contact measured(struct checker *c, const struct scene_pair *pair, const struct contact *found,
			       const axis_values *tolerance)
{
	struct contact contact = *found;
	struct body_pair bodies;

	if (pair->stock || (!tolerance && !(pair->clearance > 0)) || !(contact.distance > 0))
		return contact;
	bodies = scene_pair_bodies(c->scene, pair);
	sweep_nearest(&c->sweep, &bodies, &contact);
	if (tolerance)
		contact.path_displacement = body_pair_path_displacement(&bodies, &contact.q, tolerance);
	return contact;
}

/* The kind of a finding of this pair; `kind` is that of an ordinary pair, which must always stay apart. */
static enum finding_kind kind_of(const struct scene_pair *pair, enum finding_kind kind)
{
	switch (pair->fault) {
	case PAIR_RAPID_CONTACT:
		return FINDING_RAPID_CONTACT;
	case PAIR_GOUGE:
		return FINDING_GOUGE;
	case PAIR_COLLISION:
		break;
	}
	return kind;
}

void checker_add_finding(struct checker *c, const struct block_finding *at, enum finding_kind kind, int move,
			 int step_class, const struct contact *found, const axis_values *tolerance)
{
	const struct scene_pair *pair = &c->scene->pairs[at->rank];
	const struct contact contact = measured(c, pair, found, tolerance);
	struct block_finding finding = *at;

	finding.finding = finding_of_pair(c->scene, pair, kind_of(pair, kind), &contact, c->program.tool);
	finding.finding.of.pair.step_class = step_class;
	finding.finding.move = move;
	finding.finding.time = at->finding.time;
	finding.finding.stock_time = at->finding.stock_time;
	finding.finding.of.pair.certain = at->finding.of.pair.certain;
	block_log_add_finding(&c->log, &finding);
	c->end.found = true;
}

static void add_contact(struct checker *c, const struct pair_result *result)
{
	const struct scene_pair *pair = &c->scene->pairs[result->pair];
	const struct batch_step *step = &c->pending.settling->batch.steps[result->step];
	const struct motion_step *motion = &step->motion;
	const double since = result->contact.s * motion->seconds;
	const struct block_finding at = {.finding.time = motion->time + since,
					 .finding.of.pair.certain = result->certain,
					 .finding.stock_time = (double)step->number + result->contact.s,
					 .block = step->block, .block_time = motion->block_time + since,
					 .order = 2 * step->number + 1, .rank = (int)result->pair};

	checker_add_finding(
	    c, &at, pair->clearance > 0 ? FINDING_CLEARANCE : FINDING_COLLISION, motion->move, (int)motion->step_class,
	    &result->contact,
	    step_may_leave_path(&pair->chain, motion) && !step_is_box(motion) ? &motion->tolerance : NULL);
}

/*
 * The messages that follow belong to this block, at this place in it (struct block_finding). Like messages of the
 * interpreter they wait until the block is settled, because an earlier finding may end the check.
 */
static void begin_messages(struct checker *c, long block, long order)
{
	c->log.diags.mark = block;
	c->log.diags.order = order;
}

/* The messages that follow come from reading again. */
static void end_messages(struct checker *c)
{
	c->log.diags.mark = c->program.block;
	c->log.diags.order = 0;
}

void checker_say_undecided(struct checker *c, size_t pair, long block, long order)
{
	if (!c->undecided)
		c->undecided = mem_zalloc(c->scene->pair_count, sizeof(*c->undecided));
	if (c->undecided[pair])
		return;
	c->undecided[pair] = true;
	begin_messages(c, block, order);
	static_query_report_undecided(c->scene, &c->scene->pairs[pair], c->options->tolerance, &c->log.diags.diag);
	end_messages(c);
}

/* What to do about a step that needs too much effort, after the reason for it. */
static const char *remedy_of(const struct checker *c, const struct motion_step *motion)
{
	if (!step_is_box(motion))
		return "they stay close together for too long. The check stops here; give a larger --tolerance, or "
		       "split the move";
	switch (c->scene->machine->controller.rapid) {
	case RAPID_ANY:
		return "too many axes move at once in this rapid, whose path is not known (rapid=\"any\"); set the "
		       "kind of rapid in the machine file, or move fewer axes at once";
	case RAPID_DOGLEG:
		return "too many axes move at once in this rapid, whose path is not known (rapid=\"dogleg\": with "
		       "TCP each axis goes to the end by itself); move fewer axes at once, or set rapid=\"linear\" in "
		       "the machine file if the control guides the tip";
	case RAPID_LINEAR:
		break;
	}
	return "too many axes move at once in this rapid, whose path is not known; move fewer axes at once";
}

static void say_exhausted(struct checker *c, const struct pair_result *result, const struct batch_step *step)
{
	const struct scene_pair *pair = &c->scene->pairs[result->pair];
	const struct motion_step *motion = &step->motion;

	begin_messages(c, step->block, 2 * step->number + 1);
	diag_error(&c->log.diags.diag, (struct srcloc){motion->file, motion->line, 1},
		   "'%s' and '%s' cannot be decided with reasonable effort: %s", c->scene->bodies[pair->a].body->name,
		   c->scene->bodies[pair->b].body->name, remedy_of(c, motion));
	end_messages(c);
}

static void report_undecided(struct checker *c, const struct pair_result *result)
{
	const struct batch_step *step = &c->pending.settling->batch.steps[result->step];

	if (result->exhausted)
		say_exhausted(c, result, step);
	else
		checker_say_undecided(c, result->pair, step->block, 2 * step->number + 1);
	if (!pair_result_ends(result, &c->pending.settling->batch, c->options))
		return;
	c->end.exhausted = true;
	c->end.exhausted_step = step->number;
	c->end.last_block = step->block;
}

size_t checker_last_step(const struct checker *c, const struct pair_results *results, size_t last)
{
	const struct batch *batch = &c->pending.settling->batch;

	for (size_t i = 0; i < results->count; i++) {
		const struct pair_result *result = &results->items[i];

		if (result->step < last && pair_result_ends(result, batch, c->options))
			last = result->step;
	}
	return last;
}

void checker_take_results(struct checker *c, const struct pair_results *results, size_t last)
{
	for (size_t i = 0; i < results->count; i++) {
		const struct pair_result *result = &results->items[i];

		if (result->step > last)
			continue;
		if (result->answer == QUERY_CONTACT)
			add_contact(c, result);
		else
			report_undecided(c, result);
	}
}

/* Do this finding and all later ones come after the step that ended the check? */
static bool is_too_late(const struct checker *c, const struct block_finding *finding)
{
	return c->end.exhausted && finding->order > 2 * c->end.exhausted_step + 1;
}

void checker_hand_on_findings(struct checker *c)
{
	struct block_log *log = &c->log;
	size_t done = 0;
	struct finding finding;

	block_log_sort(log);
	while (!c->end.stopped && done < log->finding_count && !is_too_late(c, &log->findings[done]) &&
	       block_log_finding(log, done, &finding)) {
		const long block = log->findings[done].block;

		diag_queue_deliver(&log->diags, c->diag, block);
		c->stats->findings++;
		done++;
		if (!c->sink->finding(c->sink->context, &finding) || !c->options->all) {
			c->end.stopped = true;
			c->end.last_block = block;
		}
	}
	block_log_drop_findings(log, done);
	if (!c->end.stopped && (!c->end.found || c->options->all))
		diag_queue_deliver(&log->diags, c->diag,
				   c->end.exhausted ? c->end.last_block : c->pending.settling->block);
}
