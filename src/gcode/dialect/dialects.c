#include "gcode/dialect/dialects.h"

#define ADDRESS(id, ...) &dialect_##id,

const struct dialect *dialect_of_row(int row)
{
	static const struct dialect *const dialects[] = {DIALECTS(ADDRESS)};

	return dialects[row];
}
