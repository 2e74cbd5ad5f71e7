/*
 * peer_coal.cpp - Coal as a peer: OBBRSS trees, `collide`, one contact; its lower bound of the distance comes with
 * every answer. What it is called with and prints: peer_fcl.cpp.
 * Coal: https://github.com/coal-library/coal, 3.0, coal/collision.h and collision_data.h.
 */
#include <memory>
#include <vector>

#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>

#include "peer_run.h"

using Model = coal::BVHModel<coal::OBBRSS>;

class Coal : public Peer {
public:
	explicit Coal(const scene *world)
	{
		for (int i = 0; i < world->solid_count; i++)
			models.push_back(model_of(world->solids[i]));
	}

	bool meets(const solid_pair &pair, const pose &a, const pose &b) override
	{
		return look(pair, a, b).isCollision();
	}

	double apart(const solid_pair &pair, const pose &a, const pose &b) override
	{
		const coal::CollisionResult result = look(pair, a, b);

		return result.isCollision() ? 0 : result.distance_lower_bound;
	}

private:
	std::vector<std::unique_ptr<Model>> models;

	coal::CollisionResult look(const solid_pair &pair, const pose &a, const pose &b) const
	{
		const coal::CollisionRequest request(coal::NO_REQUEST, 1);
		coal::CollisionResult result;

		coal::collide(models[(size_t)pair.a].get(), transform_of(a), models[(size_t)pair.b].get(),
			      transform_of(b), request, result);
		return result;
	}

	static std::unique_ptr<Model> model_of(const solid &solid)
	{
		std::unique_ptr<Model> model(new Model);

		model->beginModel((unsigned)solid.count, (unsigned)(3 * solid.count));
		for (size_t i = 0; i < solid.count; i++)
			model->addTriangle(point_of(solid.triangles[i].p[0]), point_of(solid.triangles[i].p[1]),
					   point_of(solid.triangles[i].p[2]));
		model->endModel();
		return model;
	}

	static coal::Vec3s point_of(const vec &p)
	{
		return coal::Vec3s(p.x, p.y, p.z);
	}

	static coal::Transform3s transform_of(const pose &p)
	{
		coal::Matrix3s r;

		for (int i = 0; i < 3; i++)
			for (int j = 0; j < 3; j++)
				r(i, j) = p.r[i][j];
		return coal::Transform3s(r, point_of(p.t));
	}
};

int main(int argc, char **argv)
{
	return peer_main<Coal>(argc, argv);
}
