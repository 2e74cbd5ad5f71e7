/* vericut_components.h - the tree of components of a VERICUT machine: which carries which, and the place of each. */
#ifndef FIVECHECK_IMPORT_VERICUT_COMPONENTS_H
#define FIVECHECK_IMPORT_VERICUT_COMPONENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "geom/xform.h"
#include "import/vericut_build.h"
#include "machine/xml/foreign_xml.h"

struct vericut_component {
	const xmlNode *node;
	struct xml_reader *xml;	/* of its file: of the machine, or of a project */
	const char *name, *type, *attach;	/* attach: the name of its carrier, "" for the base */
	struct vericut_component *parent;	/* NULL: none */
	xform frame;	/* in machine coordinates with every axis at 0, mm */
	bool placed;
	bool of_setup, mounted;	/* it is in a setup, which mounts it as work: it does not belong to the machine */
	bool carries_work;	/* it carries the mount of the work, directly or indirectly */
	int slot;	/* of the axis; -1: it is not an axis */
	int link;	/* its link: 0 the base, else 1 + the number of the axis */
};

struct vericut_components {
	struct vericut_component *items;	/* in the order of the file; in the arena */
	struct vericut_component **order;	/* a carrier comes before the components that it carries */
	size_t count;
};

/*
 * Reads the components of <VcMachine>, which are attached to one base, and those of a setup (`build`, or NULL), which
 * are attached to each other and to the machine. False, reported: a part of the tree is missing, occurs twice, or
 * carries itself.
 */
bool vericut_components_read(struct vericut_components *components, struct xml_reader *xml, const xmlNode *root,
			     const struct vericut_build *build, struct arena *arena);

/* Places the components that a setup mounts as work, relative to its mount. False: reported. */
bool vericut_components_mounted(struct vericut_components *components, const struct vericut_build *build,
				struct arena *arena);

struct vericut_component *vericut_components_find(const struct vericut_components *components, const char *name);

/* <Position> and <Rotation> of an element as a motion: R = Rz Ry Rx, degrees. Missing values are 0. */
bool vericut_frame(struct xml_reader *xml, const xmlNode *node, xform *frame);

#endif
