/* body_xml.h - reads the elements of machine and setup that name a mesh. */
#ifndef FIVECHECK_MACHINE_XML_BODY_XML_H
#define FIVECHECK_MACHINE_XML_BODY_XML_H

#include <stdbool.h>

#include "base/arena.h"
#include "machine/machine.h"
#include "machine/xml/xml_read.h"

/* Names are compared each with each. */
#define BODIES_MAX 4096

/* Sets mesh_path (relative to the file's folder) and scale; false if it was reported as faulty. */
bool body_read_mesh(struct xml_reader *xml, const xmlNode *node, struct arena *arena, struct body *body);

/* A <body>, <fixture> or <part>, placed by its location and rotation on `mount`. */
bool body_read(struct xml_reader *xml, const xmlNode *node, struct arena *arena, const xform *mount,
	       struct body *body);

/* Reports a name that one of `count` bodies has already. */
void body_check_name(struct xml_reader *xml, const xmlNode *node, const char *name, const struct body *bodies,
		     size_t count);

#endif
