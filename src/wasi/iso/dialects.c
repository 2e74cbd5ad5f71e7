/* dialects.c - in place of src/gcode/dialect/dialects.c: some controls are not linked in (src/wasi/Makefile). */
#include "gcode/dialect/dialects.h"

#include "wasi/other_module.h"

/* The address of one that is not there is NULL. */
#define WEAK_DIALECT(id, ...) extern const struct dialect dialect_##id __attribute__((weak));
DIALECTS(WEAK_DIALECT)
#undef WEAK_DIALECT

#define ADDRESS(id, ...) &dialect_##id,

const struct dialect *dialect_of_row(int row)
{
	static const struct dialect *const dialects[] = {DIALECTS(ADDRESS)};

	if (!dialects[row])
		other_module();
	return dialects[row];
}
