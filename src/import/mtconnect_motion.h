/* mtconnect_motion.h - the kinematic chain in a device description of MTConnect: its Motion elements. */
#ifndef FIVECHECK_IMPORT_MTCONNECT_MOTION_H
#define FIVECHECK_IMPORT_MTCONNECT_MOTION_H

#include <stdbool.h>

#include "geom/xform.h"
#include "machine/xml/xml_reader.h"

/* The element after `node` in the tree below `root`, in the order of the file; or NULL. */
const xmlNode *mtconnect_next(const xmlNode *root, const xmlNode *node);

/* The Motion of a component, or NULL. */
const xmlNode *mtconnect_motion(const xmlNode *component);

/*
 * The Motion that carries this one; *parent is NULL: there is none. False, reported: the file refers to a missing
 * Motion.
 */
bool mtconnect_parent(struct xml_reader *xml, const xmlNode *device, const xmlNode *motion, const xmlNode **parent);

/*
 * The line along or about which a Motion moves, in its coordinate system, mm. The standard does not define whether the
 * Transformation of a Motion with a parent is relative to the parent or to the coordinate system: if the two differ in
 * a way that matters (for a motion along a line its place does not), the Motion is rejected. location may be NULL.
 * False: reported.
 */
bool mtconnect_line(struct xml_reader *xml, const xmlNode *device, const xmlNode *motion, vec3 *direction,
		    vec3 *location);

#endif
