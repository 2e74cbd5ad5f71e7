#include "check/model.h"

#include <stdlib.h>

#include "base/mem.h"
#include "machine/kinematics_check.h"

static const struct srcloc nowhere;

static bool load_setup(struct model *model, const char *machine, const char *path, const char *root,
		       struct diag *diag)
{
	model->setup = model->machine->setup;
	if (!path)
		return true;
	if (model->setup)
		diag_note(diag, nowhere, "the setup %s is used, not the one inside %s", path, machine);
	model->loaded = setup_load_within(path, model->machine, root, diag);
	model->setup = model->loaded;
	return model->loaded != NULL;
}

struct model *model_load(const char *machine, const char *setup, const char *root, struct diag *diag)
{
	struct model *model = mem_zalloc(1, sizeof(*model));

	model->machine = machine_load_within(machine, root, diag);
	if (model->machine && load_setup(model, machine, setup, root, diag) &&
	    machine_check_rules(model->machine, model->setup, diag)) {
		model->bodiless.machine = model->machine;
		model->bodiless.setup = model->setup;
		kinematics_check(model->machine, &model->bodiless.doubts);
		return model;
	}
	model_free(model);
	return NULL;
}

void model_free(struct model *model)
{
	if (!model)
		return;
	scene_free(model->scene);
	doubts_release(&model->bodiless.doubts);
	setup_free(model->loaded);
	machine_free(model->machine);
	free(model);
}

bool model_add_scene(struct model *model, double clearance, struct diag *diag)
{
	model->scene = scene_new(model->machine, model->setup, clearance, model->threads, diag);
	return model->scene != NULL;
}

struct scene *model_scene(struct model *model)
{
	return model->scene ? model->scene : &model->bodiless;
}
