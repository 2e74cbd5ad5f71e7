/* scene.h - all bodies of machine and setup with their meshes, and the pairs that must be kept apart. */
#ifndef FIVECHECK_SCENE_SCENE_H
#define FIVECHECK_SCENE_SCENE_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag.h"
#include "control/step_class.h"
#include "geom/bvh.h"
#include "machine/chain.h"
#include "machine/doubt.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "scene/sweep.h"

/* Why a pair is or is not checked. */
enum pair_status {
	PAIR_CHECKED,
	PAIR_RIGID,	/* no joint between them */
	PAIR_ADJACENT,	/* neighbours of the machine's structure, close together by design: excused, not proved */
	PAIR_OUT_OF_REACH,	/* proved apart over the whole travel */
	PAIR_WAIVED,	/* by the user */
	PAIR_CUTTING	/* a cutter and the part or stock that it cuts, but not at rapid nor too deep */
};

/* The kind of finding when the bodies of a pair meet. */
enum pair_fault { PAIR_COLLISION, PAIR_RAPID_CONTACT, PAIR_GOUGE };

struct scene_body {
	const struct body *body;
	struct bvh *bvh;	/* NULL for a core or a piece given by sections, until scene_body_bvh builds it */
	struct bvh *coarse;	/* NULL until scene_body_coarse builds it */
	struct topology *topology;	/* NULL until asked for */
	bool balance_known, balanced;	/* as edge_balance.h; set by scene_body_is_balanced */
	struct body_shapes *shapes;	/* NULL until a pair needs them */
	pthread_mutex_t building;	/* guards the members above: each is built by the first thread that needs it */
	double depth;	/* mm: of a core, below the surface of the cutter */
	const struct tool_solid *core;	/* the sections of a core; its tree is built when a check needs it */
};

struct scene_pair {
	int a, b;	/* bodies, a before b */
	enum pair_status status;
	enum pair_fault fault;
	unsigned steps;	/* bits of enum step_class: the classes in which the pair must stay apart */
	double clearance;	/* mm: the required clearance */
	char *reason;	/* one line, for people */
	bool stock;	/* one body is the stock, which cutters change: see check/stock_check.h */
	double inset;	/* mm: how deep the cutter of such a pair may enter the stock */
	struct chain chain;	/* from a to b */
};

struct scene {
	const struct machine *machine;	/* borrowed */
	const struct setup *setup;	/* borrowed, or NULL */
	struct scene_body *bodies;	/* of the machine, fixtures and parts, tools; in the order of the XML */
	size_t body_count;
	/*
	 * After the bodies come cores: the inner part of a cutter (machine/tool_core.h). A pair of a cutter and a part
	 * uses the core of the cutter. The struct body of a core is that of the cutter, without its solid.
	 */
	size_t core_count;
	struct arena cores;
	struct scene_pair *pairs;	/* every pair: (0,1) (0,2) ...; a cutter and a part have several */
	size_t pair_count;
	size_t meshes_read;	/* from files; pieces of tools given by sections are not counted */
	struct doubts doubts;	/* filled by model_check, with the next two */
	size_t open_bodies;	/* number of bodies of checked pairs with an open mesh */
	int first_open;	/* the first of them */
	struct sweep sweep;	/* working storage for queries of one thread */
};

/*
 * Collects the bodies, reads all their meshes, and derives the required pairs. `clearance` (mm) is for pairs without a
 * clearance of their own. Uses up to `threads` threads. Afterwards several threads may check programs on the scene.
 * NULL if an error was reported.
 */
struct scene *scene_new(const struct machine *machine, const struct setup *setup, double clearance, int threads,
			struct diag *diag);
void scene_free(struct scene *scene);

/* Must a check examine the pair, at least in some steps? */
bool scene_pair_needs_check(const struct scene_pair *pair);

/* The body's triangles in mm, in a mesh that the caller releases. False: reported. */
bool scene_read_mesh(const struct body *body, struct mesh *out, struct diag *diag);

/* The body's tree. */
const struct bvh *scene_body_bvh(struct scene *scene, int body);

/*
 * The core of a cutter given by sections, `depth` mm below its surface. It is a body of the scene, made at the first
 * call.
 */
int scene_core(struct scene *scene, int body, double depth);

/* Is the body's mesh closed (edge_balance.h)? This costs a fifth of a topology. */
bool scene_body_is_balanced(struct scene *scene, int body);

/* The topology of the body's mesh, built at the first call. */
const struct topology *scene_body_topology(struct scene *scene, int body);

/* The pair for a sweep; valid as long as the scene. */
struct body_pair scene_pair_bodies(struct scene *scene, const struct scene_pair *pair);

/* The body of the stock; -1: there is none. */
int scene_stock(const struct scene *scene);

/* For a tool's piece given by sections: a tree over few triangles that enclose it. For one thread at a time. */
const struct bvh *scene_body_coarse(struct scene *scene, int body);

/* The number of meshes read or made, and of bodies with a tree. */
void scene_count_meshes(struct scene *scene, size_t *read, size_t *trees);

size_t scene_count_pairs(const struct scene *scene, enum pair_status status);

/* "checked", "rigid", "adjacent", "out of reach", "waived" */
const char *pair_status_name(enum pair_status status);

#endif
