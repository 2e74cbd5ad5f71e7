/* finding.h - one violation, with everything that is reported about it. */
#ifndef FIVECHECK_CHECK_FINDING_H
#define FIVECHECK_CHECK_FINDING_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/diag.h"
#include "geom/vec3.h"
#include "motion/events.h"
#include "scene/scene.h"
#include "scene/tri_pair.h"

enum finding_kind {
	FINDING_COLLISION,
	FINDING_CLEARANCE,
	FINDING_LIMIT,
	FINDING_START_OVERLAP,
	FINDING_RAPID_CONTACT,	/* a cutter enters the part while it does not cut */
	FINDING_GOUGE	/* a cutter enters the part too deep while it cuts */
};
enum { FINDING_KINDS = FINDING_GOUGE + 1 };

/* "collision", "clearance", "limit", "start-overlap", "rapid-contact", "gouge"; ends in NULL. */
extern const char *const finding_kind_names[FINDING_KINDS + 1];

/* Two bodies are, or may be, too close to each other. */
struct pair_finding {
	const char *a, *b;	/* names of the bodies */
	const char *link_a, *link_b;	/* and of their links */
	vec3 point;	/* machine coordinates, mm */
	double clearance;	/* measured distance at that instant on the programmed path, mm; 0 when they meet */
	double path_displacement;	/* mm: the path tolerance can take so much of it; 0: nothing, or not known */
	double required;	/* c */
	bool with_stock;	/* one of the bodies is the stock: */
	bool certain;	/* material that no cutter can have touched is met in this block; else it may be gone */
	/* FINDING_RAPID_CONTACT, FINDING_GOUGE: */
	bool b_is_cutter;	/* else a is */
	double depth;	/* mm: how deep the cutter may enter the part */
	int step_class;	/* enum step_class; 0: the axes stand */
};

/* Valid only during the call that hands it over. */
struct finding {
	enum finding_kind kind;
	const char *file;
	long line;
	int column;	/* 1 */
	const char *text;	/* of the block */
	/*
	 * The block stands in a subprogram, which was called from here; the call of its caller comes next, and so on.
	 */
	const struct srcloc *callers;
	size_t caller_count;	/* 0: it stands in the program itself */
	int move, moves;	/* which of the block's moves, from 1 */
	double fraction;	/* of the block's motion, by time, 0 to 1 */
	double time;	/* s since the start of the program */
	double stock_time;	/* the same in steps of the program, as the log of cuts counts (stock/cut_log.h) */
	axis_values axes;	/* machine axis positions, mm and radians */
	int tool;	/* in the spindle; 0: none */
	union {
		struct travel_excess limit;	/* FINDING_LIMIT */
		struct pair_finding pair;	/* all other kinds */
	} of;
};

/* Makes a finding of a contact, whose point is in a's mesh coordinates. The caller fills in block, move and time. */
struct finding finding_of_pair(const struct scene *scene, const struct scene_pair *pair, enum finding_kind kind,
			       const struct contact *contact, int tool);

const char *finding_kind_name(enum finding_kind kind);

#endif
