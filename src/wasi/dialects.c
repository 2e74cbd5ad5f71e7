/* dialects.c - replaces src/gcode/dialect/dialects.c: some dialects are in separate parts (src/wasi/parts). */
#include "gcode/dialect/dialects.h"
#include "wasi/part_dialects.h"

const struct dialect *dialect_of_row(int row)
{
#define GETTER(id, ...) dialect_##id##_get,
	static const struct dialect *(*const getters[])(void) = {DIALECTS(GETTER)};
#undef GETTER

	return getters[row]();
}
