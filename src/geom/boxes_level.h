/* boxes_level.h - boxes_apart as compiled for each level of SIMD; all give the same bits. */
#ifndef FIVECHECK_GEOM_BOXES_LEVEL_H
#define FIVECHECK_GEOM_BOXES_LEVEL_H

#include "geom/boxes.h"
#include "geom/simd_level.h"

boxes_apart_fn boxes_apart_scalar;
#if LANES_BEST == LANES_AVX2
boxes_apart_fn boxes_apart_sse2;
boxes_apart_fn boxes_apart_avx2;	/* only where simd_level() says so */
#endif

/* The function of a level that this processor has. */
boxes_apart_fn *boxes_at_level(int level);

#endif
