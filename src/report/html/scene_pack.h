/*
 * scene_pack.h - machine, setup and bodies as stored in a report: made once, used by the reports of all programs of a
 * run.
 */
#ifndef FIVECHECK_REPORT_HTML_SCENE_PACK_H
#define FIVECHECK_REPORT_HTML_SCENE_PACK_H

#include <jansson.h>
#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "report/html/pack_mesh.h"
#include "scene/scene.h"

struct scene_pack {
	json_t *machine, *bodies, *tools, *offsets, *pairs;	/* values of the report's JSON; owned */
	struct strbuf meshes;	/* HTML: the blobs of the meshes */
	int blobs;	/* how many */
	double accuracy;	/* mm */
	size_t left_out;	/* bodies whose meshes would have needed too many bytes */
};

/*
 * Packs the meshes of all bodies but the stock, which each program changes (stock_pack.h). If they need more than
 * `most` bytes, those of the largest bodies are left out.
 */
void scene_pack_init(struct scene_pack *pack, struct scene *scene, size_t most);
void scene_pack_release(struct scene_pack *pack);

/* The value of a body's "mesh" for the blob with this number; and the accuracy of its drawing, in mm. */
json_t *scene_pack_mesh(const struct packed_mesh *mesh, int blob);
double scene_pack_accuracy(const struct packed_mesh *mesh);

#endif
