#include "check/measure/sensitivity.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "check/measure/path_record.h"
#include "motion/motion.h"

/*
 * In tolerances: a measured clearance may be too small by this amount; if less is left, no larger change can be proved.
 */
#define STALL 2
/* In tolerances: a change that is larger by this amount must find the body in the way, if there is one. */
#define PROBE 6

/* The most runs for one quantity in one direction. */
#define RUNS_MAX 60

/*
 * If there is a finding without a change: the number of parts of the range to try, and the number of halvings of the
 * part in which the verdict changes.
 */
#define PARTS 20
#define HALVINGS 6

struct search {
	const struct sensitivity_study *study;
	struct check_options options;
	const struct check_sink *sink;
	off_t start;
	struct path_record path;
	uint64_t digests[SLOT_COUNT];	/* of the recorded run */
	bool affects[SLOT_COUNT];	/* axes that the change moves */
	double spread;	/* distances change by at most this many times the change; INFINITY: not known */
	double *proven;	/* mm: clearance, of the run without a change or of the last measured run */
	struct sensitivity *answer;
	int runs;
};

/* The result of one run. */
struct probe {
	struct search *search;
	enum check_result result;
	bool orderly;	/* the path is the recorded one, as far as the run went */
	char *why;	/* the first error; owned */
};

static bool on_finding(void *context, const struct finding *finding)
{
	struct probe *probe = context;
	struct sensitivity *answer = probe->search->answer;
	const struct scene *scene = probe->search->study->scene;

	if (!answer)
		return false;
	answer->kind = (int)finding->kind;
	answer->line = finding->line;
	answer->a = answer->b = NULL;
	if (finding->kind == FINDING_LIMIT) {
		answer->slot = finding->of.limit.slot;
		return false;
	}
	/* The finding is valid only during this call; names owned by the scene stay valid. */
	for (size_t i = 0; i < scene->body_count; i++) {
		const char *body = scene->bodies[i].body->name;

		answer->a = strcmp(body, finding->of.pair.a) ? answer->a : body;
		answer->b = strcmp(body, finding->of.pair.b) ? answer->b : body;
	}
	return false;
}

static bool on_progress(void *context, long lines)
{
	const struct check_sink *sink = ((struct probe *)context)->search->sink;

	return !sink->progress || sink->progress(sink->context, lines);
}

static void on_fault(void *context, const struct diag_entry *entry)
{
	struct probe *probe = context;
	struct strbuf text = {0};

	if (entry->severity != DIAG_ERROR || probe->why)
		return;
	if (entry->loc.line)
		strbuf_addf(&text, "line %ld: ", entry->loc.line);
	strbuf_addf(&text, "%s", entry->text);
	probe->why = text.text;
}

/*
 * Checks the program with the answer's quantity changed by `amount` in its direction. Measures clearances as far as
 * they matter for a further change by `measures` mm; 0: none. The caller releases the probe's `why`.
 */
static struct probe run_changed(struct search *search, double amount, double measures)
{
	const struct sensitivity_study *study = search->study;
	const struct sensitivity *answer = search->answer;
	double change = answer ? answer->sign * amount : 0;
	struct probe probe = {.search = search};
	const struct check_sink sink = {&probe, on_finding, on_progress, NULL};
	struct diag diag = {.handle = on_fault, .context = &probe};
	struct setup_change changes = {{0, 0, 0}, 0};
	struct check_stats stats;

	if (answer) {
		changes.work.x = answer->quantity == CHANGE_X ? change : 0;
		changes.work.y = answer->quantity == CHANGE_Y ? change : 0;
		changes.work.z = answer->quantity == CHANGE_Z ? change : 0;
		changes.length = answer->quantity == CHANGE_LENGTH ? change : 0;
		path_record_compare(&search->path);
	} else {
		path_record_start(&search->path);
	}
	search->options.change = &changes;
	search->options.measure_cap = measures * fmin(search->spread, 1e3) + 2 * STALL * search->options.tolerance;
	search->runs++;
	if (fseeko(study->in, search->start, SEEK_SET))
		diag_error(&diag, (struct srcloc){0}, "cannot be read again: %s", strerror(errno));
	probe.result = check_run(study->scene, &search->options, study->in, study->name, &sink, &diag, &stats,
				 measures > 0 ? search->proven : NULL);
	if (diag.errors)
		probe.result = CHECK_INCOMPLETE;
	if (answer && probe.result == CHECK_CLEAR)
		path_record_end(&search->path);
	probe.orderly = search->path.same && !search->path.failed &&
			search->path.farthest <= amount * search->spread * (1 + 1e-9) + 1e-9;
	return probe;
}

/*
 * A change moves the spindle by its own amount, as seen from the other end of all linear axes. The share of a single
 * axis is no larger if the axes' directions are orthogonal. Else it is bounded by the least singular value of the
 * directions, whose square is at least 1 less the cosines between them (Gershgorin).
 */
static double spread_of(const struct machine *machine)
{
	double most = 0;

	for (int i = SLOT_X; i <= SLOT_Z; i++) {
		const struct axis *a = machine_axis(machine, i);
		double row = 0;

		for (int k = SLOT_X; a && k <= SLOT_Z; k++) {
			const struct axis *b = machine_axis(machine, k);

			row += b && k != i ? fabs(vec3_dot(a->direction, b->direction)) : 0;
		}
		most = fmax(most, row);
	}
	if (most < 1e-9)
		return 1;
	return most < 1 ? sqrt(3 / (1 - most)) : INFINITY;
}

/* mm: according to the last measurement, every smaller change keeps the pairs apart. */
static double room(const struct search *search)
{
	const struct scene *scene = search->study->scene;
	double least = INFINITY;

	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		bool affected = false;

		for (size_t k = 0; k < pair->chain.count; k++)
			affected |= search->affects[pair->chain.joints[k].slot];
		/* A change also moves the cuts, and so changes the remaining stock. */
		if (affected || pair->stock)
			least = fmin(least, search->proven[i] - pair->clearance);
	}
	return least / search->spread;
}

/* Ends the search without a result. The answer takes over `why`; NULL: no run failed. */
static void give_up(struct search *search, char *why, double at)
{
	search->answer->state = SENSITIVITY_UNKNOWN;
	search->answer->turn = at;
	search->answer->why = why;
}

/* run_changed() with a complete check. False: the check was incomplete, and the search ends. */
static bool run_completely(struct search *search, double amount, double measures, struct probe *probe)
{
	*probe = run_changed(search, amount, measures);
	if (probe->result == CHECK_INCOMPLETE) {
		give_up(search, probe->why, amount);
		return false;
	}
	free(probe->why);
	probe->why = NULL;
	return true;
}

static void set_turn(struct search *search, double at)
{
	search->answer->state = SENSITIVITY_TURNS;
	search->answer->turn = at;
}

/*
 * There is a finding at `high` and none at `low`: finds by halving where the verdict changes. proved: no bodies can
 * meet between the two, so the finding is a limit, and no change up to the last `low` reaches it.
 */
static void close_in(struct search *search, double low, double high, bool proved)
{
	double finest = PROBE * search->options.tolerance;

	while (high - low > finest && search->runs < RUNS_MAX) {
		double middle = 0.5 * (low + high);
		struct probe probe;

		if (!run_completely(search, middle, 0, &probe))
			return;
		if (probe.result == CHECK_FOUND)
			high = middle;
		else
			low = middle;
		proved = proved && probe.orderly;
	}
	/* Repeats the last run that found something: its finding is the one to report. */
	free(run_changed(search, high, 0).why);
	search->answer->tried = low;
	if (proved)
		search->answer->proved = low;
	set_turn(search, high);
}

/* Continues from a change of `low`, which was measured, with a larger one. True: the answer is found. */
static bool advance(struct search *search, double *low, double *stride, bool *proved)
{
	struct sensitivity *answer = search->answer;
	const double e = search->options.tolerance;
	double safe = room(search) - STALL * e;
	bool stalls = !(safe > STALL * e);
	double next = fmin(*low + (stalls ? *stride : safe), answer->range);
	struct probe probe;

	if (!run_completely(search, next, answer->range - next, &probe))
		return true;
	*proved = *proved && probe.orderly && (!stalls || probe.result == CHECK_FOUND);
	/* With stock nothing is proved: only halving finds where the verdict changes. */
	if (probe.result == CHECK_FOUND && (!stalls || scene_stock(search->study->scene) >= 0))
		close_in(search, *low, next, *proved && answer->kind == FINDING_LIMIT);
	else if (probe.result == CHECK_FOUND)
		set_turn(search, next);
	if (probe.result == CHECK_FOUND)
		return true;
	/* If nothing more can be proved, tries larger and larger steps. */
	*stride = stalls ? 2 * *stride : PROBE * e;
	*low = answer->tried = next;
	if (*proved)
		answer->proved = next;
	return !(next < answer->range);
}

/*
 * Finds the largest change with which a clear verdict holds. Before each run, search->proven has the measurements of
 * the unchanged program.
 */
static void search_clear(struct search *search)
{
	struct sensitivity *answer = search->answer;
	double stride = PROBE * search->options.tolerance, low = 0, first = fmin(stride, answer->range);
	struct probe probe;
	bool proved, any = false;

	if (!run_completely(search, first, 0, &probe))
		return;
	proved = probe.orderly;
	if (probe.result == CHECK_FOUND) {
		set_turn(search, first);
		return;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		search->affects[slot] = search->path.digests[slot] != search->digests[slot];
		any |= search->affects[slot];
	}
	if (!any && probe.orderly) {
		answer->proved = answer->tried = answer->range;
		return;
	}
	answer->state = SENSITIVITY_HOLDS;
	while (!advance(search, &low, &stride, &proved)) {
		if (search->runs >= RUNS_MAX) {
			give_up(search, NULL, low);
			return;
		}
	}
}

/* There is a finding without a change: searches for the first of the tried changes without one. */
static void search_found(struct search *search)
{
	struct sensitivity *answer = search->answer, found;
	double low = 0, high = 0;

	answer->state = SENSITIVITY_HOLDS;
	for (int i = 1; i <= PARTS && !(high > 0); i++) {
		double at = answer->range * i / PARTS;
		struct probe probe;

		if (!run_completely(search, at, 0, &probe))
			return;
		if (probe.result == CHECK_CLEAR)
			high = at;
		else
			low = answer->tried = at;
	}
	found = *answer;
	for (int i = 0; i < HALVINGS && high > 0; i++) {
		double middle = 0.5 * (low + high);
		struct probe probe;

		if (!run_completely(search, middle, 0, &probe))
			return;
		if (probe.result == CHECK_CLEAR)
			high = middle;
		else
			low = middle;
	}
	*answer = found;
	if (!(high > 0))
		return;
	answer->tried = low;
	answer->kind = -1;
	set_turn(search, high);
}

static void answer_one(struct search *search, struct sensitivity *answer, const double *proven)
{
	search->answer = answer;
	search->runs = 0;
	memcpy(search->proven, proven, search->study->scene->pair_count * sizeof(*proven));
	if (search->study->result == CHECK_CLEAR)
		search_clear(search);
	else
		search_found(search);
}

static size_t list_answers(const double range[CHANGES], struct sensitivity answers[2 * CHANGES])
{
	size_t count = 0;

	for (int quantity = 0; quantity < CHANGES; quantity++) {
		for (int sign = 1; sign >= -1 && range[quantity] > 0; sign -= 2)
			answers[count++] = (struct sensitivity){.quantity = quantity, .sign = sign, .kind = -1,
								.range = range[quantity]};
	}
	return count;
}

/* mm: the largest change of any quantity. */
static double largest_of(const double range[CHANGES])
{
	double largest = 0;

	for (int quantity = 0; quantity < CHANGES; quantity++)
		largest = fmax(largest, range[quantity]);
	return largest;
}

size_t sensitivity_run(const struct sensitivity_study *study, const struct check_sink *sink, struct diag *diag,
		       struct sensitivity answers[2 * CHANGES])
{
	struct search search = {.study = study, .options = *study->options, .sink = sink, .start = ftello(study->in),
				.spread = spread_of(study->scene->machine)};
	const size_t pair_count = study->scene->pair_count;
	size_t count = 0;
	struct probe probe;
	double *proven;

	if (!path_record_init(&search.path)) {
		diag_error(diag, (struct srcloc){0}, "--sensitivity: cannot make a temporary file: %s",
			   strerror(errno));
		return 0;
	}
	search.options.all = search.options.block_clearances = search.options.times = false;
	search.options.record = &search.path;
	/* The remaining stock is that of the program without a change. */
	search.options.remainder = NULL;
	search.proven = mem_zalloc(pair_count, sizeof(*search.proven));
	proven = mem_zalloc(pair_count, sizeof(*proven));
	probe = run_changed(&search, 0, largest_of(study->range));
	if (probe.result != study->result)
		diag_error(diag, (struct srcloc){0}, "%s could not be checked again%s%s", study->name,
			   probe.why ? ": " : "; it may have changed", probe.why ? probe.why : "");
	free(probe.why);
	if (probe.result == study->result) {
		memcpy(proven, search.proven, pair_count * sizeof(*proven));
		memcpy(search.digests, search.path.digests, sizeof(search.digests));
		count = list_answers(study->range, answers);
		for (size_t i = 0; i < count; i++)
			answer_one(&search, &answers[i], proven);
	}
	path_record_release(&search.path);
	free(search.proven);
	free(proven);
	return count;
}

void sensitivity_release(struct sensitivity *answers, size_t count)
{
	for (size_t i = 0; i < count; i++)
		free(answers[i].why);
}
