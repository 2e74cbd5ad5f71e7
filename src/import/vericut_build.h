/*
 * vericut_build.h - decides which components of a setup of VERICUT are mounted as work, and which belong to the
 * machine.
 */
#ifndef FIVECHECK_IMPORT_VERICUT_BUILD_H
#define FIVECHECK_IMPORT_VERICUT_BUILD_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "machine/xml/xml_reader.h"

/* More than any machine has. The tree is searched by names, so a limit keeps hostile files fast. */
enum { VERICUT_COMPONENTS_MAX = 1000 };

struct vericut_part {
	const xmlNode *node;
	const char *name, *type, *attach;
	const struct vericut_part *parent;	/* the part to which it is attached; NULL: none of the setup */
	const char *carrier;	/* the axis of the setup, or the component of the machine, that carries it in the end */
	bool mounted;	/* the setup mounts it as work; else it belongs to the machine */
};

/*
 * The components of a <Build>. They are attached to each other and to components of the machine. The mount carries the
 * work: it is a component of the machine, or an axis of the setup, such as an added rotary table. A component on the
 * mount without another axis between them is mounted. All others belong to the machine: the axes of the setup, and
 * components beside the work, such as a tailstock.
 */
struct vericut_build {
	struct xml_reader *xml;
	struct vericut_part *parts;	/* in the order of the file; in the arena */
	size_t count;
	const char *mount;	/* NULL: the setup has no components */
	const char *other_mount;	/* the carrier of another stock or design, without a model; or NULL */
};

bool vericut_part_is_axis(const struct vericut_part *part);
bool vericut_part_has_model(const struct vericut_part *part);

/* Is a child element of a component a model? */
bool vericut_part_is_model(const xmlNode *node);

/*
 * Reads the components of a <Setup>. The mount is the carrier of the stock and the design that have a model; if none
 * has one, that of the first work offset's place; else that of the first stock, design or fixture. False, reported: a
 * component lacks its name, or models of stock and design have several carriers.
 */
bool vericut_build_read(struct vericut_build *build, struct xml_reader *xml, const xmlNode *setup, struct arena *arena);

/*
 * Do both setups have the same mount, and the same components of the machine, apart from their appearance? False,
 * reported.
 */
bool vericut_build_same(const struct vericut_build *build, const struct vericut_build *first);

#endif
