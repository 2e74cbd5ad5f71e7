/* model.h - everything that programs are checked against: a machine, a setup, and the scene of their bodies. */
#ifndef FIVECHECK_CHECK_MODEL_H
#define FIVECHECK_CHECK_MODEL_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "scene/scene.h"

/* Nothing changes after loading, so several threads may check programs on one model. */
struct model {
	struct machine *machine;
	const struct setup *setup;	/* the loaded one, or the machine's own; NULL: none */
	struct setup *loaded;	/* the setup of a file of its own; or NULL */
	int threads;	/* that read the meshes; 0: one */
	struct scene *scene;	/* NULL until model_add_scene */
	struct scene bodiless;	/* machine and setup without a mesh, for a program that is only read */
};

/*
 * Reads a machine file, and a setup file unless it is NULL. Tool libraries outside of the folder `root` (NULL: none is)
 * are not opened. NULL: reported.
 */
struct model *model_load(const char *machine, const char *setup, const char *root, struct diag *diag);

/* NULL is fine. */
void model_free(struct model *model);

/*
 * Reads the bodies and derives the pairs that must be kept apart, by `clearance` mm if no rule says otherwise. False:
 * reported.
 */
bool model_add_scene(struct model *model, double clearance, struct diag *diag);

/* The scene; without one, machine and setup alone. */
struct scene *model_scene(struct model *model);

#endif
