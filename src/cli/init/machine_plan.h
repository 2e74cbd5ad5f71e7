/* machine_plan.h - what options and answers tell `fivecheck init` about a machine. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/axes.h"
#include "base/diag.h"
#include "geom/vec3.h"

/* Which of the two chains the rotary axes stand in; the paper's machine is table-table. */
enum family { FAMILY_TABLE_TABLE, FAMILY_HEAD_HEAD, FAMILY_HEAD_TABLE, FAMILY_COUNT };

extern const char *const machine_plan_families[FAMILY_COUNT + 1];	/* ends in NULL */
extern const char *const machine_plan_rapids[], *const machine_plan_units[];	/* likewise */

/* What can be told; the numbers are those of the options without a letter. */
enum machine_plan_key {
	PLAN_HELP = 'h',
	PLAN_OUTPUT = 'o',
	PLAN_FAMILY = 256,
	PLAN_ROTARY, PLAN_HEAD, PLAN_TABLE, PLAN_LIMITS, PLAN_LOCATION, PLAN_SPINDLE,
	PLAN_SPINDLE_DIRECTION, PLAN_WORKHOLDING, PLAN_DIRECTION, PLAN_RATES, PLAN_HOME, PLAN_TITLE, PLAN_BODY,
	PLAN_NAME, PLAN_UNITS, PLAN_DIALECT, PLAN_RAPID,
	PLAN_KEY_END
};

/* Lengths in the units of the file that is to be written, angles in degrees, rates in these a minute. */
struct machine_plan_axis {
	bool has_limits, has_min, has_max;	/* has_limits alone: unlimited, as was said */
	double min, max;
	bool has_location, has_direction, has_rate, has_home;
	vec3 location, direction;
	double rate, home;
	const char *title;	/* or NULL */
};

/* Axes that carry each other, from the base on. */
struct machine_plan_chain {
	int slots[SLOT_COUNT];
	size_t count;
};

struct machine_plan_body {
	int slot;	/* -1: the base */
	const char *path, *name;
};

struct machine_plan {
	struct arena arena;	/* owns the texts */
	int family;	/* enum family; -1: not told */
	struct machine_plan_chain rotary;
	struct machine_plan_chain head, table;	/* linear axes as told; all axes once plan_finish is done */
	bool has_table, has_head;
	struct machine_plan_axis axes[SLOT_COUNT];
	bool has_spindle, has_workholding;
	vec3 spindle, spindle_direction, workholding;
	struct machine_plan_body *bodies;	/* owned */
	size_t body_count, body_capacity;
	const char *name;	/* or NULL */
	int inch, dialect, rapid;	/* index of the choices; -1: not told */
};

void machine_plan_init(struct machine_plan *plan);
void machine_plan_release(struct machine_plan *plan);

/* One more body on the axis of a slot, or on the base (-1); its file is the three texts in a row. */
void machine_plan_add_body(struct machine_plan *plan, int slot, const char *folder, const char *name,
			   const char *ending);

bool machine_plan_chain_has(const struct machine_plan_chain *chain, int slot);

/* Is it an axis of the machine? Known once the rotary axes are. */
bool machine_plan_has_axis(const struct machine_plan *plan, int slot);

/* Does it stand in the chain from the base to the table? After plan_finish. */
bool machine_plan_turns_table(const struct machine_plan *plan, int slot);

#endif
