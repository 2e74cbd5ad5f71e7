#include "machine/xml/xml_attribute.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/decimal.h"
#include "base/spelling.h"
#include "base/strbuf.h"
#include "base/units.h"

#define LABEL_MAX 200

/* -------------------------------------------------------------- attributes */

/* Remembers the requested attributes, to suggest one for a misspelt name. */
static void note_question(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	if (xml->asked_of != node) {
		xml->asked_of = node;
		xml->asked_count = 0;
	}
	if (xml->asked_count < XML_ASKED_MAX)
		xml->asked[xml->asked_count++] = name;
}

const char *xml_attribute(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	xmlAttr *attribute = xmlHasNsProp(node, (const xmlChar *)name, NULL);

	note_question(xml, node, name);
	if (!attribute)
		return NULL;
	attribute->_private = attribute;
	if (!attribute->children || !attribute->children->content)
		return "";
	return (const char *)attribute->children->content;
}

void xml_require(struct xml_reader *xml, const xmlNode *node, ...)
{
	const char *name;
	va_list names;

	va_start(names, node);
	while ((name = va_arg(names, const char *)))
		if (!xml_attribute(xml, node, name))
			xml_error(xml, node, NULL, "<%s> needs the attribute '%s'", (const char *)node->name, name);
	va_end(names);
}

static void report_unknown(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	struct spelling meant;

	spelling_init(&meant, name);
	for (size_t i = 0; i < xml->asked_count && xml->asked_of == node; i++)
		spelling_offer(&meant, xml->asked[i]);
	if (meant.best)
		xml_error(xml, node, name, "unknown attribute '%s' of <%s>; did you mean '%s'?", xml_quote(name).text,
			  (const char *)node->name, meant.best);
	else
		xml_error(xml, node, name, "unknown attribute '%s' of <%s>", xml_quote(name).text,
			  (const char *)node->name);
}

void xml_attributes_end(struct xml_reader *xml, const xmlNode *node)
{
	for (const xmlAttr *attribute = node->properties; attribute; attribute = attribute->next)
		if (!attribute->_private)
			report_unknown(xml, node, (const char *)attribute->name);
}

static void complain(struct xml_reader *xml, const xmlNode *node, const char *name, const char *what)
{
	xml_error(xml, node, name, "%s=\"%s\" of <%s> %s", name, xml_quote(xml_attribute(xml, node, name)).text,
		  (const char *)node->name, what);
}

/* ----------------------------------------------------------------- numbers */

static const char space[] = " \t\r\n";

/* Reads exactly `count` words, separated by white space. */
static bool read_words(const char *text, size_t count, double *values)
{
	for (size_t i = 0; i < count; i++) {
		size_t length;

		text += strspn(text, space);
		length = strcspn(text, space);
		if (length == 0 || !decimal_read(text, length, &values[i]))
			return false;
		text += length;
	}
	return !text[strspn(text, space)];
}

double xml_number(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback)
{
	const char *text = xml_attribute(xml, node, name);
	double value;

	if (!text)
		return fallback;
	if (!read_words(text, 1, &value))
		complain(xml, node, name,
			 strchr(text, ',') ? "is not a number: write a decimal point" : "is not a number");
	else if (!isfinite(value))
		complain(xml, node, name, "is too large");
	else
		return value;
	return fallback;
}

/* A number in the file's units, converted; its magnitude must be within the limit. */
static double read_scaled(struct xml_reader *xml, const xmlNode *node, const char *name, double unit, double limit,
			  const char *beyond, double fallback)
{
	double value;

	if (!xml_attribute(xml, node, name))
		return fallback;
	value = xml_number(xml, node, name, 0) * unit;
	if (fabs(value) <= limit)
		return value;
	complain(xml, node, name, beyond);
	return fallback;
}

double xml_length(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback)
{
	return read_scaled(xml, node, name, xml->unit, XML_MAGNITUDE_MAX, "is beyond 10 km: check the units", fallback);
}

double xml_angle(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback)
{
	double value;

	if (!xml_attribute(xml, node, name))
		return fallback;
	value = read_scaled(xml, node, name, 1, XML_MAGNITUDE_MAX, "is beyond 10 million degrees", 0);
	return radians(value);
}

static long read_whole(struct xml_reader *xml, const xmlNode *node, const char *name, long least, const char *what,
		       long fallback)
{
	const char *text = xml_attribute(xml, node, name);
	long value;

	if (!text)
		return fallback;
	value = strtol(text, NULL, 10);
	if (*text && strspn(text, "0123456789") == strlen(text) && value >= least)
		return value;
	complain(xml, node, name, what);
	return fallback;
}

long xml_whole(struct xml_reader *xml, const xmlNode *node, const char *name, long fallback)
{
	return read_whole(xml, node, name, 0, "must be a whole number, 0 or more", fallback);
}

long xml_positive(struct xml_reader *xml, const xmlNode *node, const char *name, long fallback)
{
	return read_whole(xml, node, name, 1, "must be a whole number, 1 or more", fallback);
}

vec3 xml_vector(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	const char *text = xml_attribute(xml, node, name);
	double v[3] = {0};

	if (!text || (read_words(text, 3, v) && isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2])))
		return (vec3){v[0], v[1], v[2]};
	complain(xml, node, name, "must be 3 numbers");
	return (vec3){0, 0, 0};
}

static double largest(vec3 v)
{
	return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

vec3 xml_point(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	vec3 point = vec3_scale(xml->unit, xml_vector(xml, node, name));

	if (largest(point) <= XML_MAGNITUDE_MAX)
		return point;
	complain(xml, node, name, "is beyond 10 km: check the units");
	return (vec3){0, 0, 0};
}

void xml_two_lengths(struct xml_reader *xml, const xmlNode *node, const char *name, double *first, double *second)
{
	const char *text = xml_attribute(xml, node, name);
	double v[2] = {0};

	if (!text)
		return;
	if (!read_words(text, 2, v) || !isfinite(v[0]) || !isfinite(v[1])) {
		complain(xml, node, name, "must be 2 numbers");
	} else if (!(fmax(fabs(v[0]), fabs(v[1])) * xml->unit <= XML_MAGNITUDE_MAX)) {
		complain(xml, node, name, "is beyond 10 km: check the units");
	} else {
		*first = v[0] * xml->unit;
		*second = v[1] * xml->unit;
	}
}

static struct optional_number given(struct xml_reader *xml, const xmlNode *node, const char *name, double value)
{
	return (struct optional_number){.given = xml_attribute(xml, node, name) != NULL, .value = value};
}

struct optional_number xml_optional_number(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	return given(xml, node, name, xml_number(xml, node, name, 0));
}

struct optional_number xml_optional_length(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	return given(xml, node, name, xml_length(xml, node, name, 0));
}

struct optional_number xml_optional_angle(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	return given(xml, node, name, xml_angle(xml, node, name, 0));
}

void xml_axis_values(struct xml_reader *xml, const xmlNode *node, struct optional_number value[SLOT_COUNT])
{
	static const char *const letters[SLOT_COUNT] = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		value[slot] = slot_is_rotary(slot) ? xml_optional_angle(xml, node, letters[slot])
						   : xml_optional_length(xml, node, letters[slot]);
}

xform xml_frame(struct xml_reader *xml, const xmlNode *node)
{
	vec3 turn = xml_vector(xml, node, "rotation");
	mat3 x, y, z, r;

	if (!(largest(turn) <= XML_MAGNITUDE_MAX)) {
		complain(xml, node, "rotation", "is beyond 10 million degrees");
		turn = (vec3){0, 0, 0};
	}
	x = mat3_turn((vec3){1, 0, 0}, radians(turn.x));
	y = mat3_turn((vec3){0, 1, 0}, radians(turn.y));
	z = mat3_turn((vec3){0, 0, 1}, radians(turn.z));
	r = mat3_mul(&y, &x);
	return (xform){mat3_mul(&z, &r), xml_point(xml, node, "location")};
}

/* ------------------------------------------------------------------- words */

int xml_choice(struct xml_reader *xml, const xmlNode *node, const char *name, const char *const *words, int fallback)
{
	const char *text = xml_attribute(xml, node, name);
	struct strbuf list = {0};

	if (!text)
		return fallback;
	for (int i = 0; words[i]; i++)
		if (strcmp(text, words[i]) == 0)
			return i;
	strbuf_addf(&list, "must be ");
	for (int i = 0; words[i]; i++)
		strbuf_addf(&list, "%s%s", i == 0 ? "" : words[i + 1] ? ", " : " or ", words[i]);
	complain(xml, node, name, strbuf_text(&list));
	strbuf_release(&list);
	return fallback;
}

static const double unit_sizes[] = {1, MM_PER_INCH, 10, 1000};

double xml_file_units(struct xml_reader *xml, const xmlNode *node, double fallback)
{
	static const char *const words[] = {"mm", "inch", NULL};
	int unit = xml_choice(xml, node, "units", words, -1);

	return unit < 0 ? fallback : unit_sizes[unit];
}

double xml_mesh_units(struct xml_reader *xml, const xmlNode *node, double fallback)
{
	static const char *const words[] = {"mm", "inch", "cm", "m", NULL};
	int unit = xml_choice(xml, node, "units", words, -1);

	return unit < 0 ? fallback : unit_sizes[unit];
}

const char *xml_label(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *text = xml_attribute(xml, node, name);

	if (!text)
		return NULL;
	if (strlen(text) > LABEL_MAX) {
		complain(xml, node, name, "is too long");
		return NULL;
	}
	for (const char *at = text; *at; at++) {
		if (xml_is_control(at)) {
			complain(xml, node, name, "contains a control character");
			return NULL;
		}
	}
	return arena_strdup(arena, text);
}

const char *xml_name(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *text = xml_label(xml, node, name, arena);

	if (text && !*text) {
		complain(xml, node, name, "is empty");
		return NULL;
	}
	return text;
}
