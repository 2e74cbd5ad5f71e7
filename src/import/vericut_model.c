#include "import/vericut_model.h"

#include <string.h>

#include "base/ascii.h"
#include "base/units.h"
#include "import/mesh_build.h"
#include "import/mesh_file.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

double vericut_unit(struct xml_reader *xml, const xmlNode *node)
{
	const char *unit = foreign_attribute(node, "Unit");

	if (unit && ascii_same(unit, "millimeter"))
		return 1;
	if (unit && ascii_same(unit, "inch"))
		return MM_PER_INCH;
	xml_error(xml, node, unit ? "Unit" : NULL, "the Unit of <%s> must be millimeter or inch",
		  (const char *)node->name);
	return 0;
}

const char *vericut_stem(struct arena *arena, const char *path)
{
	const char *start = path;
	char *stem, *dot;

	for (const char *at = path; *at; at++)
		if (*at == '/' || *at == '\\')
			start = at + 1;
	stem = arena_strdup(arena, start);
	dot = strrchr(stem, '.');
	if (dot && dot != stem)
		*dot = '\0';
	return stem;
}

/* False: reported; or only a warning was given, then *left_out is set. */
static bool read_mesh(struct mesh *mesh, struct xml_reader *xml, const xmlNode *node, const char *written,
		      const struct import_options *options, bool *left_out)
{
	struct strbuf path = {0};
	const double unit = vericut_unit(xml, node);
	bool good = unit > 0;

	if (good && !mesh_file_find(&path, options->meshes, xml->path, written)) {
		*left_out = options->skip_missing;
		if (*left_out)
			diag_warning(xml->diag, (struct srcloc){.file = xml->path, .line = xml_line(xml, node)},
				     "'%s' is missing: the body is left out", xml_quote(written).text);
		else
			xml_error(
			    xml, node, NULL,
			    "'%s' is missing: put the file beside this one, name its folder with --meshes, or leave "
			    "the body out with --skip-missing",
			    xml_quote(written).text);
		good = false;
	}
	if (good)
		mesh_sources_add(options->sources, written, strbuf_text(&path),
				 (struct srcloc){.file = xml->path, .line = xml_line(xml, node)}, xml->diag);
	good = good && mesh_file_read(mesh, strbuf_text(&path), unit, xml->diag);
	strbuf_release(&path);
	return good;
}

static bool read_block(struct mesh *mesh, struct xml_reader *xml, const xmlNode *node)
{
	struct mesh_build build = {.scale = xml->unit};
	vec3 size;

	if (!foreign_vector(xml, node, "Length", "Width", "Height", &size))
		return false;
	if (!(size.x > 0 && size.y > 0 && size.z > 0) || !mesh_build_block(&build, size)) {
		xml_error(xml, node, NULL, "the dimensions of a block must be greater than 0 and below 5 km");
		return false;
	}
	mesh_build_finish(&build, mesh);
	return true;
}

static bool read_cylinder(struct mesh *mesh, struct xml_reader *xml, const xmlNode *node)
{
	struct mesh_build build = {.scale = 1};
	double radius, height;

	if (!foreign_number(xml, node, "Radius", &radius) || !foreign_number(xml, node, "Height", &height))
		return false;
	if (!(radius > 0 && height > 0) ||
	    !mesh_build_frustum(&build, xml->unit * radius, xml->unit * radius, xml->unit * height)) {
		xml_error(xml, node, NULL, "radius and height of a cylinder must be greater than 0 and below 5 km");
		return false;
	}
	mesh_build_finish(&build, mesh);
	return true;
}

bool vericut_model_read(struct vericut_model *model, struct xml_reader *xml, const xmlNode *node,
			const struct vericut_component *component, const struct import_options *options,
			struct arena *arena)
{
	struct vericut_model read = {.name = component->name};
	bool good;

	if (foreign_attribute(node, "Mirror") && !foreign_attribute_is(node, "Mirror", "off")) {
		xml_error(xml, node, "Mirror", "mirrored models cannot be converted: save the mirrored model as STL");
		return false;
	}
	if (!vericut_frame(xml, node, &read.frame))
		return false;
	read.frame = xform_mul(&component->frame, &read.frame);
	if (foreign_child(node, "File")) {
		const char *written = foreign_text(arena, foreign_child(node, "File"));

		read.name = vericut_stem(arena, written);
		good = read_mesh(&read.mesh, xml, node, written, options, &read.left_out);
	} else if (foreign_is(node, "Block")) {
		good = read_block(&read.mesh, xml, node);
	} else if (foreign_is(node, "Cylinder")) {
		good = read_cylinder(&read.mesh, xml, node);
	} else {
		xml_error(xml, node, NULL, "a model <%s> cannot be converted: save it as STL",
			  (const char *)node->name);
		good = false;
	}
	if (good || read.left_out)
		*model = read;
	return good || read.left_out;
}
