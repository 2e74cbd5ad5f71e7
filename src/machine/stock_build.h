/* stock_build.h - checks a described stock: the blank that feeding cutters cut. */
#ifndef FIVECHECK_MACHINE_STOCK_BUILD_H
#define FIVECHECK_MACHINE_STOCK_BUILD_H

#include "machine/description.h"
#include "machine/setup.h"

/* Completes the body and makes the triangles of a box or a cylinder. Faults are counted in the file. */
void stock_build(struct description_file *file, const struct body_description *described, struct setup *setup,
		 struct body *body);

#endif
