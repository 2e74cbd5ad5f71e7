/* FCL: https://github.com/flexible-collision-library/fcl, 0.7. Everything in doubles, trees of OBBRSS. */
#include "fcl_answer.h"

#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

struct fcl_body {
	fcl::BVHModel<fcl::OBBRSS<double>> model;
};

static fcl::Transform3<double> transform_of(const double *pose)
{
	fcl::Transform3<double> transform = fcl::Transform3<double>::Identity();

	for (int i = 0; pose && i < 3; i++) {
		for (int j = 0; j < 3; j++)
			transform.matrix()(i, j) = pose[3 * i + j];
		transform.translation()[i] = pose[9 + i];
	}
	return transform;
}

const char *fcl_version(void)
{
	return FCL_VERSION;
}

struct fcl_body *fcl_body_new(const double *corners, size_t count)
{
	auto *body = new fcl_body;

	body->model.beginModel((int)count, (int)(3 * count));
	for (const double *c = corners; c < corners + 9 * count; c += 9)
		body->model.addTriangle({c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]});
	body->model.endModel();
	return body;
}

void fcl_body_free(struct fcl_body *body)
{
	delete body;
}

bool fcl_bodies_meet(const struct fcl_body *a, const struct fcl_body *b, const double *pose)
{
	fcl::CollisionRequest<double> request{1, false};
	fcl::CollisionResult<double> result;

	return fcl::collide(&a->model, transform_of(nullptr), &b->model, transform_of(pose), request, result) > 0;
}

double fcl_bodies_distance(const struct fcl_body *a, const struct fcl_body *b, const double *pose)
{
	fcl::DistanceRequest<double> request;
	fcl::DistanceResult<double> result;

	return fcl::distance(&a->model, transform_of(nullptr), &b->model, transform_of(pose), request, result);
}

double fcl_bodies_advance(const struct fcl_body *a, const struct fcl_body *b, const double *from, const double *to)
{
	fcl::ContinuousCollisionRequest<double> request(1000, 1e-6, fcl::CCDM_LINEAR, fcl::GST_LIBCCD,
							fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
	fcl::ContinuousCollisionResult<double> result;

	fcl::continuousCollide(&a->model, transform_of(nullptr), transform_of(nullptr), &b->model, transform_of(from),
			       transform_of(to), request, result);
	return result.is_collide ? result.time_of_contact : -1;
}
