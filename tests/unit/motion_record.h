/* motion_record.h - for the tests of motion: a converter on a machine, and everything that it sends. */
#ifndef FIVECHECK_TESTS_MOTION_RECORD_H
#define FIVECHECK_TESTS_MOTION_RECORD_H

#include <check.h>

#include "motion/canon_to_spans.h"
#include "motion/motion_kinematics.h"
#include "motion_rig.h"

#define EVENTS 64

/* Everything that a run sent. Steps beyond the array are counted, not kept. */
struct record {
	struct rig_messages messages;
	double flatness;
	struct motion_sink sink;
	struct canon_to_spans converter;
	struct motion_summary summary;
	struct motion_step steps[EVENTS];
	struct path paths[EVENTS];	/* of the steps: theirs are borrowed */
	int step_count;
	struct motion_limit limits[EVENTS];
	int limit_count, steps_before_limit;
	int tool, tool_changes, blocks, block_moves;
	axis_values tool_position;
	double block_seconds;
	char block_text[64];
	axis_values last;	/* where the steps have come to */
	double clock, travelled, worst_rate;	/* times of the rates, on a step's average */
	int stop_at;	/* the step that returns false; 0: none */
	long line;
};

static inline void on_limit(struct record *record, const struct motion_limit *limit)
{
	ck_assert_int_lt(record->limit_count, EVENTS);
	record->limits[record->limit_count++] = *limit;
	record->steps_before_limit = record->step_count;
}

static inline bool on_step(struct record *record, const struct motion_step *step)
{
	const struct machine *machine = record->converter.machine;

	/*
	 * Steps join without a gap, in place and in time. No step ends later than the next one begins, not even by the last
	 * bit: findings are sorted by their times.
	 */
	if (machine) {
		if (memcmp(&step->span.q0, &record->last, sizeof(record->last)) != 0 ||
		    !(fabs(step->time - record->clock) <= 1e-9) || step->time < record->clock)
			ck_abort_msg("the step at %.17g s does not join the last, at %.17g", step->time,
				     record->clock);
		for (size_t i = 0; i < machine->axis_count; i++) {
			int slot = machine->axes[i].slot;
			double rate = fabs(step->span.q1.v[slot] - step->span.q0.v[slot]) / step->seconds;

			record->worst_rate = fmax(record->worst_rate, rate / machine->axes[i].rate_max);
		}
	}
	record->last = step->span.q1;
	record->clock = step->time + step->seconds;
	record->travelled += step->seconds;
	if (record->step_count < EVENTS) {
		record->steps[record->step_count] = *step;
		record->paths[record->step_count] = *step->span.path;
		record->steps[record->step_count].span.path = &record->paths[record->step_count];
	}
	record->step_count++;
	return record->step_count != record->stop_at;
}

static inline void on_tool(struct record *record, const struct motion_tool *change)
{
	record->tool = change->tool;
	record->tool_changes++;
	record->tool_position = change->position;
}

static inline void on_block(struct record *record, const struct motion_block *block)
{
	record->blocks++;
	record->block_seconds = block->seconds;
	record->block_moves = block->moves;
	record->line = block->line;
	snprintf(record->block_text, sizeof(record->block_text), "%s", block->text);
}

static inline bool on_event(void *context, const struct motion_event *event)
{
	struct record *record = context;

	switch (event->kind) {
	case MOTION_STEP:
		return on_step(record, &event->of.step);
	case MOTION_LIMIT:
		on_limit(record, &event->of.limit);
		break;
	case MOTION_TOOL:
		on_tool(record, &event->of.tool);
		break;
	case MOTION_SPINDLE_STOP:
	case MOTION_MODES:
		break;
	case MOTION_BLOCK:
		on_block(record, &event->of.block);
		break;
	}
	return true;
}

static inline void listen(struct record *record)
{
	memset(record, 0, sizeof(*record));
	rig_listen(&record->messages);
	record->flatness = 0.001;
	record->sink = (struct motion_sink){record, on_event};
}

static inline void start(struct record *record, const struct machine *machine)
{
	listen(record);
	canon_to_spans_init(&record->converter, machine, NULL, record->flatness, &record->sink, &record->messages.diag,
			    "part.nc", &record->summary);
	record->last = record->converter.position;
}

static const struct canon_origin no_origin;

static inline struct canon_move move_to(enum canon_kind kind, axis_values end)
{
	return (struct canon_move){.kind = kind, .file = "part.nc", .line = 12, .number = 1, .end = end,
				   .origin = &no_origin, .feed = {.linear = 20, .angular = radians(30)}};
}

static inline bool carry_out(struct record *record, const struct canon_move *move)
{
	const struct canon_event event = {CANON_MOVE, .of.move = move};

	/* Tests change the machine between moves. */
	axis_table_init(&record->converter.axes, record->converter.machine);
	return canon_to_spans_event(&record->converter, &event);
}

static inline void go(struct record *record, struct canon_move move)
{
	ck_assert_msg(carry_out(record, &move), "%s", record->messages.text);
}

static inline bool switch_tcp(struct canon_to_spans *converter, const struct kinematics_tcp *state, struct srcloc loc,
			      axis_values *position)
{
	struct kinematics kinematics = motion_kinematics(converter);

	return kinematics.tcp(kinematics.context, state, loc, position);
}

static inline void guide(struct record *record, double length)
{
	struct kinematics_tcp state = {.on = true, .length = length};
	axis_values position = record->converter.position;

	ck_assert(switch_tcp(&record->converter, &state, (struct srcloc){"part.nc", 1, 1}, &position));
}

#endif
