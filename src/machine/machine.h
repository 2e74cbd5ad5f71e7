/* machine.h - a machine tool: axes, links, bodies, and the rules about pairs. */
#ifndef FIVECHECK_MACHINE_MACHINE_H
#define FIVECHECK_MACHINE_MACHINE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/axes.h"
#include "base/diag.h"
#include "control/controller.h"
#include "geom/xform.h"
#include "machine/body.h"

/*
 * Everything is in machine coordinates at the zero pose (every axis at 0), in mm, radians and seconds. Link 0 is the
 * base; axes[i] carries link i + 1.
 */

struct axis {
	const char *name;	/* one of AXIS_LETTERS */
	const char *title;	/* or NULL */
	int slot;	/* index of its value in an axis_values */
	bool rotary;
	int parent;	/* the link that carries it */
	vec3 direction;	/* unit vector: the motion of the carried link for a positive value; rotary: right-handed */
	vec3 location;	/* a point on a rotary axis */
	double limit_min, limit_max;	/* mm or radians; -INFINITY, INFINITY: unlimited */
	double rate_max;	/* mm/s or radians/s; > 0 */
	double home;
	const char *checked;	/* why the axis is right although it looks wrong; or NULL */
	enum wrap wrap;
	int half_turn;	/* 1 or -1: the direction of half a turn, if both directions are equally long; 0: not known */
	long line;	/* in the XML file */
};

/* <pair>: the user's rule about two bodies, roles or links. */
enum pair_name_kind { NAME_LINK, NAME_ROLE, NAME_BODY };	/* from general to specific */

struct pair_name {
	enum pair_name_kind kind;
	int link;	/* NAME_LINK: the machine's own bodies on it */
	enum body_role role;	/* NAME_ROLE */
	const char *body;	/* NAME_BODY */
};

struct pair_rule {
	struct pair_name a, b;
	enum rule_check check;
	double clearance;	/* mm; negative: not given */
	const char *reason;	/* or NULL */
	long line;
};

struct spindle {
	bool present;
	int link;
	vec3 location;	/* the gauge point */
	vec3 direction;	/* unit, from the gauge point to the tool tip */
	const char *checked;	/* why the spindle is right although it looks wrong; or NULL */
};

struct workholding {
	bool present;
	int link;
	xform frame;
	const char *checked;	/* why the workholding is right although it looks wrong; or NULL */
};

struct setup;

struct machine {
	struct arena arena;	/* owns everything below */
	const char *path;	/* as given by the user */
	const char *name;	/* title of the machine; may be empty */
	struct controller controller;
	struct axis axes[SLOT_COUNT];	/* in file order: an axis before those that it carries */
	size_t axis_count;
	struct body *bodies;	/* in file order */
	size_t body_count;
	struct pair_rule *rules;	/* in file order; scene finds the bodies in machine and setup */
	size_t rule_count;
	double adjacent_within;	/* mm */
	const char *base_checked;	/* why the base is right although it looks wrong; or NULL */
	struct spindle spindle;
	struct workholding workholding;
	struct setup *setup;	/* the <setup> inside <machine>, or NULL; owned */
};

/* Reads a machine file and builds the machine. Every fault is reported with its place; NULL if there was one. */
struct machine *machine_load(const char *path, struct diag *diag);

/* The same; tool libraries outside the folder `root` (NULL: no such folder) are an error and not opened. */
struct machine *machine_load_within(const char *path, const char *root, struct diag *diag);

/*
 * Is the <controller> of a machine file valid for its dialect? The text is that of a whole file; the rest of it is not
 * checked. False: reported, without the name of a file.
 */
bool machine_check_controller(const char *text, struct diag *diag);

void machine_free(struct machine *machine);

/*
 * Reports names in <pair> that are not bodies of the machine, of its own setup or of `setup` (which may be NULL). These
 * are errors; without any setup they are warnings, because a setup may contain the body.
 */
bool machine_check_rules(const struct machine *machine, const struct setup *setup, struct diag *diag);

/* The axis on a slot, or NULL. */
const struct axis *machine_axis(const struct machine *machine, int slot);

/* Is the position (mm, radians) within the limits, or less than LIMIT_TOLERANCE outside? */
bool axis_allows(const struct axis *axis, double position);

/* "base" or the axis' name. */
const char *machine_link_name(const struct machine *machine, int link);

/* Home position of every axis, by slot. */
axis_values machine_home(const struct machine *machine);

#endif
