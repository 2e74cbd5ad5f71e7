#include "machine/xml/xml_element.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

#include "base/spelling.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_file.h"

/* The deepest permitted nesting: more than any chain of nine axes needs. */
#define DEPTH_MAX 64
/* The largest permitted number of children of an element. Lists are searched for duplicates, so they are limited. */
#define CHILDREN_MAX 20000

static bool is_named(const xmlNode *node, const char *name)
{
	return node->type == XML_ELEMENT_NODE && strcmp((const char *)node->name, name) == 0;
}

size_t xml_count(const xmlNode *parent, const char *name)
{
	size_t count = 0;

	for (const xmlNode *node = parent->children; node; node = node->next)
		if (node->type == XML_ELEMENT_NODE)
			count += is_named(node, name) + xml_count(node, name);
	return count;
}

const xmlNode *xml_root(const struct xml_reader *xml)
{
	return xmlDocGetRootElement(xml->doc);
}

/* ---------------------------------------------------------------- children */

static const struct xml_child *find_child(const struct xml_child *children, const char *name)
{
	for (; children->name; children++)
		if (strcmp(children->name, name) == 0)
			return children;
	return NULL;
}

static bool belongs_elsewhere(const struct xml_reader *xml, const char *name)
{
	for (const char *const *at = xml->elements; *at; at++)
		if (strcmp(*at, name) == 0)
			return true;
	return false;
}

static void report_unknown(struct xml_reader *xml, const xmlNode *node, const struct xml_child *children)
{
	const char *name = (const char *)node->name, *parent = (const char *)node->parent->name;
	struct spelling meant;

	if (node->ns) {
		xml_error(xml, node, NULL, "element <%s> is in a namespace; fivecheck files use none",
			  xml_quote(name).text);
		return;
	}
	if (belongs_elsewhere(xml, name)) {
		xml_error(xml, node, NULL, "element <%s> is not allowed in <%s>", name, parent);
		return;
	}
	spelling_init(&meant, name);
	for (; children->name; children++)
		spelling_offer(&meant, children->name);
	if (meant.best)
		xml_error(xml, node, NULL, "unknown element <%s> in <%s>; did you mean <%s>?", xml_quote(name).text,
			  parent, meant.best);
	else
		xml_error(xml, node, NULL, "unknown element <%s> in <%s>", xml_quote(name).text, parent);
}

/* Is the node neither an element nor a comment, such as text between elements? */
static bool is_stray(const xmlNode *node)
{
	switch (node->type) {
	case XML_COMMENT_NODE:
	case XML_PI_NODE:
		return false;
	case XML_TEXT_NODE:
		return !xmlIsBlankNode(node);
	default:
		return true;
	}
}

void xml_read_children(struct xml_reader *xml, const xmlNode *node, const struct xml_child *children, void *context)
{
	size_t seen[XML_CHILDREN_MAX] = {0};
	bool stray = false;

	if (node->nsDef)
		xml_error(xml, node, "xmlns", "<%s> declares a namespace; fivecheck files use none",
			  (const char *)node->name);
	xml_attributes_end(xml, node);
	for (const xmlNode *at = node->children; at && !xml_is_full(xml); at = at->next) {
		const struct xml_child *child = NULL;

		if (at->type != XML_ELEMENT_NODE) {
			stray |= is_stray(at);
			continue;
		}
		if (!at->ns)
			child = find_child(children, (const char *)at->name);
		if (!child) {
			report_unknown(xml, at, children);
			continue;
		}
		assert(child - children < XML_CHILDREN_MAX);
		if (seen[child - children]++ && child->once)
			xml_error(xml, at, NULL, "<%s> has a second <%s>", (const char *)node->name, child->name);
		else
			child->read(xml, at, context);
	}
	if (stray)
		xml_error(xml, node, NULL,
			  "<%s> contains text; only elements are allowed here", (const char *)node->name);
	for (const struct xml_child *child = children; child->name; child++)
		if (child->required && !seen[child - children])
			xml_error(xml, node, NULL, "<%s> needs <%s>", (const char *)node->name, child->name);
}

void xml_read_nothing(struct xml_reader *xml, const xmlNode *node)
{
	static const struct xml_child none[] = {{.name = NULL}};

	xml_read_children(xml, node, none, NULL);
}

/* ------------------------------------------------------------------- files */

/* Numbers the elements in the order of their tags. */
static size_t number_elements(xmlNode *node, size_t number)
{
	/* Only a number must be stored. NOLINTNEXTLINE(performance-no-int-to-ptr) */
	node->_private = (void *)(uintptr_t)++number;
	for (xmlNode *child = node->children; child; child = child->next)
		if (child->type == XML_ELEMENT_NODE)
			number = number_elements(child, number);
	return number;
}

/* False, reported: an element is nested too deep, has too many children, or has an attribute that is not plain text. */
static bool check_shape(struct xml_reader *xml, const xmlNode *node, int depth)
{
	size_t count = 0;

	if (depth > DEPTH_MAX) {
		xml_error(xml, node, NULL, "elements are nested deeper than %d levels", DEPTH_MAX);
		return false;
	}
	for (const xmlAttr *attribute = node->properties; attribute; attribute = attribute->next) {
		const xmlNode *value = attribute->children;

		if (value && (value->type != XML_TEXT_NODE || value->next)) {
			xml_error(xml, node, NULL, "attribute '%s' of <%s> refers to an entity",
				  xml_quote((const char *)attribute->name).text,
				  xml_quote((const char *)node->name).text);
			return false;
		}
	}
	for (const xmlNode *child = node->children; child; child = child->next) {
		if (child->type != XML_ELEMENT_NODE)
			continue;
		if (++count > CHILDREN_MAX) {
			xml_error(xml, node, NULL, "<%s> has more than %d elements",
				  xml_quote((const char *)node->name).text, CHILDREN_MAX);
			return false;
		}
		if (!check_shape(xml, child, depth + 1))
			return false;
	}
	return true;
}

/* A file of another kind or of a later version gets one clear message. */
static bool check_root(struct xml_reader *xml, const char *root, bool own)
{
	const xmlNode *node = xml_root(xml);
	const char *version;

	if (!is_named(node, root)) {
		if (is_named(node, "setup") || is_named(node, "waivers"))
			xml_error(xml, node, NULL,
				  "this is a %s file, but a %s file is needed here: give it with --%s",
				  (const char *)node->name, root, (const char *)node->name);
		else if (is_named(node, "machine"))
			xml_error(xml, node, NULL, "this is a machine file, but a %s file is needed here", root);
		else
			xml_error(xml, node, NULL,
				  "the root element is <%s>, but a %s file starts with <%s version=\"1\">",
				  xml_quote((const char *)node->name).text, root, root);
		return false;
	}
	version = own ? xml_attribute(xml, node, "version") : NULL;
	if (version && strcmp(version, "1") != 0) {
		xml_error(xml, node, "version",
			  "version \"%s\" of the %s file is not supported; fivecheck reads version 1",
			  xml_quote(version).text, root);
		return false;
	}
	return true;
}

/* The reader is set up, except for the contents of the file or text. */
static bool open_reader(struct xml_reader *xml)
{
	if (xml_file_parse(xml)) {
		/* The numbers of tags and elements must be equal; otherwise the places are not reliable. */
		if (number_elements(xmlDocGetRootElement(xml->doc), 0) != xml->tag_count)
			xml->tag_count = 0;
		if (check_shape(xml, xml_root(xml), 1) && check_root(xml, xml->elements[0], !xml->foreign))
			return true;
	}
	xml_close(xml);
	return false;
}

void xml_close(struct xml_reader *xml)
{
	xml_reader_release(xml);
}

bool xml_open(struct xml_reader *xml, const char *path, const char *const *elements, struct diag *diag)
{
	*xml = (struct xml_reader){.path = path, .diag = diag, .unit = 1, .elements = elements};
	return open_reader(xml);
}

bool xml_open_text(struct xml_reader *xml, const char *text, const char *const *elements, struct diag *diag)
{
	*xml = (struct xml_reader){.path = "", .text = text, .diag = diag, .unit = 1, .elements = elements};
	return open_reader(xml);
}

bool xml_open_foreign(struct xml_reader *xml, const char *path, const char *const *elements, struct diag *diag)
{
	*xml = (struct xml_reader){.path = path, .diag = diag, .unit = 1, .foreign = true, .elements = elements};
	return open_reader(xml);
}
