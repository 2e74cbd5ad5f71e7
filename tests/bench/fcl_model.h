/*
 * fcl_model.h - bodies and poses of plain_scene.h as FCL wants them.
 * FCL: https://github.com/flexible-collision-library/fcl, 0.7.
 */
#ifndef BENCH_FCL_MODEL_H
#define BENCH_FCL_MODEL_H

#include <memory>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>

#include "plain_scene.h"

/* With a tree of `Volume`, which is one of fcl/math/bv. */
template <class Volume> std::unique_ptr<fcl::BVHModel<Volume>> model_of(const solid &solid)
{
	std::vector<fcl::Vector3<double>> points;
	std::vector<fcl::Triangle> triangles;
	std::unique_ptr<fcl::BVHModel<Volume>> model(new fcl::BVHModel<Volume>);

	for (size_t i = 0; i < solid.count; i++) {
		for (const vec &p : solid.triangles[i].p)
			points.emplace_back(p.x, p.y, p.z);
		triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
	}
	model->beginModel((int)triangles.size(), (int)points.size());
	model->addSubModel(points, triangles);
	model->endModel();
	return model;
}

inline fcl::Transform3<double> transform_of(const pose &p)
{
	fcl::Transform3<double> t = fcl::Transform3<double>::Identity();

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			t.matrix()(i, j) = p.r[i][j];
	t.translation() = fcl::Vector3<double>(p.t.x, p.t.y, p.t.z);
	return t;
}

#endif
