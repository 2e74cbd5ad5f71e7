#include "machine/xml/body_xml.h"

#include <string.h>

bool body_name_is_reserved(const char *name)
{
	static const char *const words[] = {"base", "holder", "shank", "cutter", "fixture", "part"};

	if (name[0] && !name[1] && slot_of_letter(name[0]) >= 0)
		return true;
	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++)
		if (strcmp(name, words[i]) == 0)
			return true;
	return false;
}

/* A mesh path is relative to the folder of the file that names it. */
static const char *resolve(const char *file, const char *mesh, struct arena *arena)
{
	const char *slash = strrchr(file, '/');
	size_t folder = slash ? (size_t)(slash - file) + 1 : 0, length = strlen(mesh);
	char *path;

	if (mesh[0] == '/')
		folder = 0;
	path = arena_alloc(arena, folder + length + 1);
	memcpy(path, file, folder);
	memcpy(path + folder, mesh, length + 1);
	return path;
}

bool body_read_mesh(struct xml_reader *xml, const xmlNode *node, struct arena *arena, struct body *body)
{
	const char *mesh = xml_name(xml, node, "mesh", arena);

	if (!mesh)
		return false;
	body->mesh_path = resolve(xml->path, mesh, arena);
	body->scale = xml_units(node, xml->unit);
	return true;
}

bool body_read(struct xml_reader *xml, const xmlNode *node, struct arena *arena, const xform *mount, struct body *body)
{
	const char *name = xml_name(xml, node, "name", arena);
	xform frame = xml_frame(xml, node);

	if (!body_read_mesh(xml, node, arena, body) || !name)
		return false;
	if (body_name_is_reserved(name)) {
		xml_error(xml, node, "a body cannot be named '%s': in a <pair> that word means something else", name);
		return false;
	}
	body->name = name;
	body->placement = xform_mul(mount, &frame);
	return true;
}

void body_check_name(struct xml_reader *xml, const xmlNode *node, const char *name, const struct body *bodies,
		     size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (strcmp(bodies[i].name, name) == 0) {
			xml_error(xml, node, "the name '%s' is taken: another body has it (%s:%ld)", name,
				  bodies[i].loc.file, bodies[i].loc.line);
			return;
		}
	}
}
