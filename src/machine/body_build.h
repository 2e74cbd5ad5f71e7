/* body_build.h - makes bodies from descriptions, for machines and setups. */
#ifndef FIVECHECK_MACHINE_BODY_BUILD_H
#define FIVECHECK_MACHINE_BODY_BUILD_H

#include "machine/description.h"

/* Every name is compared with every other, so the number of bodies is limited. */
#define BODIES_MAX 4096

/* Sets the body's name, mesh and placement; `mount` carries it. False, reported: the name is reserved. */
bool body_build(struct description_file *file, const struct body_description *described, const xform *mount,
		struct body *body);

/* mm: a permitted depth in the body, from an attribute that the file may omit. Reports a value out of range. */
double body_build_depth(struct description_file *file, const void *at, const char *element, const char *name,
			struct optional_number described, double fallback);

/* Reports at `at` if one of `count` bodies already has the name. */
void body_check_name(struct description_file *file, const void *at, const char *name, const struct body *bodies,
		     size_t count);

#endif
