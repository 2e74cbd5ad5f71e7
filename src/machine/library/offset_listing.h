/* offset_listing.h - reads offsets that a control exports as a program: lines like "G10 L10 P1 R120.5". */
#ifndef FIVECHECK_MACHINE_LIBRARY_OFFSET_LISTING_H
#define FIVECHECK_MACHINE_LIBRARY_OFFSET_LISTING_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/library/tool_library.h"

/* Does one of the first lines contain G10? */
bool offset_listing_is(const char *text);

/*
 * Adds the work offsets (L2: P1 to P6 are G54 to G59; L20: G54.1 P1 and on) and the values of H (L10 geometry, L11 or
 * L1 wear) and D (L12, L13); geometry and wear are added. D is a radius or a diameter, as for the control
 * (length_offset_description.d_of_control). `unit` is mm per unit of length, until G20 or G21. Numbers need a decimal
 * point: without it the control's least increment decides. The common offset (L2 P0) must be 0. Anything else is an
 * error. False: reported.
 */
bool offset_listing_read(struct tool_library *tools, const char *text, const char *path, double unit,
			 struct diag *diag);

#endif
