/* vericut_components.h - the tree of components of a VERICUT machine: who carries whom, and where each stands. */
#ifndef FIVECHECK_IMPORT_VERICUT_COMPONENTS_H
#define FIVECHECK_IMPORT_VERICUT_COMPONENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "geom/xform.h"
#include "machine/xml/foreign_xml.h"

struct vericut_component {
	const xmlNode *node;
	const char *name, *type, *attach;	/* attach: the name of what carries it, "" for the base */
	struct vericut_component *parent;	/* NULL: none */
	xform frame;	/* in machine coordinates with every axis at 0, mm */
	bool placed;
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
 * Reads the components of an element. Those of <VcMachine> hang on one base (`mount` is NULL); those of the <Build> of a
 * setup hang on `mount`, the component that carries the work, and their frames are relative to it. False, reported: a
 * part of the tree is missing, doubled, or carries itself.
 */
bool vericut_components_read(struct vericut_components *components, struct xml_reader *xml, const xmlNode *root,
			     const char *mount, struct arena *arena);

struct vericut_component *vericut_components_find(const struct vericut_components *components, const char *name);

/* <Position> and <Rotation> of an element as a motion: R = Rz Ry Rx, degrees. What is missing is 0. */
bool vericut_frame(struct xml_reader *xml, const xmlNode *node, xform *frame);

#endif
