/*
 * peer_ode.cpp - ODE as a peer: its trees of boxes over meshes (OPCODE), `dCollide`, one contact, the boxes around the
 * bodies first. It has no distances: `skip` is refused. What it is called with and prints: peer_fcl.cpp.
 * ODE: https://www.ode.org, 0.16, ode/collision.h and collision_trimesh.h.
 */
#include <vector>

#include <ode/ode.h>

#include "peer_run.h"

class Ode : public Peer {
public:
	explicit Ode(const scene *world)
	{
		dInitODE2(0);
		dAllocateODEDataForThread(dAllocateMaskAll);
		for (int i = 0; i < world->solid_count; i++)
			add(world->solids[i]);
	}

	bool meets(const solid_pair &pair, const pose &a, const pose &b) override
	{
		const dGeomID x = placed((size_t)pair.a, a), y = placed((size_t)pair.b, b);
		dContactGeom contact;

		return boxes_meet(x, y) && dCollide(x, y, CONTACTS_UNIMPORTANT | 1, &contact, sizeof(contact)) > 0;
	}

	double apart(const solid_pair &, const pose &, const pose &) override
	{
		die("ODE knows no distances", "skip");
		return 0;
	}

private:
	/* What the library borrows. */
	struct Arrays {
		std::vector<dReal> points;
		std::vector<dTriIndex> corners;
	};

	std::vector<Arrays *> arrays;
	std::vector<dGeomID> bodies;

	void add(const solid &solid)
	{
		Arrays *kept = new Arrays;
		dTriMeshDataID data = dGeomTriMeshDataCreate();

		for (size_t i = 0; i < solid.count; i++) {
			for (const vec &p : solid.triangles[i].p) {
				kept->corners.push_back((dTriIndex)kept->corners.size());
				kept->points.insert(kept->points.end(), {(dReal)p.x, (dReal)p.y, (dReal)p.z});
			}
		}
		dGeomTriMeshDataBuildDouble(data, kept->points.data(), 3 * sizeof(dReal), (int)kept->corners.size(),
					    kept->corners.data(), (int)kept->corners.size(), 3 * sizeof(dTriIndex));
		arrays.push_back(kept);
		bodies.push_back(dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr));
	}

	dGeomID placed(size_t i, const pose &p)
	{
		const dMatrix3 r = {p.r[0][0], p.r[0][1], p.r[0][2], 0, p.r[1][0], p.r[1][1],
				    p.r[1][2], 0, p.r[2][0], p.r[2][1], p.r[2][2], 0};

		dGeomSetRotation(bodies[i], r);
		dGeomSetPosition(bodies[i], p.t.x, p.t.y, p.t.z);
		return bodies[i];
	}

	static bool boxes_meet(dGeomID a, dGeomID b)
	{
		dReal x[6], y[6];

		dGeomGetAABB(a, x);
		dGeomGetAABB(b, y);
		for (int k = 0; k < 6; k += 2)
			if (x[k] > y[k + 1] || y[k] > x[k + 1])
				return false;
		return true;
	}
};

int main(int argc, char **argv)
{
	return peer_main<Ode>(argc, argv);
}
