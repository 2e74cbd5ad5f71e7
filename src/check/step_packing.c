#include "check/step_packing.h"

#include <stdint.h>
#include <string.h>

/* Which of the axis values that follow a packed step are left out. */
enum {
	STARTS_AT_LAST = 1,	/* q0: the step begins where the last one ended */
	CHORD_ERROR_ZERO = 2,
	TOLERANCE_AS_LAST = 4,
	PATH_PLAIN = 8	/* straight, from q0 to q1, and the span is the whole of it */
};

/* Followed by q1, and by q0, the chord error and the tolerance where they are not left out. */
struct packed_step {
	unsigned left_out;
	int move, tool;
	enum step_class step_class;
	bool outside, bounded;
	const char *file;
	long line;
	double time, block_time, seconds;
	const struct path *path;	/* NULL if plain */
	double path_seconds;	/* of a plain path */
	double u0, u1;
};

enum { VALUES_MOST = 4 };

size_t step_packing_most(void)
{
	return sizeof(struct packed_step) + VALUES_MOST * sizeof(axis_values);
}

/* By their bits: 0 and -0 differ. */
static inline bool are_same(const axis_values *a, const axis_values *b)
{
	uint64_t p[SLOT_COUNT], q[SLOT_COUNT], differing = 0;

	memcpy(p, a, sizeof(p));
	memcpy(q, b, sizeof(q));
	for (int i = 0; i < SLOT_COUNT; i++)
		differing |= p[i] ^ q[i];
	return !differing;
}

static bool is_plain(const struct span *span)
{
	const struct path *path = span->path;

	return path->kind == PATH_STRAIGHT && !path->circular && !path->tcp && !(span->u0 > 0) && !(span->u1 < 1) &&
	       are_same(&path->start, &span->q0) && are_same(&path->end, &span->q1);
}

static unsigned left_out_of(const struct motion_step *last, const struct motion_step *step)
{
	static const axis_values zero;
	const struct span *span = &step->span;

	return (are_same(&span->q0, &last->span.q1) ? STARTS_AT_LAST : 0U) |
	       (are_same(&span->chord_error, &zero) ? CHORD_ERROR_ZERO : 0U) |
	       (are_same(&step->tolerance, &last->tolerance) ? TOLERANCE_AS_LAST : 0U) |
	       (is_plain(span) ? PATH_PLAIN : 0U);
}

size_t step_packing_pack(struct step_packing *packing, const struct motion_step *step, struct path_copies *paths,
			 void *out)
{
	struct packed_step *packed = out;
	axis_values *values = (void *)(packed + 1);
	const unsigned left_out = left_out_of(&packing->last, step);

	*packed = (struct packed_step){
		.left_out = left_out, .move = step->move, .tool = step->tool, .step_class = step->step_class,
		.outside = step->outside, .bounded = step->bounded, .file = step->file, .line = step->line,
		.time = step->time, .block_time = step->block_time, .seconds = step->seconds,
		.path = left_out & PATH_PLAIN ? NULL : path_copies_add(paths, &step->span),
		.path_seconds = step->span.path->seconds, .u0 = step->span.u0, .u1 = step->span.u1};
	*values++ = step->span.q1;
	if (!(left_out & STARTS_AT_LAST))
		*values++ = step->span.q0;
	if (!(left_out & CHORD_ERROR_ZERO))
		*values++ = step->span.chord_error;
	if (!(left_out & TOLERANCE_AS_LAST))
		*values++ = packing->last.tolerance = step->tolerance;
	packing->last.span.q1 = step->span.q1;
	return (size_t)((char *)values - (char *)out);
}

size_t step_packing_unpack(struct step_packing *packing, const void *in, struct motion_step *step)
{
	const struct packed_step *packed = in;
	const axis_values *values = (const void *)(packed + 1), exact = {{0}};
	const unsigned left_out = packed->left_out;
	struct motion_step *last = &packing->last;

	step->file = packed->file;
	step->line = packed->line;
	step->move = packed->move;
	step->tool = packed->tool;
	step->time = packed->time;
	step->block_time = packed->block_time;
	step->seconds = packed->seconds;
	step->outside = packed->outside;
	step->bounded = packed->bounded;
	step->step_class = packed->step_class;
	step->span.path = packed->path;
	step->span.u0 = packed->u0;
	step->span.u1 = packed->u1;
	step->span.q1 = *values++;
	step->span.q0 = left_out & STARTS_AT_LAST ? last->span.q1 : *values++;
	step->span.chord_error = left_out & CHORD_ERROR_ZERO ? exact : *values++;
	if (!(left_out & TOLERANCE_AS_LAST))
		last->tolerance = *values++;
	step->tolerance = last->tolerance;
	last->span.q1 = step->span.q1;
	if (left_out & PATH_PLAIN) {
		packing->plain.start = step->span.q0;
		packing->plain.end = step->span.q1;
		packing->plain.seconds = packed->path_seconds;
		step->span.path = &packing->plain;
	}
	return (size_t)((const char *)values - (const char *)in);
}
