/*
 * lanes.h - eight floats side by side: the only file with SIMD instructions.
 *
 * A file defines LANES_LEVEL before it includes this one and gets the type and its operations at that level. Every
 * level gives the same bits: each operation is correctly rounded and none is fused with another. Wider vectors
 * (AVX-512) gain nothing, because nodes have eight children.
 */
#ifndef FIVECHECK_GEOM_LANES_H
#define FIVECHECK_GEOM_LANES_H

#include <stdbool.h>

#include "geom/simd_level.h"

enum { LANES = 8 };

#if LANES_LEVEL == LANES_AVX2

#include <immintrin.h>

/* The attribute of a function that uses lanes. */
#define LANES_TARGET __attribute__((target("avx2")))
#define LANES_FUNCTION static inline __attribute__((always_inline, target("avx2")))

typedef __m256 lanes;

LANES_FUNCTION lanes lanes_load(const float *from) { return _mm256_loadu_ps(from); }
LANES_FUNCTION void lanes_store(float *to, lanes a) { _mm256_storeu_ps(to, a); }
LANES_FUNCTION lanes lanes_all(float value) { return _mm256_set1_ps(value); }
LANES_FUNCTION lanes lanes_add(lanes a, lanes b) { return _mm256_add_ps(a, b); }
LANES_FUNCTION lanes lanes_sub(lanes a, lanes b) { return _mm256_sub_ps(a, b); }
LANES_FUNCTION lanes lanes_mul(lanes a, lanes b) { return _mm256_mul_ps(a, b); }
LANES_FUNCTION lanes lanes_min(lanes a, lanes b) { return _mm256_min_ps(a, b); }
LANES_FUNCTION lanes lanes_max(lanes a, lanes b) { return _mm256_max_ps(a, b); }
LANES_FUNCTION lanes lanes_abs(lanes a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a); }
LANES_FUNCTION lanes lanes_sqrt(lanes a) { return _mm256_sqrt_ps(a); }
LANES_FUNCTION lanes lanes_swap_halves(lanes a) { return _mm256_permute2f128_ps(a, a, 1); }
LANES_FUNCTION lanes lanes_swap_quarters(lanes a) { return _mm256_permute_ps(a, _MM_SHUFFLE(1, 0, 3, 2)); }
LANES_FUNCTION lanes lanes_swap_neighbours(lanes a) { return _mm256_permute_ps(a, _MM_SHUFFLE(2, 3, 0, 1)); }

/* Is every lane of a above that of b? */
LANES_FUNCTION bool lanes_above(lanes a, lanes b)
{
	return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_GT_OQ)) == 0xff;
}

/* Bit i is set where lane i of a is at least that of b. */
LANES_FUNCTION unsigned lanes_reaching(lanes a, lanes b)
{
	return (unsigned)_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_GE_OQ));
}

/* Lane i of a where bit i is set, of b where it is not. */
LANES_FUNCTION lanes lanes_where(unsigned bits, lanes a, lanes b)
{
	const __m256i lane = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
	const __m256i set = _mm256_and_si256(_mm256_set1_epi32((int)bits), lane);

	return _mm256_blendv_ps(b, a, _mm256_castsi256_ps(_mm256_cmpeq_epi32(set, lane)));
}

LANES_FUNCTION float lanes_first(lanes a) { return _mm256_cvtss_f32(a); }

#elif LANES_LEVEL == LANES_SSE2

#include <emmintrin.h>

#define LANES_TARGET
#define LANES_FUNCTION static inline __attribute__((always_inline))

typedef struct lanes {
	__m128 low, high;
} lanes;

#define LANES_BOTH(operation) ((lanes){operation(a.low, b.low), operation(a.high, b.high)})

LANES_FUNCTION lanes lanes_load(const float *from) { return (lanes){_mm_loadu_ps(from), _mm_loadu_ps(from + 4)}; }
LANES_FUNCTION lanes lanes_all(float value) { return (lanes){_mm_set1_ps(value), _mm_set1_ps(value)}; }
LANES_FUNCTION lanes lanes_add(lanes a, lanes b) { return LANES_BOTH(_mm_add_ps); }
LANES_FUNCTION lanes lanes_sub(lanes a, lanes b) { return LANES_BOTH(_mm_sub_ps); }
LANES_FUNCTION lanes lanes_mul(lanes a, lanes b) { return LANES_BOTH(_mm_mul_ps); }
LANES_FUNCTION lanes lanes_min(lanes a, lanes b) { return LANES_BOTH(_mm_min_ps); }
LANES_FUNCTION lanes lanes_max(lanes a, lanes b) { return LANES_BOTH(_mm_max_ps); }
LANES_FUNCTION lanes lanes_sqrt(lanes a) { return (lanes){_mm_sqrt_ps(a.low), _mm_sqrt_ps(a.high)}; }
LANES_FUNCTION lanes lanes_swap_halves(lanes a) { return (lanes){a.high, a.low}; }

#define LANES_SHUFFLED(order) ((lanes){_mm_shuffle_ps(a.low, a.low, order), _mm_shuffle_ps(a.high, a.high, order)})

LANES_FUNCTION lanes lanes_swap_quarters(lanes a) { return LANES_SHUFFLED(_MM_SHUFFLE(1, 0, 3, 2)); }
LANES_FUNCTION lanes lanes_swap_neighbours(lanes a) { return LANES_SHUFFLED(_MM_SHUFFLE(2, 3, 0, 1)); }

LANES_FUNCTION bool lanes_above(lanes a, lanes b)
{
	return (_mm_movemask_ps(_mm_cmpgt_ps(a.low, b.low)) & _mm_movemask_ps(_mm_cmpgt_ps(a.high, b.high))) == 0xf;
}

LANES_FUNCTION unsigned lanes_reaching(lanes a, lanes b)
{
	return (unsigned)(_mm_movemask_ps(_mm_cmpge_ps(a.low, b.low)) |
			  _mm_movemask_ps(_mm_cmpge_ps(a.high, b.high)) << 4);
}

/* Four lanes of a or b; lane: the bit of each. */
LANES_FUNCTION __m128 lanes_half_where(unsigned bits, __m128i lane, __m128 a, __m128 b)
{
	const __m128i set = _mm_and_si128(_mm_set1_epi32((int)bits), lane);
	const __m128 from_a = _mm_castsi128_ps(_mm_cmpeq_epi32(set, lane));

	return _mm_or_ps(_mm_and_ps(from_a, a), _mm_andnot_ps(from_a, b));
}

LANES_FUNCTION lanes lanes_where(unsigned bits, lanes a, lanes b)
{
	return (lanes){lanes_half_where(bits, _mm_setr_epi32(1, 2, 4, 8), a.low, b.low),
		       lanes_half_where(bits, _mm_setr_epi32(16, 32, 64, 128), a.high, b.high)};
}

LANES_FUNCTION float lanes_first(lanes a) { return _mm_cvtss_f32(a.low); }

LANES_FUNCTION void lanes_store(float *to, lanes a)
{
	_mm_storeu_ps(to, a.low);
	_mm_storeu_ps(to + 4, a.high);
}

LANES_FUNCTION lanes lanes_abs(lanes a)
{
	__m128 sign = _mm_set1_ps(-0.0f);

	return (lanes){_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
}

#else

#include <math.h>

#define LANES_TARGET
#define LANES_FUNCTION static inline

/* The scalar version, for the other processors and for the tests. */
typedef struct lanes {
	float v[LANES];
} lanes;

#define LANES_EACH(expression) \
	lanes out; \
	for (int i = 0; i < LANES; i++) \
		out.v[i] = (expression); \
	return out

LANES_FUNCTION lanes lanes_load(const float *from) { LANES_EACH(from[i]); }
LANES_FUNCTION lanes lanes_all(float value) { LANES_EACH(value); }
LANES_FUNCTION lanes lanes_add(lanes a, lanes b) { LANES_EACH(a.v[i] + b.v[i]); }
LANES_FUNCTION lanes lanes_sub(lanes a, lanes b) { LANES_EACH(a.v[i] - b.v[i]); }
LANES_FUNCTION lanes lanes_mul(lanes a, lanes b) { LANES_EACH(a.v[i] * b.v[i]); }
LANES_FUNCTION lanes lanes_min(lanes a, lanes b) { LANES_EACH(a.v[i] < b.v[i] ? a.v[i] : b.v[i]); }
LANES_FUNCTION lanes lanes_max(lanes a, lanes b) { LANES_EACH(a.v[i] > b.v[i] ? a.v[i] : b.v[i]); }
LANES_FUNCTION lanes lanes_abs(lanes a) { LANES_EACH(fabsf(a.v[i])); }
LANES_FUNCTION lanes lanes_sqrt(lanes a) { LANES_EACH(sqrtf(a.v[i])); }
LANES_FUNCTION lanes lanes_swap_halves(lanes a) { LANES_EACH(a.v[i ^ 4]); }
LANES_FUNCTION lanes lanes_swap_quarters(lanes a) { LANES_EACH(a.v[i ^ 2]); }
LANES_FUNCTION lanes lanes_swap_neighbours(lanes a) { LANES_EACH(a.v[i ^ 1]); }
LANES_FUNCTION lanes lanes_where(unsigned bits, lanes a, lanes b) { LANES_EACH(bits >> i & 1 ? a.v[i] : b.v[i]); }
LANES_FUNCTION float lanes_first(lanes a) { return a.v[0]; }

LANES_FUNCTION bool lanes_above(lanes a, lanes b)
{
	for (int i = 0; i < LANES; i++)
		if (!(a.v[i] > b.v[i]))
			return false;
	return true;
}

LANES_FUNCTION unsigned lanes_reaching(lanes a, lanes b)
{
	unsigned reaching = 0;

	for (int i = 0; i < LANES; i++)
		reaching |= a.v[i] >= b.v[i] ? 1u << i : 0;
	return reaching;
}

LANES_FUNCTION void lanes_store(float *to, lanes a)
{
	for (int i = 0; i < LANES; i++)
		to[i] = a.v[i];
}

#endif

/* The greatest lane, in every lane. */
LANES_FUNCTION lanes lanes_greatest(lanes a)
{
	a = lanes_max(a, lanes_swap_halves(a));
	a = lanes_max(a, lanes_swap_quarters(a));
	return lanes_max(a, lanes_swap_neighbours(a));
}

#endif
