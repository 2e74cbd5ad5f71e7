/*
 * vericut_model.h - a solid of a component in the machines and projects of VERICUT: a mesh, or one given by its sizes.
 */
#ifndef FIVECHECK_IMPORT_VERICUT_MODEL_H
#define FIVECHECK_IMPORT_VERICUT_MODEL_H

#include <stdbool.h>

#include "geom/mesh.h"
#include "import/import.h"
#include "import/vericut_components.h"

/* mm per unit of length of an element; 0, reported: the unit is unknown. */
double vericut_unit(struct xml_reader *xml, const xmlNode *node);

/* The name of a file without its folder and its suffix, in the arena. */
const char *vericut_stem(struct arena *arena, const char *path);

struct vericut_model {
	const char *name;	/* the name of its file, else of the component */
	xform frame;	/* of the component, combined with the model's own */
	struct mesh mesh;	/* the caller releases it */
	bool left_out;	/* its mesh is missing, which was reported as a warning: there is no mesh */
};

/* False, reported: the model is faulty, or its mesh is missing or faulty. */
bool vericut_model_read(struct vericut_model *model, struct xml_reader *xml, const xmlNode *node,
			const struct vericut_component *component, const struct import_options *options,
			struct arena *arena);

#endif
