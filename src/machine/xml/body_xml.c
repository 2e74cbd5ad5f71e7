#include "machine/xml/body_xml.h"

#include <string.h>

#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

const char *body_xml_path(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *file = xml_name(xml, node, name, arena), *slash = strrchr(xml->path, '/');
	size_t folder = slash ? (size_t)(slash - xml->path) + 1 : 0;
	char *path;

	if (!file || file[0] == '/' || !folder)
		return file;
	path = arena_alloc(arena, folder + strlen(file) + 1);
	memcpy(path, xml->path, folder);
	strcpy(path + folder, file);
	return path;
}

const char *body_xml_mesh(struct xml_reader *xml, const xmlNode *node, struct arena *arena)
{
	return body_xml_path(xml, node, "mesh", arena);
}

void body_xml_read(struct xml_reader *xml, const xmlNode *node, struct arena *arena, struct body_description *body)
{
	xml_require(xml, node, "name", "mesh", NULL);
	body->at = node;
	body->name = xml_name(xml, node, "name", arena);
	body->checked = xml_name(xml, node, "checked", arena);
	body->frame = xml_frame(xml, node);
	body->mesh_path = body_xml_mesh(xml, node, arena);
	body->scale = xml_mesh_units(xml, node, xml->unit);
	xml_read_nothing(xml, node);
}
