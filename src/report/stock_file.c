#include "report/stock_file.h"

#include <math.h>

#include "base/units.h"
#include "geom/stl_bytes.h"
#include "report/output.h"

static const struct srcloc nowhere;

/* False: reported. An older file would be taken for the stock of this program if its absence were no error. */
static bool fits_file(const char *path, const struct mesh *mesh, struct diag *diag)
{
	if (!mesh->count)
		diag_error(diag, nowhere, "nothing remains of the stock, so there is no mesh for %s", path);
	else if (mesh->count > UINT32_MAX)
		diag_error(diag, nowhere, "the remaining stock has too many triangles for an STL file");
	return mesh->count && mesh->count <= UINT32_MAX;
}

bool stock_file_write(const char *path, const struct stock_remainder *remainder, struct diag *diag)
{
	const struct mesh *mesh = &remainder->mesh;
	/* Rounded up: with a smaller excess, findings of the next setup would wrongly count as certain. */
	const double excess = ceil(100 * remainder->excess) / 100, inches = ceil(1000 * excess / MM_PER_INCH) / 1000;
	unsigned char head[STL_HEAD_BYTES], bytes[STL_TRIANGLE_BYTES];
	struct output out;

	if (!remainder->known) {
		diag_note(diag, nowhere,
			  "the program was not checked to its end, so %s was not written (--all goes on after a "
			  "finding)",
			  path);
		return true;
	}
	if (!fits_file(path, mesh, diag) || !output_open(&out, path, diag))
		return false;
	stl_bytes_head(head, "fivecheck stock, binary STL, mm", (uint32_t)mesh->count);
	output_write(&out, (const char *)head, sizeof(head));
	for (size_t i = 0; i < mesh->count; i++) {
		stl_bytes_triangle(bytes, &mesh->triangles[i]);
		output_write(&out, (const char *)bytes, sizeof(bytes));
	}
	if (!output_commit(&out, diag))
		return false;
	if (remainder->coarse)
		diag_note(diag, nowhere,
			  "many cuts overlap: cubes finer than %.3g mm would take too long, so the remaining "
			  "stock is drawn with these",
			  remainder->edge);
	diag_note(diag, nowhere,
		  "%s contains all remaining stock; material deeper than %.2f mm below its surface certainly remains: "
		  "<stock mesh=\"%s\" units=\"mm\" excess=\"%.2f\"/>; in a setup in inches excess=\"%.3f\"",
		  path, excess, path, excess, inches);
	return true;
}
