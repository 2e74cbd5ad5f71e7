#include "wasi/part_dialects.h"

#define GETTER(id, ...) \
	const struct dialect *dialect_##id##_get(void) \
	{ \
		return &dialect_##id; \
	}

DIALECTS(GETTER)
