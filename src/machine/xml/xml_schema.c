#include "machine/xml/xml_schema.h"

#include <assert.h>
#include <libxml/parser.h>
#include <libxml/relaxng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/strbuf.h"
#include "base/spelling.h"
#include "machine/xml/xml_file.h"

static const char setup_schema[] =
#include "setup.rng.h"
	;
static const char machine_schema[] =
#include "machine.rng.h"
	;
static const char waivers_schema[] =
#include "waivers.rng.h"
	;

/* Deeper than any chain of nine axes needs. */
#define DEPTH_MAX 64
/* libxml2's validation takes time with the square of it; no list that a reader accepts is as long. */
#define CHILDREN_MAX 20000

/* What a pattern of the schema allows in one element. */
struct entry {
	const char *name;
	const xmlNode *pattern;	/* <element> or <attribute> of the schema */
	bool attribute;
	bool required;
	bool repeated;
};

#define ENTRIES_MAX 32

struct content {
	struct entry entries[ENTRIES_MAX];
	size_t count;
};

struct validation {
	struct xml_reader *xml;
	xmlDoc *schema;
};

/* The attribute of a schema element; "" if it has none. */
static const char *value_of(const xmlNode *node, const char *name)
{
	const char *value = xml_attribute(node, name);

	return value ? value : "";
}

static const xmlNode *find_define(const struct validation *v, const char *name)
{
	const xmlNode *node = xml_first(xmlDocGetRootElement(v->schema));

	while (node && !(xml_is(node, "define") && strcmp(value_of(node, "name"), name) == 0))
		node = xml_next(node);
	assert(node);
	return node;
}

static void collect(const struct validation *v, const xmlNode *pattern, bool required, bool repeated,
		    struct content *out)
{
	for (const xmlNode *node = xml_first(pattern); node; node = xml_next(node)) {
		if (xml_is(node, "attribute") || xml_is(node, "element")) {
			assert(out->count < ENTRIES_MAX);
			out->entries[out->count++] = (struct entry){.name = value_of(node, "name"),
								    .pattern = node,
								    .attribute = xml_is(node, "attribute"),
								    .required = required,
								    .repeated = repeated};
		} else if (xml_is(node, "ref")) {
			collect(v, find_define(v, value_of(node, "name")), required, repeated, out);
		} else {
			bool maybe = xml_is(node, "optional") || xml_is(node, "zeroOrMore") || xml_is(node, "choice");

			collect(v, node, required && !maybe, repeated || xml_is(node, "zeroOrMore"), out);
		}
	}
}

static const struct entry *find_entry(const struct content *content, bool attribute, const char *name)
{
	for (size_t i = 0; i < content->count; i++) {
		const struct entry *entry = &content->entries[i];

		if (entry->attribute == attribute && strcmp(entry->name, name) == 0)
			return entry;
	}
	return NULL;
}

static const char *find_nearest(const struct content *content, bool attribute, const char *name)
{
	struct spelling nearest;

	spelling_init(&nearest, name);
	for (size_t i = 0; i < content->count; i++)
		if (content->entries[i].attribute == attribute)
			spelling_offer(&nearest, content->entries[i].name);
	return nearest.best;
}

static bool schema_has_element(const xmlNode *pattern, const char *name)
{
	for (const xmlNode *node = xml_first(pattern); node; node = xml_next(node)) {
		if (xml_is(node, "element") && strcmp(value_of(node, "name"), name) == 0)
			return true;
		if (schema_has_element(node, name))
			return true;
	}
	return false;
}

static void unknown_element(struct validation *v, const xmlNode *node, const struct content *content)
{
	const char *name = (const char *)node->name, *parent = (const char *)node->parent->name;
	const char *nearest = find_nearest(content, false, name);

	if (node->ns)
		xml_error(v->xml, node, "element <%s> is in a namespace; these files use none", xml_quote(name).text);
	else if (schema_has_element(xmlDocGetRootElement(v->schema), name))
		xml_error(v->xml, node, "element <%s> does not belong in <%s>", name, parent);
	else if (nearest)
		xml_error(v->xml, node, "unknown element <%s> in <%s>; did you mean <%s>?", xml_quote(name).text,
			  parent, nearest);
	else
		xml_error(v->xml, node, "unknown element <%s> in <%s>", xml_quote(name).text, parent);
}

static void unknown_attribute(struct validation *v, const xmlNode *node, const char *name,
			      const struct content *content)
{
	const char *nearest = find_nearest(content, true, name);

	if (nearest)
		xml_error(v->xml, node, "unknown attribute '%s' of <%s>; did you mean '%s'?", xml_quote(name).text,
			  (const char *)node->name, nearest);
	else
		xml_error(v->xml, node, "unknown attribute '%s' of <%s>", xml_quote(name).text,
			  (const char *)node->name);
}

/* "a, b or c", for the <value>s below a pattern; true if text is one of them. */
static bool is_choice(const xmlNode *pattern, const char *text, struct strbuf *list)
{
	bool found = false;

	for (const xmlNode *node = xml_first(pattern); node; node = xml_next(node)) {
		const char *word = (const char *)node->children->content;

		found |= strcmp(word, text) == 0;
		if (node != xml_first(pattern))
			strbuf_addf(list, "%s", xml_next(node) ? ", " : " or ");
		strbuf_addf(list, "%s", word);
	}
	return found;
}

/* As many numbers as the <list> holds, all of them finite. */
static bool is_list(const xmlNode *list, const char *text)
{
	static const char space[] = " \t\r\n";
	size_t wanted = xml_count(list, "data"), count = 0;
	bool good = true;
	double value;

	for (text += strspn(text, space); *text; text += strspn(text, space)) {
		size_t length = strcspn(text, space);
		char *word = strndup(text, length);

		good &= word && xml_parse_number(word, &value) && isfinite(value);
		count++;
		free(word);
		text += length;
	}
	return good && count == wanted;
}

static bool is_integer(const char *text)
{
	return *text && strspn(text, "0123456789") == strlen(text);
}

/* "2026-12-31", and the month has that day: less than XML Schema's dates, which may have a zone and odd years. */
static bool is_date(const char *text)
{
	static const int lengths[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
	long year, month, day;

	if (strlen(text) != 10 || text[4] != '-' || text[7] != '-' || strspn(text, "0123456789-") != 10)
		return false;
	year = strtol(text, NULL, 10);
	month = strtol(text + 5, NULL, 10);
	day = strtol(text + 8, NULL, 10);
	if (month < 1 || month > 12 || day < 1 || year < 1)
		return false;
	return day <= lengths[month - 1] + (month == 2 && (year % 400 == 0 || (year % 4 == 0 && year % 100 != 0)));
}

/* Holds the value of an attribute against its pattern; `node` is the document's element, for the place. */
static void check_value(struct validation *v, const xmlNode *node, const char *name, const char *text,
			const xmlNode *pattern)
{
	const xmlNode *type = xml_first(pattern);
	struct strbuf words = {0};
	double number;

	while (xml_is(type, "ref"))
		type = xml_first(find_define(v, value_of(type, "name")));
	if (xml_is(type, "list")) {
		if (!is_list(type, text))
			strbuf_addf(&words, "must be %zu numbers", xml_count(type, "data"));
	} else if (xml_is(type, "choice") || xml_is(type, "value")) {
		strbuf_addf(&words, "must be ");
		if (is_choice(xml_is(type, "choice") ? type : pattern, text, &words))
			strbuf_clear(&words);
	} else if (xml_is(type, "data") && strcmp(value_of(type, "type"), "double") == 0) {
		if (!xml_parse_number(text, &number))
			strbuf_addf(&words, "is not a number");
		else if (!isfinite(number))
			strbuf_addf(&words, "is too large");
	} else if (xml_is(type, "data") && strcmp(value_of(type, "type"), "date") == 0) {
		if (!is_date(text))
			strbuf_addf(&words, "is no date like 2026-12-31");
	} else if (xml_is(type, "data")) {
		bool positive = strcmp(value_of(type, "type"), "positiveInteger") == 0;

		if (!is_integer(text) || (positive && strspn(text, "0") == strlen(text)))
			strbuf_addf(&words, "must be a whole number, %d or more", positive);
	}
	if (words.length)
		xml_error(v->xml, node, "%s=\"%s\" of <%s> %s", name, xml_quote(text).text, (const char *)node->name,
			  strbuf_text(&words));
	strbuf_release(&words);
}

static void check_attributes(struct validation *v, const xmlNode *node, const struct content *content)
{
	for (const xmlAttr *attribute = node->properties; attribute; attribute = attribute->next) {
		const char *name = (const char *)attribute->name;
		const struct entry *entry = attribute->ns ? NULL : find_entry(content, true, name);
		const xmlNode *value = attribute->children;

		if (!entry)
			unknown_attribute(v, node, name, content);
		else if (value && (value->type != XML_TEXT_NODE || value->next))
			xml_error(v->xml, node, "attribute '%s' of <%s> refers to an entity", name,
				  (const char *)node->name);
		else
			check_value(v, node, name, value ? (const char *)value->content : "", entry->pattern);
	}
	for (size_t i = 0; i < content->count; i++) {
		const struct entry *entry = &content->entries[i];

		if (entry->attribute && entry->required && !xml_attribute(node, entry->name))
			xml_error(v->xml, node, "<%s> lacks the attribute '%s'", (const char *)node->name, entry->name);
	}
}

/* Text between elements, or what else is neither an element nor a remark. */
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

static void check_element(struct validation *v, const xmlNode *node, const xmlNode *pattern, int depth);

static void check_children(struct validation *v, const xmlNode *node, const struct content *content, int depth)
{
	size_t seen[ENTRIES_MAX] = {0};
	size_t count = 0;
	bool stray = false;

	for (const xmlNode *child = node->children; child && !xml_is_full(v->xml); child = child->next) {
		const char *name = (const char *)child->name;
		const struct entry *entry;

		if (child->type != XML_ELEMENT_NODE) {
			stray |= is_stray(child);
			continue;
		}
		if (++count > CHILDREN_MAX) {
			xml_error(v->xml, node, "<%s> holds more than %d elements", (const char *)node->name,
				  CHILDREN_MAX);
			return;
		}
		entry = child->ns ? NULL : find_entry(content, false, name);
		if (!entry) {
			unknown_element(v, child, content);
			continue;
		}
		if (seen[entry - content->entries]++ && !entry->repeated)
			xml_error(v->xml, child, "<%s> has a second <%s>", (const char *)node->name, name);
		check_element(v, child, entry->pattern, depth + 1);
	}
	if (stray)
		xml_error(v->xml, node, "<%s> holds text; only elements belong there", (const char *)node->name);
	for (size_t i = 0; i < content->count; i++)
		if (!content->entries[i].attribute && content->entries[i].required && !seen[i])
			xml_error(v->xml, node, "<%s> lacks <%s>", (const char *)node->name, content->entries[i].name);
}

static void check_element(struct validation *v, const xmlNode *node, const xmlNode *pattern, int depth)
{
	struct content content = {.count = 0};

	if (depth > DEPTH_MAX) {
		xml_error(v->xml, node, "elements are nested more than %d deep", DEPTH_MAX);
		return;
	}
	if (node->nsDef)
		xml_error(v->xml, node, "<%s> declares a namespace; these files use none", (const char *)node->name);
	collect(v, pattern, true, false, &content);
	check_attributes(v, node, &content);
	check_children(v, node, &content, depth);
}

/* A file of the other kind, or of a later version, gets one plain message. */
static bool check_root(struct xml_reader *xml, const char *root)
{
	const xmlNode *node = xml_root(xml);
	const char *version = xml_attribute(node, "version");

	if (!xml_is(node, root)) {
		if (xml_is(node, "setup") || xml_is(node, "waivers"))
			xml_error(xml, node, "this is a %s file where a %s file is wanted: give it with --%s",
				  (const char *)node->name, root, (const char *)node->name);
		else if (xml_is(node, "machine"))
			xml_error(xml, node, "this is a machine file where a %s file is wanted", root);
		else
			xml_error(xml, node, "the root element is <%s>, but a %s file starts with <%s version=\"1\">",
				  xml_quote((const char *)node->name).text, root, root);
		return false;
	}
	if (version && strcmp(version, "1") != 0) {
		xml_error(xml, node, "version \"%s\" of the %s file is not supported; this program reads version 1",
			  xml_quote(version).text, root);
		return false;
	}
	return true;
}

/*
 * The machine's schema includes the setup's, as it would from a folder: the
 * <include> gives way to its own <start> and the other schema's definitions.
 */
static xmlDoc *load_machine_schema(void)
{
	xmlDoc *setup = xmlReadMemory(setup_schema, (int)sizeof(setup_schema) - 1, "setup.rng", NULL, XML_PARSE_NONET);
	xmlDoc *machine = xmlReadMemory(machine_schema, (int)sizeof(machine_schema) - 1, "machine.rng", NULL,
					XML_PARSE_NONET);
	xmlNode *grammar, *include;

	if (machine && setup) {
		grammar = xmlDocGetRootElement(machine);
		include = xml_first(grammar);
		assert(xml_is(include, "include"));
		xmlAddChild(grammar, xmlDocCopyNode(xml_first(include), machine, 1));
		for (xmlNode *node = xml_first(xmlDocGetRootElement(setup)); node; node = xml_next(node))
			if (xml_is(node, "define"))
				xmlAddChild(grammar, xmlDocCopyNode(node, machine, 1));
		xmlUnlinkNode(include);
		xmlFreeNode(include);
	}
	xmlFreeDoc(setup);
	return machine;
}

static xmlDoc *load_schema(const char *root)
{
	if (strcmp(root, "setup") == 0)
		return xmlReadMemory(setup_schema, (int)sizeof(setup_schema) - 1, "setup.rng", NULL, XML_PARSE_NONET);
	if (strcmp(root, "waivers") == 0)
		return xmlReadMemory(waivers_schema, (int)sizeof(waivers_schema) - 1, "waivers.rng", NULL,
				     XML_PARSE_NONET);
	return load_machine_schema();
}

static const xmlNode *start_pattern(const xmlDoc *schema)
{
	const xmlNode *node = xml_first(xmlDocGetRootElement(schema));

	while (node && !xml_is(node, "start"))
		node = xml_next(node);
	assert(node);
	return xml_first(node);
}

/* libxml2's own judgement, terse as it is, stands behind ours. */
static void validate_strictly(struct validation *v)
{
	struct xml_capture capture;
	xmlRelaxNGParserCtxt *parser;
	xmlRelaxNG *compiled = NULL;
	xmlRelaxNGValidCtxt *context;

	xml_capture_begin(&capture, v->xml, "this does not follow the schema");
	parser = xmlRelaxNGNewDocParserCtxt(v->schema);
	if (parser)
		compiled = xmlRelaxNGParse(parser);
	context = compiled ? xmlRelaxNGNewValidCtxt(compiled) : NULL;
	if ((!context || xmlRelaxNGValidateDoc(context, v->xml->doc) != 0) && !v->xml->errors)
		xml_error_at(v->xml, 0, "this does not follow the schema");
	xmlRelaxNGFreeValidCtxt(context);
	xmlRelaxNGFree(compiled);
	xmlRelaxNGFreeParserCtxt(parser);
	xml_capture_end(&capture);
}

bool xml_validate(struct xml_reader *xml, const char *root)
{
	struct validation v = {.xml = xml};

	if (!check_root(xml, root))
		return false;
	v.schema = load_schema(root);
	if (!v.schema) {
		xml_error_at(xml, 0, "the schema cannot be loaded");
		return false;
	}
	check_element(&v, xml_root(xml), start_pattern(v.schema), 1);
	if (!xml->errors)
		validate_strictly(&v);
	xmlFreeDoc(v.schema);
	return xml->errors == 0;
}
