/* machine_plan.h - the data of a machine that `fivecheck init` has from options and answers. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/axes.h"
#include "base/diag.h"
#include "geom/vec3.h"

/*
 * What the two rotary axes carry; the machine of Chen, Lin and Chang is table-table. A nutating table rotates about an
 * axis between two coordinate axes, and carries a second rotary axis; a nutating head is carried by another one.
 */
enum family {
	FAMILY_TABLE_TABLE,
	FAMILY_HEAD_HEAD,
	FAMILY_HEAD_TABLE,
	FAMILY_NUTATING_TABLE,
	FAMILY_NUTATING_HEAD,
	FAMILY_COUNT
};

extern const char *const machine_plan_families[FAMILY_COUNT + 1];	/* ends in NULL */
extern const char *const machine_plan_rapids[], *const machine_plan_units[];	/* likewise */

/* Keys of the options; those without a letter are above 255. */
enum machine_plan_key {
	PLAN_HELP = 'h',
	PLAN_OUTPUT = 'o',
	PLAN_FAMILY = 256,
	PLAN_ROTARY, PLAN_HEAD, PLAN_TABLE, PLAN_LIMITS, PLAN_LOCATION, PLAN_SPINDLE,
	PLAN_SPINDLE_DIRECTION, PLAN_WORKHOLDING, PLAN_DIRECTION, PLAN_INCLINATION, PLAN_RATES, PLAN_HOME, PLAN_TITLE,
	PLAN_BODY, PLAN_NAME, PLAN_UNITS, PLAN_DIALECT, PLAN_RAPID, PLAN_TOOL_CHANGE,
	PLAN_CONTROLLER,
	PLAN_KEY_END
};

/* Lengths in the units of the machine file, angles in degrees, rates in these per minute. */
struct machine_plan_axis {
	bool has_limits, has_min, has_max;	/* only has_limits: the user said that there is no limit */
	double min, max;
	bool has_location, has_direction, has_inclination, has_rate, has_home, has_change;
	vec3 location, direction;
	double inclination;	/* of A and B: from Z towards X and Y, as the head turns; 90: the usual A and B */
	double rate, home;
	double change;	/* the position to which M6 moves the axis */
	const char *title;	/* or NULL */
};

/* Axes in the order in which they carry each other, starting at the base. */
struct machine_plan_chain {
	int slots[SLOT_COUNT];
	size_t count;
};

struct machine_plan_body {
	int slot;	/* -1: the base */
	const char *path, *name;
};

/* An attribute of <controller>, besides dialect and rapid. */
struct machine_plan_answer {
	const char *name, *value;
};

struct machine_plan {
	struct arena arena;	/* owns the texts */
	int family;	/* enum family; -1: unknown */
	struct machine_plan_chain rotary;
	struct machine_plan_chain head, table;	/* linear axes; after machine_plan_finish all axes */
	bool has_table, has_head;
	struct machine_plan_axis axes[SLOT_COUNT];
	bool has_spindle, has_workholding;
	bool has_tool_change, changes_anywhere;	/* the latter: --tool-change=none */
	vec3 spindle, spindle_direction, workholding;
	struct machine_plan_body *bodies;	/* owned */
	size_t body_count, body_capacity;
	struct machine_plan_answer *answers;	/* owned */
	size_t answer_count, answer_capacity;
	const char *name;	/* or NULL */
	int inch, dialect, rapid;	/* index of the choice; -1: unknown */
};

void machine_plan_init(struct machine_plan *plan);
void machine_plan_release(struct machine_plan *plan);

/* Adds a body on the axis of a slot, or on the base (-1). Its file name consists of the three texts. */
void machine_plan_add_body(struct machine_plan *plan, int slot, const char *folder, const char *name,
			   const char *ending);

bool machine_plan_chain_has(const struct machine_plan_chain *chain, int slot);

/* The slot of the axis at 45 degrees between two coordinate axes; -1: the family has none. */
int machine_plan_tilted(const struct machine_plan *plan);

/* Is the slot an axis of the machine? Valid as soon as the rotary axes are known. */
bool machine_plan_has_axis(const struct machine_plan *plan, int slot);

/* Does the axis move the table? Valid after machine_plan_finish. */
bool machine_plan_turns_table(const struct machine_plan *plan, int slot);

#endif
