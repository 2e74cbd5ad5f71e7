#include "import/ply_check.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/file_bytes.h"

enum { ELEMENTS_MAX = 16, PROPERTIES_MAX = 32 };

/* Bytes of a value; for a list, bytes of its count and of each item. */
struct ply_property {
	size_t size, count_size;	/* count_size 0: it is not a list */
};

struct ply_element {
	unsigned long count;
	struct ply_property properties[PROPERTIES_MAX];
	size_t property_count;
};

struct ply_header {
	bool text, big;
	struct ply_element elements[ELEMENTS_MAX];
	size_t element_count;
};

/* 0: it is not a type of PLY. */
static size_t size_of(const char *type)
{
	static const struct {
		const char *name;
		size_t size;
	} types[] = {{"char", 1},   {"uchar", 1},  {"int8", 1},  {"uint8", 1},   {"short", 2},  {"ushort", 2},
		     {"int16", 2},  {"uint16", 2}, {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
		     {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};

	for (size_t i = 0; i < sizeof(types) / sizeof(*types); i++)
		if (!strcmp(types[i].name, type))
			return types[i].size;
	return 0;
}

static bool read_property(struct ply_header *header, char *words[4], size_t count)
{
	struct ply_element *element = header->element_count ? &header->elements[header->element_count - 1] : NULL;
	struct ply_property property = {0};

	if (!element || element->property_count == PROPERTIES_MAX || count < 2)
		return false;
	property.size = size_of(words[0]);
	if (!strcmp(words[0], "list") && count > 2) {
		property.count_size = size_of(words[1]);
		property.size = property.count_size && property.count_size <= 4 ? size_of(words[2]) : 0;
	}
	element->properties[element->property_count++] = property;
	return property.size > 0;
}

/* One line of the header, divided into words. False: it is not a header line, or has too many words. */
static bool read_header_line(struct ply_header *header, char *line)
{
	char *words[5] = {NULL}, *rest = NULL;
	size_t count = 0;

	for (char *word = strtok_r(line, " \t\r", &rest); word && count < 5; word = strtok_r(NULL, " \t\r", &rest))
		words[count++] = word;
	if (!count || !strcmp(words[0], "comment") || !strcmp(words[0], "obj_info") || !strcmp(words[0], "ply"))
		return true;
	if (!strcmp(words[0], "format") && count > 1) {
		header->text = !strcmp(words[1], "ascii");
		header->big = !strcmp(words[1], "binary_big_endian");
		return header->text || header->big || !strcmp(words[1], "binary_little_endian");
	}
	if (!strcmp(words[0], "element") && count > 2 && header->element_count < ELEMENTS_MAX) {
		header->elements[header->element_count++].count = strtoul(words[2], NULL, 10);
		return true;
	}
	return !strcmp(words[0], "property") && read_property(header, words + 1, count - 1);
}

/* The text after the header, or NULL. */
static const char *read_header(struct ply_header *header, const char *bytes)
{
	char line[256];

	while (*bytes) {
		size_t length = strcspn(bytes, "\n");

		if (length >= sizeof(line) || !bytes[length])
			return NULL;
		memcpy(line, bytes, length);
		line[length] = '\0';
		bytes += length + 1;
		if (!strncmp(line, "end_header", 10))
			return bytes;
		if (!read_header_line(header, line))
			return NULL;
	}
	return NULL;
}

/* -------------------------------------------------------------------- text */

/* The next number at *at; false: there is none. */
static bool next_word(const char **at, unsigned long *value)
{
	*at += strspn(*at, " \t\r\n");
	*value = strtoul(*at, NULL, 10);
	if (!**at)
		return false;
	*at += strcspn(*at, " \t\r\n");
	return true;
}

static bool pass_text(const struct ply_element *element, const char **at)
{
	for (size_t i = 0; i < element->property_count; i++) {
		unsigned long items, value;

		if (!next_word(at, &items))
			return false;
		for (unsigned long k = 0; element->properties[i].count_size && k < items; k++)
			if (!next_word(at, &value))
				return false;
	}
	return true;
}

/* ------------------------------------------------------------------ binary */

static unsigned long count_at(const unsigned char *bytes, size_t size, bool big)
{
	unsigned long value = 0;

	for (size_t i = 0; i < size; i++)
		value |= (unsigned long)bytes[i] << (8 * (big ? size - 1 - i : i));
	return value;
}

static bool pass_binary(const struct ply_element *element, bool big, const char **at, const char *end)
{
	for (size_t i = 0; i < element->property_count; i++) {
		const struct ply_property *property = &element->properties[i];
		size_t have = (size_t)(end - *at), items = 1;

		if (have < property->count_size)
			return false;
		if (property->count_size)
			items = count_at((const unsigned char *)*at, property->count_size, big);
		have -= property->count_size;
		if (items > have / property->size)
			return false;
		*at += property->count_size + items * property->size;
	}
	return true;
}

static bool is_complete(const struct ply_header *header, const char *at, const char *end)
{
	for (size_t e = 0; e < header->element_count; e++) {
		const struct ply_element *element = &header->elements[e];

		for (unsigned long i = 0; element->property_count && i < element->count; i++)
			if (!(header->text ? pass_text(element, &at) : pass_binary(element, header->big, &at, end)))
				return false;
	}
	return true;
}

bool ply_check(const char *path, struct diag *diag)
{
	struct ply_header header = {.text = false};
	struct file_bytes file;
	const char *data, *what = NULL;

	if (!file_bytes_read(&file, path, diag))
		return false;
	data = read_header(&header, file.bytes);
	if (!data)
		what = "the header of the PLY file is invalid";
	else if (!is_complete(&header, data, file.bytes + file.count))
		what = "the PLY file is truncated: it has less data than its header says";
	file_bytes_release(&file);
	if (what)
		diag_error(diag, (struct srcloc){.file = path}, "%s", what);
	return !what;
}
