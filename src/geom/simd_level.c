#include "geom/simd_level.h"

#include <stdlib.h>
#include <string.h>

#include "base/ablation.h"

static int highest(void)
{
#if LANES_BEST == LANES_AVX2
	if (!WITH_SIMD)
		return LANES_SCALAR;
	return __builtin_cpu_supports("avx2") ? LANES_AVX2 : LANES_SSE2;
#else
	return LANES_SCALAR;
#endif
}

bool simd_level_of(const char *name, int *level)
{
	static const char *const names[] = {[LANES_SCALAR] = "scalar", [LANES_SSE2] = "sse2", [LANES_AVX2] = "avx2"};

	for (int i = 0; i <= highest(); i++) {
		if (!strcmp(name, names[i])) {
			*level = i;
			return true;
		}
	}
	return false;
}

int simd_level(void)
{
	const char *wanted = getenv(SIMD_LEVEL_VARIABLE);
	int level = highest();

	if (wanted)
		simd_level_of(wanted, &level);
	return level;
}
