/* vericut_components.h - the tree of components of a VERICUT machine: who carries whom, and where each stands. */
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
	struct xml_reader *xml;	/* of the file that it is in: of the machine, or of a project */
	const char *name, *type, *attach;	/* attach: the name of what carries it, "" for the base */
	struct vericut_component *parent;	/* NULL: none */
	xform frame;	/* in machine coordinates with every axis at 0, mm */
	bool placed;
	bool of_setup, mounted;	/* it stands in a setup, which mounts it as work: it is no part of the machine */
	bool carries_work;	/* the mount of the work is on it, or on what it carries */
	int slot;	/* of the axis that it is; -1: it is none */
	int link;	/* that it belongs to: 0 the base, else 1 + the number of the axis */
};

struct vericut_components {
	struct vericut_component *items;	/* in the order of the file; in the arena */
	struct vericut_component **order;	/* what carries comes before what it carries */
	size_t count;
};

/*
 * Reads the components of <VcMachine>, which hang on one base, and with them those of a setup (`build`, or NULL), which
 * hang on each other and on the machine. False, reported: a part of the tree is missing, doubled, or carries itself.
 */
bool vericut_components_read(struct vericut_components *components, struct xml_reader *xml, const xmlNode *root,
			     const struct vericut_build *build, struct arena *arena);

/* Places the components that a setup mounts as work against its mount. False: reported. */
bool vericut_components_mounted(struct vericut_components *components, const struct vericut_build *build,
				struct arena *arena);

struct vericut_component *vericut_components_find(const struct vericut_components *components, const char *name);

/* <Position> and <Rotation> of an element as a motion: R = Rz Ry Rx, degrees. What is missing is 0. */
bool vericut_frame(struct xml_reader *xml, const xmlNode *node, xform *frame);

#endif
