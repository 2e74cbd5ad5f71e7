/* Any bytes as an STL file: a mesh of finite coordinates, or a message. */
#include <math.h>

#include "fuzz.h"
#include "geom/bvh.h"
#include "geom/stl.h"
#include "geom/topology.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct diag diag = {.handle = fuzz_note};
	const char *path = fuzz_file(data, size);
	struct mesh mesh = {0};
	struct topology topology;
	struct bvh *bvh;

	if (!stl_read(&mesh, path, &diag)) {
		if (!diag.errors || mesh.count)
			abort();
	} else {
		if (!mesh.count || diag.errors)
			abort();
		for (size_t i = 0; i < 9 * mesh.count; i++)
			if (!isfinite(mesh.triangles[i / 9].v[i / 3 % 3][i % 3]))
				abort();
		bvh = bvh_new(&mesh);
		topology_init(&topology, &bvh->mesh);
		topology_release(&topology);
		bvh_free(bvh);
	}
	unlink(path);
	return 0;
}
