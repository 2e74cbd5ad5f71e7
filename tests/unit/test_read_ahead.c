/* What another thread hears of a program is what motion_run says of it: every call, in order, to the bit. */
#include "check/read_ahead.h"

#include <stdlib.h>

#include "base/mem.h"
#include "motion_rig.h"
#include "random.h"
#include "suite.h"

/* A checksum of every call so far: FNV-1a, with http://www.isthe.com/chongo/tech/comp/fnv for its constants. */
struct log {
	uint64_t sum, *sums;
	size_t count, capacity, stop_at;	/* the call that returns false, from 1; 0: none */
	struct diag diag;
	struct file_names names;
	long diags;
};

static void mix(struct log *log, const void *bytes, size_t size)
{
	for (size_t i = 0; i < size; i++)
		log->sum = (log->sum ^ ((const unsigned char *)bytes)[i]) * UINT64_C(0x100000001b3);
}

static void mix_text(struct log *log, const char *text)
{
	mix(log, text ? text : "", text ? strlen(text) + 1 : 1);
}

static void mix_axes(struct log *log, const axis_values *q)
{
	mix(log, q->v, sizeof(q->v));
}

static void mix_summary(struct log *log, const struct motion_summary *s)
{
	const long counts[] = {s->lines, s->blocks, s->moves, s->spans, s->blend_unbounded};

	mix(log, counts, sizeof(counts));
	mix(log, &s->seconds, sizeof(s->seconds));
}

static bool heard(struct log *log)
{
	log->sums = mem_grow(log->sums, &log->capacity, log->count + 1, sizeof(*log->sums));
	log->sums[log->count++] = log->sum;
	return log->count != log->stop_at;
}

static void mix_limit(struct log *log, const struct motion_limit *limit)
{
	const long numbers[] = {1, limit->slot, limit->line, limit->move, limit->tool};
	const double reals[] = {limit->bound, limit->time, limit->block_time};

	mix(log, numbers, sizeof(numbers));
	mix(log, reals, sizeof(reals));
	mix_axes(log, &limit->position);
	mix_text(log, limit->file);
}

static void mix_step(struct log *log, const struct motion_step *step)
{
	const long numbers[] = {2, step->line, step->move, step->tool, step->outside, step->span.path->kind};
	const double reals[] = {step->time, step->block_time, step->seconds, step->span.u0, step->span.u1};
	struct span halves[2];

	mix(log, numbers, sizeof(numbers));
	mix(log, reals, sizeof(reals));
	mix_axes(log, &step->span.q0);
	mix_axes(log, &step->span.q1);
	mix_axes(log, &step->span.chord_error);
	mix_axes(log, &step->tolerance);
	/* The path is known by where it leads. */
	if (step->span.path->kind != PATH_BOX) {
		span_halve(&step->span, &halves[0], &halves[1]);
		mix_axes(log, &halves[1].q0);
	}
	mix_text(log, step->file);
}

static void mix_tool(struct log *log, const struct motion_tool *change)
{
	const int numbers[] = {3, change->tool};

	mix(log, numbers, sizeof(numbers));
	mix_axes(log, &change->position);
}

static void mix_block(struct log *log, const struct motion_block *block)
{
	const long numbers[] = {4, block->line, block->moves};

	mix(log, numbers, sizeof(numbers));
	mix(log, &block->seconds, sizeof(block->seconds));
	mix_text(log, block->file);
	mix_text(log, block->text);
	for (size_t i = 0; i < block->caller_count; i++) {
		mix(log, &block->callers[i].line, sizeof(block->callers[i].line));
		mix_text(log, block->callers[i].file);
	}
}

static bool on_event(void *context, const struct motion_event *event)
{
	struct log *log = context;

	switch (event->kind) {
	case MOTION_STEP:
		mix_step(log, &event->of.step);
		break;
	case MOTION_LIMIT:
		mix_limit(log, &event->of.limit);
		break;
	case MOTION_TOOL:
		mix_tool(log, &event->of.tool);
		break;
	case MOTION_SPINDLE_STOP:
		mix_tool(log, &(struct motion_tool){0, event->of.spindle_stop.position});
		break;
	case MOTION_MODES:
		mix(log, &event->of.modes.feed, sizeof(event->of.modes.feed));
		mix(log, &event->of.modes.spindle_speed, sizeof(event->of.modes.spindle_speed));
		mix_axes(log, &event->of.modes.work);
		mix_text(log, event->of.modes.work_offset ? event->of.modes.work_offset : "none");
		break;
	case MOTION_BLOCK:
		mix_block(log, &event->of.block);
		break;
	}
	mix_summary(log, &event->summary);
	return heard(log);
}

static void on_diag(void *context, const struct diag_entry *entry)
{
	struct log *log = context;
	const long numbers[] = {5, entry->severity, entry->loc.line, entry->loc.column};

	mix(log, numbers, sizeof(numbers));
	mix_text(log, entry->loc.file);
	mix_text(log, entry->text);
	mix_text(log, entry->excerpt);
	heard(log);
	log->diags++;
}

/* Moves of all kinds, dwells, tools, moves past a limit, and sometimes a fault at the end. */
static char *random_program(struct random *random)
{
	struct strbuf text = {0};
	int lines = (int)random_size(random, 1, 20000);

	strbuf_addf(&text, "o<over> sub\nG1 X#1\no<over> endsub\no<up> sub\nG1 Z10\no<over> call [#1]\no<up> endsub\n"
			   "G21 G90 G17 F1000\n");
	for (int i = 0; i < lines; i++) {
		double x = random_in(random, -100, 100), y = random_in(random, -100, 100);

		switch (random_below(random, 40)) {
		case 0:
			strbuf_addf(&text, "G2 X%.3f Y%.3f R200\n", x, y);
			break;
		case 1:
			strbuf_addf(&text, "T%d M6 (a tool)\n", 1 + random_below(random, 2));
			break;
		case 2:
			strbuf_addf(&text, "G4 P0.5\n");
			break;
		case 4:
			strbuf_addf(&text, "o<up> call [%.3f]\n", x);
			break;
		case 5:
			strbuf_addf(&text, "F%.1f S%d M3\n", 500 + fabs(x), 100 * random_below(random, 90));
			break;
		case 3:
			strbuf_addf(&text, "G0 Z%.3f\n", random_in(random, -60, 60));
			break;
		default:
			strbuf_addf(&text, "G1 X%.3f Y%.3f\n", x, y);
		}
	}
	strbuf_addf(&text, random_below(random, 3) ? "M30\n" : "G1 Q1\n");
	return text.text;
}

typedef bool run_fn(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		    FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		    struct motion_summary *summary);

static bool run_ahead(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		      FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		      struct motion_summary *summary)
{
	struct shared_loop loop;
	bool ok;

	shared_loop_init(&loop);
	ok = read_ahead_run(machine, setup, options, in, name, sink, diag, summary, &loop);
	shared_loop_release(&loop);
	return ok;
}

static bool run(run_fn *how, struct log *log, const char *program, size_t stop_at, struct motion_summary *summary)
{
	struct machine machine = rig_three_axes();
	struct tool tools[] = {{.number = 1, .name = "", .length = 80, .diameter = 6},
			       {.number = 2, .name = "", .length = 70, .diameter = 6}};
	struct setup setup = {.tools = tools, .tool_count = 2};
	struct motion_options options = {.flatness = 0.01, .names = &log->names, .modes = true};
	const struct motion_sink sink = {log, on_event};
	FILE *in = fmemopen((void *)(uintptr_t)program, strlen(program), "r");
	bool ok;

	ck_assert_ptr_nonnull(in);
	rig_find(&machine, SLOT_Z)->limit_max = 50;
	*log = (struct log){.sum = UINT64_C(0xcbf29ce484222325), .stop_at = stop_at};
	log->diag = (struct diag){.handle = on_diag, .context = log};
	ok = how(&machine, &setup, &options, in, "part.nc", &sink, &log->diag, summary);
	fclose(in);
	return ok;
}

static void release(struct log *log)
{
	free(log->sums);
	file_names_release(&log->names);
}

static void compare(const struct log *want, const struct log *got, long n)
{
	size_t first = 0;

	while (first < want->count && first < got->count && want->sums[first] == got->sums[first])
		first++;
	require(first == want->count && first == got->count, "case %ld: call %zu differs, of %zu and %zu", n, first,
		want->count, got->count);
}

START_TEST(all_is_heard_as_it_was_said)
{
	long diags = 0;

	for (long n = 0; n < random_cases(60); n++) {
		struct random random = random_case(1, n);
		char *program = random_program(&random);
		struct motion_summary summaries[2];
		struct log want, got;
		bool ok = run(motion_run, &want, program, 0, &summaries[0]);

		ck_assert(run(run_ahead, &got, program, 0, &summaries[1]) == ok);
		compare(&want, &got, n);
		mix_summary(&want, &summaries[0]);
		mix_summary(&got, &summaries[1]);
		require(want.sum == got.sum, "case %ld: the summaries differ", n);
		diags += want.diags;
		release(&want);
		release(&got);
		free(program);
	}
	ck_assert_int_gt(diags, 0);
}
END_TEST

START_TEST(a_listener_may_stop)
{
	for (long n = 0; n < random_cases(60); n++) {
		struct random random = random_case(2, n);
		char *program = random_program(&random);
		struct motion_summary summaries[2];
		struct log all, want, got;
		size_t stop_at;

		run(motion_run, &all, program, 0, &summaries[0]);
		stop_at = 1 + (size_t)random_in(&random, 0, (double)(all.count - (size_t)all.diags));
		run(motion_run, &want, program, stop_at, &summaries[0]);
		ck_assert(!run(run_ahead, &got, program, stop_at, &summaries[1]));
		compare(&want, &got, n);
		release(&all);
		release(&want);
		release(&got);
		free(program);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("calls");

	tcase_add_test(tcase, all_is_heard_as_it_was_said);
	tcase_add_test(tcase, a_listener_may_stop);
	return run_suite("read_ahead", tcase);
}
