/* body_build.h - makes bodies of descriptions, for machines and setups. */
#ifndef FIVECHECK_MACHINE_BODY_BUILD_H
#define FIVECHECK_MACHINE_BODY_BUILD_H

#include "machine/description.h"

/* Names are compared each with each. */
#define BODIES_MAX 4096

/* Fills in name, mesh and place on `mount`. False: the name was reported as reserved. */
bool body_build(struct description_file *file, const struct body_description *described, const xform *mount,
		struct body *body);

/* Reports, at `at`, a name that one of `count` bodies has already. */
void body_check_name(struct description_file *file, const void *at, const char *name, const struct body *bodies,
		     size_t count);

#endif
