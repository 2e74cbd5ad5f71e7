/* sampler.h - the paper's two methods: they check poses at regular times, and not the motion between them. */
#ifndef FIVECHECK_CHECK_SAMPLED_SAMPLER_H
#define FIVECHECK_CHECK_SAMPLED_SAMPLER_H

#include <stdbool.h>
#include <stddef.h>

#include "motion/motion.h"
#include "scene/motion_interval.h"
#include "scene/sweep.h"

struct axis_cache;

/*
 * Chen, Lin and Chang, "Efficient Web-Learning Collision Detection Tool on Five-Axis Machine". At every sample the
 * triangles are tested with separating axes: those of the sample's pose (conventional), or those at the two ends of a
 * motion, interpolated linearly (interpolated). Here the boxes of the trees exclude distant triangles first. That also
 * avoids some of the false alarms of interpolated axes.
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

/*
 * Tests the samples in the step; the step's start is a sample only in the first step. True: *contact is the first
 * sample that meets.
 */
bool sampler_step(struct sampler *sampler, struct sweep *sweep, const struct motion_step *step,
		  struct contact *contact);

#endif
