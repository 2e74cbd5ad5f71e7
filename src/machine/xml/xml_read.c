#include "machine/xml/xml_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/decimal.h"
#include "base/units.h"
#include "machine/xml/xml_file.h"
#include "machine/xml/xml_schema.h"

#define ERRORS_MAX 20
#define LABEL_MAX 200

bool xml_open(struct xml_reader *xml, const char *path, const char *root, struct diag *diag)
{
	*xml = (struct xml_reader){.path = path, .diag = diag, .unit = 1};
	if (!xml_parse_file(xml))
		return false;
	if (xml_validate(xml, root)) {
		xml->unit = xml_units(xml_root(xml), 1);
		return true;
	}
	xml_close(xml);
	return false;
}

void xml_close(struct xml_reader *xml)
{
	xmlFreeDoc(xml->doc);
	xml->doc = NULL;
}

xmlNode *xml_root(const struct xml_reader *xml)
{
	return xmlDocGetRootElement(xml->doc);
}

static void report(struct xml_reader *xml, long line, const char *format, va_list args)
	__attribute__((format(printf, 3, 0)));

static void report(struct xml_reader *xml, long line, const char *format, va_list args)
{
	struct srcloc loc = {.file = xml->path, .line = line};

	xml->errors++;
	if (xml->errors <= ERRORS_MAX)
		diag_report(xml->diag, DIAG_ERROR, loc, NULL, format, args);
	if (xml->errors == ERRORS_MAX + 1)
		diag_note(xml->diag, (struct srcloc){.file = xml->path}, "there are more faults than these %d",
			  ERRORS_MAX);
}

bool xml_is_full(const struct xml_reader *xml)
{
	return xml->errors > ERRORS_MAX;
}

void xml_error(struct xml_reader *xml, const xmlNode *node, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	report(xml, xmlGetLineNo(node), format, args);
	va_end(args);
}

void xml_error_at(struct xml_reader *xml, long line, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	report(xml, line, format, args);
	va_end(args);
}

/* XML has no C0 controls but white space; C1 controls, U+0080 to U+009F, start with byte C2. */
static bool is_control(const unsigned char *at)
{
	return at[0] < 0x20 || at[0] == 0x7f || (at[0] == 0xc2 && at[1] >= 0x80 && at[1] < 0xa0);
}

struct xml_quote xml_quote(const char *text)
{
	const size_t most = sizeof(((struct xml_quote *)NULL)->text) - 4;
	struct xml_quote quote = {{0}};
	size_t length = 0;

	for (; length < most && text[length]; length++) {
		const unsigned char *at = (const unsigned char *)text + length;
		bool control = is_control(at) || (length && at[-1] == 0xc2 && is_control(at - 1));

		quote.text[length] = control ? '?' : text[length];
	}
	if (text[length]) {
		/* Not within a character of UTF-8. */
		while (length && ((unsigned char)text[length] & 0xc0) == 0x80)
			length--;
		memcpy(quote.text + length, "...", 4);
	}
	return quote;
}

static const char *skip_space(const char *at)
{
	return at + strspn(at, " \t\r\n");
}

/* Reads the number at `text`, which is moved behind it and the blanks that follow. */
static bool take_number(const char **text, double *value)
{
	const char *start = skip_space(*text);
	size_t length = strcspn(start, " \t\r\n");

	*text = skip_space(start + length);
	return decimal_read(start, length, value);
}

bool xml_parse_number(const char *text, double *out)
{
	double value;

	if (!take_number(&text, &value) || *text)
		return false;
	*out = value;
	return true;
}

bool xml_is(const xmlNode *node, const char *name)
{
	return node->type == XML_ELEMENT_NODE && strcmp((const char *)node->name, name) == 0;
}

static xmlNode *element_from(xmlNode *node)
{
	while (node && node->type != XML_ELEMENT_NODE)
		node = node->next;
	return node;
}

xmlNode *xml_first(const xmlNode *parent)
{
	return element_from(parent->children);
}

xmlNode *xml_next(const xmlNode *node)
{
	return element_from(node->next);
}

size_t xml_count(const xmlNode *parent, const char *name)
{
	size_t count = 0;

	for (const xmlNode *node = xml_first(parent); node; node = xml_next(node))
		count += xml_is(node, name) + xml_count(node, name);
	return count;
}

const char *xml_attribute(const xmlNode *node, const char *name)
{
	const xmlAttr *attribute = xmlHasProp(node, (const xmlChar *)name);

	if (!attribute)
		return NULL;
	if (!attribute->children || !attribute->children->content)
		return "";
	return (const char *)attribute->children->content;
}

static void complain(struct xml_reader *xml, const xmlNode *node, const char *name, const char *what)
{
	xml_error(xml, node, "%s=\"%s\" of <%s> %s", name, xml_quote(xml_attribute(node, name)).text,
		  (const char *)node->name, what);
}

double xml_number(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback)
{
	const char *text = xml_attribute(node, name);
	double value;

	if (!text)
		return fallback;
	if (xml_parse_number(text, &value) && isfinite(value))
		return value;
	complain(xml, node, name, "is not a number that can be used");
	return fallback;
}

double xml_length(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback)
{
	double value;

	if (!xml_attribute(node, name))
		return fallback;
	value = xml_number(xml, node, name, fallback / xml->unit) * xml->unit;
	if (fabs(value) <= XML_MAGNITUDE_MAX)
		return value;
	complain(xml, node, name, "is beyond 10 km: check the units");
	return fallback;
}

double xml_angle(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback)
{
	double value;

	if (!xml_attribute(node, name))
		return fallback;
	value = xml_number(xml, node, name, degrees(fallback));
	if (fabs(value) <= XML_MAGNITUDE_MAX)
		return radians(value);
	complain(xml, node, name, "is beyond 10 million degrees");
	return fallback;
}

vec3 xml_vector(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	const char *text = xml_attribute(node, name);
	double v[3];

	if (!text)
		return (vec3){0, 0, 0};
	for (int i = 0; i < 3; i++) {
		if (!take_number(&text, &v[i]) || !isfinite(v[i]) || (i == 2 && *text)) {
			complain(xml, node, name, "is not three numbers that can be used");
			return (vec3){0, 0, 0};
		}
	}
	return (vec3){v[0], v[1], v[2]};
}

vec3 xml_point(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	vec3 point = vec3_scale(xml->unit, xml_vector(xml, node, name));

	if (fmax(fabs(point.x), fmax(fabs(point.y), fabs(point.z))) <= XML_MAGNITUDE_MAX)
		return point;
	complain(xml, node, name, "is beyond 10 km: check the units");
	return (vec3){0, 0, 0};
}

vec3 xml_direction(struct xml_reader *xml, const xmlNode *node, const char *name)
{
	size_t errors = xml->errors;
	vec3 v = xml_vector(xml, node, name);
	double norm = vec3_norm(v);

	if (norm >= 1e-6 && norm <= 1e6)
		return vec3_scale(1 / norm, v);
	if (xml->errors == errors)
		complain(xml, node, name, "is no direction: its length must be between 1e-6 and 1e6");
	return (vec3){0, 0, 1};
}

int xml_integer(struct xml_reader *xml, const xmlNode *node, const char *name, int fallback, int least, int most)
{
	double value = xml_number(xml, node, name, fallback);

	if (!xml_attribute(node, name))
		return fallback;
	if (value >= least && value <= most && value == floor(value))
		return (int)value;
	xml_error(xml, node, "%s=\"%s\" of <%s> is not between %d and %d", name,
		  xml_quote(xml_attribute(node, name)).text, (const char *)node->name, least, most);
	return fallback;
}

xform xml_frame(struct xml_reader *xml, const xmlNode *node)
{
	vec3 turn = xml_vector(xml, node, "rotation");
	mat3 x, y, z, r;

	if (!(fmax(fabs(turn.x), fmax(fabs(turn.y), fabs(turn.z))) <= XML_MAGNITUDE_MAX)) {
		complain(xml, node, "rotation", "is beyond 10 million degrees");
		turn = (vec3){0, 0, 0};
	}
	x = mat3_turn((vec3){1, 0, 0}, radians(turn.x));
	y = mat3_turn((vec3){0, 1, 0}, radians(turn.y));
	z = mat3_turn((vec3){0, 0, 1}, radians(turn.z));
	r = mat3_mul(&y, &x);
	return (xform){mat3_mul(&z, &r), xml_point(xml, node, "location")};
}

int xml_choice(const xmlNode *node, const char *name, const char *const *words)
{
	const char *text = xml_attribute(node, name);

	for (int i = 0; text && words[i]; i++)
		if (strcmp(text, words[i]) == 0)
			return i;
	return 0;
}

double xml_units(const xmlNode *node, double fallback)
{
	static const char *const words[] = {"", "mm", "inch", "cm", "m", NULL};
	const double factors[] = {fallback, 1, MM_PER_INCH, 10, 1000};

	return factors[xml_choice(node, "units", words)];
}

const char *xml_label(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *text = xml_attribute(node, name);

	if (!text)
		return NULL;
	if (strlen(text) > LABEL_MAX) {
		complain(xml, node, name, "is too long");
		return NULL;
	}
	for (const char *at = text; *at; at++) {
		if (is_control((const unsigned char *)at)) {
			complain(xml, node, name, "holds a control character");
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
