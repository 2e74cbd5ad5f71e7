/*
 * ablation.h - parts of the proof that only save time. Each can be left out of a build (make
 * CPPFLAGS=-DFIVECHECK_WITHOUT_...) so that the benchmark can measure its gain. Verdicts stay sound without them.
 */
#ifndef FIVECHECK_BASE_ABLATION_H
#define FIVECHECK_BASE_ABLATION_H

#ifdef FIVECHECK_WITHOUT_BUDGET
enum { WITH_BUDGET = 0 };
#else
enum { WITH_BUDGET = 1 };	/* a proven distance covers later steps */
#endif

#ifdef FIVECHECK_WITHOUT_KEPT_BUDGETS
enum { WITH_KEPT_BUDGETS = 0 };
#else
enum { WITH_KEPT_BUDGETS = 1 };	/* and is kept in case the axes return */
#endif

#ifdef FIVECHECK_WITHOUT_CHUNKS
enum { WITH_CHUNKS = 0 };
#else
enum { WITH_CHUNKS = 1 };	/* many steps are passed at once by the box of their positions */
#endif

#ifdef FIVECHECK_WITHOUT_MERGED_STEPS
enum { WITH_MERGED_STEPS = 0 };
#else
enum { WITH_MERGED_STEPS = 1 };	/* several steps are swept at once */
#endif

#ifdef FIVECHECK_WITHOUT_PLANES
enum { WITH_PLANES = 0 };
#else
enum { WITH_PLANES = 1 };	/* planes that travel with a link keep parts of the bodies apart */
#endif

#ifdef FIVECHECK_WITHOUT_PROFILES
enum { WITH_PROFILES = 0 };
#else
enum { WITH_PROFILES = 1 };	/* also of bodies of revolution that a turning body sweeps */
#endif

#ifdef FIVECHECK_WITHOUT_SIMD
enum { WITH_SIMD = 0 };
#else
enum { WITH_SIMD = 1 };	/* boxes are tested eight at a time */
#endif

#ifdef FIVECHECK_WITHOUT_CACHED_AXES
enum { WITH_CACHED_AXES = 0 };
#else
enum { WITH_CACHED_AXES = 1 };	/* the axes that separated last are tried first */
#endif

#ifdef FIVECHECK_WITHOUT_SUPPORTS
enum { WITH_SUPPORTS = 0 };
#else
enum { WITH_SUPPORTS = 1 };	/* and prove whole branches apart by their support functions */
#endif

#ifdef FIVECHECK_WITHOUT_INTERPOLATED_AXES
enum { WITH_INTERPOLATED_AXES = 0 };
#else
enum { WITH_INTERPOLATED_AXES = 1 };	/* an axis may turn along with the motion */
#endif

#ifdef FIVECHECK_WITHOUT_SECOND_ORDER
enum { WITH_SECOND_ORDER = 0 };
#else
/* The distance of a path from its chord is bounded by its curvature, not by half its length. */
enum { WITH_SECOND_ORDER = 1 };
#endif

#endif
