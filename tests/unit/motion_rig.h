/* motion_rig.h - for the tests of motion: machines built by hand, repeatable random numbers, the diagnostics kept. */
#ifndef FIVECHECK_TESTS_MOTION_RIG_H
#define FIVECHECK_TESTS_MOTION_RIG_H

#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/units.h"
#include "machine/machine.h"
#include "motion/tcp.h"

/* xorshift64*: the same numbers on every machine. */
static inline double rig_random(uint64_t *state, double least, double most)
{
	uint64_t bits;

	*state ^= *state >> 12;
	*state ^= *state << 25;
	*state ^= *state >> 27;
	bits = *state * UINT64_C(2685821657736338717);
	return least + (most - least) * ((double)(bits >> 11) * 0x1p-53);
}

static inline int rig_pick(uint64_t *state, int count)
{
	return (int)rig_random(state, 0, count);
}

static inline vec3 rig_unit(uint64_t *state)
{
	for (;;) {
		vec3 v = {rig_random(state, -1, 1), rig_random(state, -1, 1), rig_random(state, -1, 1)};
		double norm = vec3_norm(v);

		if (norm > 0.1 && norm <= 1)
			return vec3_scale(1 / norm, v);
	}
}

static inline vec3 rig_point(uint64_t *state, double size)
{
	return (vec3){rig_random(state, -size, size), rig_random(state, -size, size), rig_random(state, -size, size)};
}

static inline vec3 rig_normalised(vec3 v)
{
	return vec3_scale(1 / vec3_norm(v), v);
}

/* Adds an axis that hangs on link `parent`; returns its link. Unlimited; 500 mm/s, 90 degrees/s. */
static inline int rig_axis(struct machine *machine, int slot, int parent, vec3 direction, vec3 location)
{
	static const char *const names[SLOT_COUNT] = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};
	bool rotary = slot_is_rotary(slot);

	machine->axes[machine->axis_count++] =
		(struct axis){.name = names[slot], .slot = slot, .rotary = rotary, .parent = parent,
			      .direction = rig_normalised(direction), .location = location, .limit_min = -INFINITY,
			      .limit_max = INFINITY, .rate_max = rotary ? radians(90) : 500};
	return (int)machine->axis_count;
}

static inline struct axis *rig_find(struct machine *machine, int slot)
{
	for (size_t i = 0; i < machine->axis_count; i++)
		if (machine->axes[i].slot == slot)
			return &machine->axes[i];
	return NULL;
}

/* Spindle down, table up, neither yet tied to a link but the base. */
static inline struct machine rig_machine(void)
{
	struct machine machine;

	memset(&machine, 0, sizeof(machine));
	machine.spindle.present = machine.workholding.present = true;
	machine.spindle.location = (vec3){0, 0, 520};
	machine.spindle.direction = (vec3){0, 0, -1};
	machine.workholding.frame = xform_identity();
	machine.workholding.frame.translation = (vec3){0, 0, 120};
	return machine;
}

static const vec3 rig_x = {1, 0, 0}, rig_y = {0, 1, 0}, rig_z = {0, 0, 1}, rig_minus_x = {-1, 0, 0},
		  rig_minus_z = {0, 0, -1}, rig_origin = {0, 0, 0};

/* bed -> X -> Y -> Z with the spindle; the table stands. */
static inline struct machine rig_three_axes(void)
{
	struct machine machine = rig_machine();
	int link = rig_axis(&machine, SLOT_X, 0, rig_x, rig_origin);

	link = rig_axis(&machine, SLOT_Y, link, rig_y, rig_origin);
	machine.spindle.link = rig_axis(&machine, SLOT_Z, link, rig_z, rig_origin);
	return machine;
}

/* The arrangement of the paper: bed -> Y -> X -> Z with the spindle, bed -> A -> C with the table. */
static inline struct machine rig_trunnion(void)
{
	struct machine machine = rig_machine();
	int link = rig_axis(&machine, SLOT_Y, 0, rig_y, rig_origin);

	link = rig_axis(&machine, SLOT_X, link, rig_x, rig_origin);
	machine.spindle.link = rig_axis(&machine, SLOT_Z, link, rig_z, rig_origin);
	link = rig_axis(&machine, SLOT_A, 0, rig_minus_x, (vec3){0, 0, 120});
	machine.workholding.link = rig_axis(&machine, SLOT_C, link, rig_minus_z, (vec3){0, 0, 120});
	return machine;
}

enum rig_family {
	RIG_AC_TABLE,
	RIG_BC_TABLE,	/* Y carries the table, so linear axes on both sides */
	RIG_CB_HEAD,
	RIG_B_HEAD_C_TABLE,
	RIG_NUTATING_HEAD,	/* C, then B about an axis at 45 degrees */
	RIG_NUTATING_TABLE,
	RIG_SKEW,	/* linear axes neither orthogonal nor in order, a W besides, one tilted rotary axis each side */
	RIG_C_TABLE,	/* one rotary axis only */
	RIG_B_HEAD,
	RIG_FAMILIES
};

/* Linear axes on the head side in some order, after those of `table` on the table side. Sets both links. */
static inline void rig_linear(struct machine *machine, uint64_t *random, bool y_moves_table)
{
	static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
	const int *order = orders[rig_pick(random, 6)];
	const vec3 directions[3] = {rig_x, y_moves_table ? (vec3){0, -1, 0} : rig_y, rig_z};

	for (int i = 0; i < 3; i++) {
		bool table = order[i] == SLOT_Y && y_moves_table;
		int *link = table ? &machine->workholding.link : &machine->spindle.link;

		*link = rig_axis(machine, order[i], *link, directions[order[i]], rig_origin);
	}
}

static inline void rig_skew_linear(struct machine *machine, uint64_t *random)
{
	vec3 lean = rig_point(random, 0.3);
	int head = rig_axis(machine, SLOT_Z, 0, vec3_add(rig_z, lean), rig_origin);
	int table = rig_axis(machine, SLOT_Y, 0, vec3_add((vec3){0, -1, 0}, rig_point(random, 0.3)), rig_origin);

	head = rig_axis(machine, SLOT_X, head, vec3_add(rig_x, rig_point(random, 0.3)), rig_origin);
	machine->spindle.link = rig_axis(machine, SLOT_W, head, vec3_add(rig_z, rig_point(random, 0.3)), rig_origin);
	machine->workholding.link = table;
}

static inline void rig_rotary(struct machine *machine, uint64_t *random, bool on_table, int slot, vec3 direction)
{
	int *link = on_table ? &machine->workholding.link : &machine->spindle.link;
	vec3 location = vec3_add(rig_point(random, 100), (vec3){0, 0, on_table ? 120 : 700});

	*link = rig_axis(machine, slot, *link, rig_pick(random, 2) ? direction : vec3_scale(-1, direction), location);
}

/* A machine of the family, its rotary axes somewhere near table or spindle. */
static inline struct machine rig_random_machine(uint64_t *random, enum rig_family family)
{
	const vec3 tilted = {0, 1, 1};
	struct machine machine = rig_machine();

	if (family == RIG_SKEW)
		rig_skew_linear(&machine, random);
	else
		rig_linear(&machine, random, family == RIG_BC_TABLE || family == RIG_NUTATING_HEAD);
	switch (family) {
	case RIG_AC_TABLE:
	case RIG_BC_TABLE:
		rig_rotary(&machine, random, true, family == RIG_AC_TABLE ? SLOT_A : SLOT_B,
			   family == RIG_AC_TABLE ? rig_x : rig_y);
		rig_rotary(&machine, random, true, SLOT_C, rig_z);
		break;
	case RIG_CB_HEAD:
	case RIG_NUTATING_HEAD:
		rig_rotary(&machine, random, false, SLOT_C, rig_z);
		rig_rotary(&machine, random, false, SLOT_B, family == RIG_CB_HEAD ? rig_y : tilted);
		break;
	case RIG_B_HEAD_C_TABLE:
		rig_rotary(&machine, random, false, SLOT_B, rig_y);
		rig_rotary(&machine, random, true, SLOT_C, rig_z);
		break;
	case RIG_NUTATING_TABLE:
		rig_rotary(&machine, random, true, SLOT_B, tilted);
		rig_rotary(&machine, random, true, SLOT_C, rig_z);
		break;
	case RIG_SKEW:
		rig_rotary(&machine, random, true, SLOT_A, rig_unit(random));
		rig_rotary(&machine, random, false, SLOT_C, rig_unit(random));
		break;
	case RIG_C_TABLE:
		rig_rotary(&machine, random, true, SLOT_C, rig_z);
		break;
	case RIG_B_HEAD:
		rig_rotary(&machine, random, false, SLOT_B, rig_y);
		break;
	case RIG_FAMILIES:
		break;
	}
	return machine;
}

/* The last message, and how many there were. */
struct rig_messages {
	struct diag diag;
	char text[512];
	struct srcloc loc;
};

static inline void rig_keep(void *context, const struct diag_entry *entry)
{
	struct rig_messages *messages = context;

	snprintf(messages->text, sizeof(messages->text), "%s", entry->text);
	messages->loc = entry->loc;
}

static inline void rig_listen(struct rig_messages *messages)
{
	memset(messages, 0, sizeof(*messages));
	messages->diag.handle = rig_keep;
	messages->diag.context = messages;
}

static inline struct tcp rig_tcp(const struct machine *machine, const struct kinematics_tcp *state)
{
	struct rig_messages messages;
	struct tcp tcp;

	rig_listen(&messages);
	ck_assert_msg(tcp_init(&tcp, machine, state, (struct srcloc){NULL, 0, 0}, &messages.diag), "%s", messages.text);
	return tcp;
}

static inline struct kinematics_tcp rig_tcp_state(const struct machine *machine, uint64_t *random)
{
	struct kinematics_tcp state = {.on = true, .length = rig_random(random, 0, 200)};

	for (size_t i = 0; i < machine->axis_count; i++)
		if (machine->axes[i].rotary && rig_pick(random, 2))
			state.rotary_zero.v[machine->axes[i].slot] = rig_random(random, -2, 2);
	return state;
}

static inline axis_values rig_position(const struct machine *machine, uint64_t *random)
{
	axis_values q = {{0}};

	for (size_t i = 0; i < machine->axis_count; i++) {
		bool rotary = machine->axes[i].rotary;

		q.v[machine->axes[i].slot] = rig_random(random, rotary ? -4 : -300, rotary ? 4 : 300);
	}
	return q;
}

#endif
