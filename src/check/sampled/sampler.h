/* sampler.h - the paper's two methods: looking at poses every so often, and not at what happens in between. */
#ifndef FIVECHECK_CHECK_SAMPLED_SAMPLER_H
#define FIVECHECK_CHECK_SAMPLED_SAMPLER_H

#include <stdbool.h>
#include <stddef.h>

#include "motion/motion.h"
#include "scene/motion_interval.h"
#include "scene/sweep.h"

struct axis_cache;

/*
 * Chen, Lin and Chang, "Efficient Web-Learning Collision Detection Tool on
 * Five-Axis Machine": at every sampling step the triangles are tested by the
 * separating axes of their pose (conventional), or by the axes of a motion's two
 * ends, interpolated linearly (interpolated). The trees' boxes spare the
 * triangle tests of what is plainly apart, and with them some of the false alarms
 * that interpolated axes raise.
 */
struct sampler {
	struct body_pair bodies;
	double clearance;	/* mm: triangles within it count as meeting */
	bool interpolated;
	double step;	/* s */
	bool started;
	struct axis_cache *cache;
	long samples;
};

void sampler_init(struct sampler *sampler, const struct body_pair *bodies, double clearance, bool interpolated,
		  double step);
void sampler_release(struct sampler *sampler);

/* Looks at the samples in the step (its start only if it is the first); true: *contact is the first that meets. */
bool sampler_step(struct sampler *sampler, struct sweep *sweep, const struct motion_step *step,
		  struct contact *contact);

#endif
