#include "machine/xml/foreign_xml.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"

static const char space[] = " \t\r\n";

bool foreign_is(const xmlNode *node, const char *name)
{
	return node->type == XML_ELEMENT_NODE && (!name || !strcmp((const char *)node->name, name));
}

static const xmlNode *first_from(const xmlNode *node, const char *name)
{
	while (node && !foreign_is(node, name))
		node = node->next;
	return node;
}

const xmlNode *foreign_child(const xmlNode *parent, const char *name)
{
	return parent ? first_from(parent->children, name) : NULL;
}

const xmlNode *foreign_next(const xmlNode *node, const char *name)
{
	return first_from(node->next, name);
}

const char *foreign_attribute(const xmlNode *node, const char *name)
{
	const xmlAttr *attribute = xmlHasProp(node, (const xmlChar *)name);

	if (!attribute)
		return NULL;
	if (!attribute->children || !attribute->children->content)
		return "";
	return (const char *)attribute->children->content;
}

bool foreign_attribute_is(const xmlNode *node, const char *name, const char *value)
{
	const char *text = foreign_attribute(node, name);

	return text && ascii_same(text, value);
}

/* The text of an element that contains only text; in a file without entities it is one node. */
static const char *raw_text(const xmlNode *node)
{
	const xmlNode *text = node ? node->children : NULL;

	return text && text->type == XML_TEXT_NODE && text->content ? (const char *)text->content : "";
}

static size_t trimmed_length(const char *text)
{
	size_t length = strlen(text);

	while (length && strchr(space, text[length - 1]))
		length--;
	return length;
}

const char *foreign_text(struct arena *arena, const xmlNode *node)
{
	const char *text = raw_text(node);
	size_t length;
	char *copy;

	text += strspn(text, space);
	length = trimmed_length(text);
	copy = arena_alloc(arena, length + 1);
	memcpy(copy, text, length);
	return copy;
}

bool foreign_number(struct xml_reader *xml, const xmlNode *node, const char *attribute, double *value)
{
	const char *text = attribute ? foreign_attribute(node, attribute) : raw_text(node);
	double number;
	size_t length;

	if (!text) {
		xml_error(xml, node, NULL, "<%s> needs the attribute '%s'", (const char *)node->name, attribute);
		return false;
	}
	text += strspn(text, space);
	length = trimmed_length(text);
	if (length && decimal_read(text, length, &number) && isfinite(number)) {
		*value = number;
		return true;
	}
	xml_error(xml, node, attribute, "%s of <%s> must be a number, not '%s'", attribute ? attribute : "the text",
		  (const char *)node->name, xml_quote(text).text);
	return false;
}

bool foreign_vector(struct xml_reader *xml, const xmlNode *node, const char *x, const char *y, const char *z,
		    vec3 *value)
{
	vec3 v;
	bool good = foreign_number(xml, node, x, &v.x);

	good = foreign_number(xml, node, y, &v.y) && good;
	good = foreign_number(xml, node, z, &v.z) && good;
	if (good)
		*value = v;
	return good;
}
