#include "machine/xml/xml_reader.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

#define ERRORS_MAX 20
/* A longer line is not shown as an excerpt. */
#define EXCERPT_MAX ((size_t)200)

void xml_reader_release(struct xml_reader *xml)
{
	xmlFreeDoc(xml->doc);
	free(xml->bytes);
	free(xml->tags);
	xml->doc = NULL;
	xml->bytes = NULL;
	xml->tags = NULL;
	xml->tag_count = xml->tag_capacity = 0;
}

/* ----------------------------------------------------------------- places */

/* NULL: the start of the element is unknown. */
static const struct xml_tag *tag_of(const struct xml_reader *xml, const xmlNode *node)
{
	size_t number = (size_t)(uintptr_t)node->_private;

	return number > 0 && number <= xml->tag_count ? &xml->tags[number - 1] : NULL;
}

/* The offset of an attribute's name in its well-formed tag; that of the tag if it has no such attribute. */
static size_t attribute_offset(const char *bytes, size_t tag, const char *name)
{
	static const char space[] = " \t\r\n";
	const size_t length = strlen(name);
	const char *at = bytes + tag;

	at += strcspn(at, " \t\r\n/>");
	for (;;) {
		const char *start = at + strspn(at, space), *quote;

		if (!*start || strchr("/>", *start))
			return tag;
		if (strncmp(start, name, length) == 0 && strchr(" \t\r\n=", start[length]))
			return (size_t)(start - bytes);
		quote = start + strcspn(start, "\"'");
		at = *quote ? strchr(quote + 1, *quote) : NULL;
		if (!at)
			return tag;
		at++;
	}
}

static long count_lines(const char *at, const char *end)
{
	long lines = 0;

	for (; at < end; at++)
		lines += *at == '\n';
	return lines;
}

long xml_line(const struct xml_reader *xml, const xmlNode *node)
{
	const struct xml_tag *tag = tag_of(xml, node);

	return tag ? tag->line : xmlGetLineNo(node);
}

/* The line with the given offset, to be shown with a caret; NULL: it cannot be shown. The caller frees it. */
static char *excerpt_at(const char *bytes, size_t offset, size_t *column)
{
	const char *start = bytes + offset;
	size_t length;
	char *text;

	while (start > bytes && start[-1] != '\n')
		start--;
	length = strcspn(start, "\r\n");
	*column = (size_t)(bytes + offset - start) + 1;
	if (length > EXCERPT_MAX)
		return NULL;
	text = mem_strndup(start, length);
	if (!xmlCheckUTF8((const xmlChar *)text)) {
		free(text);
		return NULL;
	}
	/* Control characters of one byte become blanks when the line is printed. */
	for (size_t i = 0; i + 1 < length; i++)
		if (text[i] == '\xc2' && xml_is_control(text + i))
			text[i] = text[i + 1] = ' ';
	return text;
}

/* ----------------------------------------------------------------- faults */

static void report(struct xml_reader *xml, struct srcloc loc, const char *excerpt, const char *format, va_list args)
	__attribute__((format(printf, 4, 0)));

static void report(struct xml_reader *xml, struct srcloc loc, const char *excerpt, const char *format, va_list args)
{
	xml->errors++;
	if (xml->errors <= ERRORS_MAX)
		diag_report(xml->diag, DIAG_ERROR, loc, excerpt, format, args);
	if (xml->errors == ERRORS_MAX + 1)
		diag_note(xml->diag, (struct srcloc){.file = xml->path},
			  "more than %d errors; the others are not listed",
			  ERRORS_MAX);
}

bool xml_is_full(const struct xml_reader *xml)
{
	return xml->errors > ERRORS_MAX;
}

__attribute__((format(printf, 4, 0))) static void error_at(struct xml_reader *xml, const xmlNode *node,
							   const char *attribute, const char *format, va_list args)
{
	const struct xml_tag *tag = tag_of(xml, node);
	struct srcloc loc = {.file = xml->path, .line = xml_line(xml, node)};
	char *excerpt = NULL;

	if (tag && !xml_is_full(xml)) {
		size_t offset = attribute ? attribute_offset(xml->bytes, tag->offset, attribute) : tag->offset;
		size_t column;

		excerpt = excerpt_at(xml->bytes, offset, &column);
		loc.line = tag->line + count_lines(xml->bytes + tag->offset, xml->bytes + offset);
		loc.column = (int)column;
	}
	report(xml, loc, excerpt, format, args);
	free(excerpt);
}

void xml_error(struct xml_reader *xml, const xmlNode *node, const char *attribute, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	error_at(xml, node, attribute, format, args);
	va_end(args);
}

void xml_error_at(struct xml_reader *xml, long line, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	report(xml, (struct srcloc){.file = xml->path, .line = line}, NULL, format, args);
	va_end(args);
}

/* ------------------------------------------------------------------- text */

/* XML has no C0 controls but white space; C1 controls, U+0080 to U+009F, start with byte C2. */
bool xml_is_control(const char *at)
{
	const unsigned char *byte = (const unsigned char *)at;

	return byte[0] < 0x20 || byte[0] == 0x7f || (byte[0] == 0xc2 && byte[1] >= 0x80 && byte[1] < 0xa0);
}

struct quotation xml_quote(const char *text)
{
	const size_t most = sizeof(((struct quotation *)NULL)->text) - 4;
	struct quotation quote = {{0}};
	size_t length = 0;

	for (; length < most && text[length]; length++) {
		const char *at = text + length;
		bool control = xml_is_control(at) || (length && at[-1] == '\xc2' && xml_is_control(at - 1));

		quote.text[length] = control ? '?' : text[length];
	}
	if (text[length]) {
		/* Do not divide a character of UTF-8. */
		while (length && ((unsigned char)text[length] & 0xc0) == 0x80)
			length--;
		memcpy(quote.text + length, "...", 4);
	}
	return quote;
}

/* ------------------------------------------------------- description_file */

static void report_described(void *reader, const void *at, const char *attribute, const char *format, va_list args)
{
	error_at(reader, at, attribute, format, args);
}

static struct quotation quote_described(void *reader, const void *at, const char *attribute)
{
	const xmlAttr *found = xmlHasProp(at, (const xmlChar *)attribute);

	(void)reader;
	return xml_quote(found && found->children ? (const char *)found->children->content : "");
}

static long line_of_described(void *reader, const void *at)
{
	return xml_line(reader, at);
}

struct description_file xml_description_file(struct xml_reader *xml)
{
	return (struct description_file){.path = xml->path,
					 .reader = xml,
					 .report = report_described,
					 .quote = quote_described,
					 .line = line_of_described};
}
