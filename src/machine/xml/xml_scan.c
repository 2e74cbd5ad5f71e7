#include "machine/xml/xml_scan.h"

#include <string.h>

#include "base/ascii.h"
#include "base/file_signature.h"
#include "base/mem.h"

/* The largest number of '=' in a tag: one for each attribute, and some in the values. */
#define EQUALS_MAX 1000

struct scan {
	const char *at, *end;
	long line;
};

static bool looking_at(const struct scan *scan, const char *text)
{
	size_t length = strlen(text);

	return (size_t)(scan->end - scan->at) >= length && memcmp(scan->at, text, length) == 0;
}

static void step(struct scan *scan)
{
	scan->line += *scan->at == '\n';
	scan->at++;
}

/* Skips past the text, or to the end of the file. */
static void skip_past(struct scan *scan, const char *text)
{
	while (scan->at < scan->end && !looking_at(scan, text))
		step(scan);
	if (scan->at < scan->end)
		scan->at += strlen(text);
}

/*
 * The number of '=' between a '<' and the next one. A well-formed tag contains no '<', even in quotes, and the parser
 * accepts no other tag.
 */
static size_t count_equals(struct scan *scan)
{
	size_t count = 0;

	do {
		count += *scan->at == '=';
		step(scan);
	} while (scan->at < scan->end && *scan->at != '<');
	return count;
}

static void note_tag(struct xml_reader *xml, const struct scan *scan, const char *bytes)
{
	xml->tags = mem_grow(xml->tags, &xml->tag_capacity, xml->tag_count + 1, sizeof(*xml->tags));
	xml->tags[xml->tag_count++] = (struct xml_tag){.offset = (size_t)(scan->at - bytes), .line = scan->line};
}

/* Encodings in which every ASCII byte is the same ASCII character. */
static bool extends_ascii(const char *name)
{
	static const char *const starts[] = {"UTF-8", "US-ASCII", "ASCII", "ISO-8859-", "windows-125"};

	for (size_t i = 0; i < sizeof(starts) / sizeof(starts[0]); i++)
		if (ascii_same_start(name, starts[i], strlen(starts[i])))
			return true;
	return false;
}

/* Checks the encoding in <?xml version="1.0" encoding="NAME"?>; without one it is UTF-8. */
static bool check_encoding(struct xml_reader *xml, const struct scan *start)
{
	struct scan scan = *start, declaration = *start;
	char name[32];
	size_t length = 0;

	if (!looking_at(&scan, "<?xml"))
		return true;
	skip_past(&declaration, "?>");
	scan.end = declaration.at;
	skip_past(&scan, "encoding");
	while (scan.at < scan.end && strchr(" \t\r\n=\"'", *scan.at))
		step(&scan);
	while (scan.at < scan.end && !strchr("\"'", *scan.at) && length + 1 < sizeof(name))
		name[length++] = *scan.at++;
	name[length] = '\0';
	if (length == 0 || extends_ascii(name))
		return true;
	xml_error_at(xml, scan.line, "the encoding \"%s\" is not supported: save the file as UTF-8",
		     xml_quote(name).text);
	return false;
}

bool xml_scan(struct xml_reader *xml, const char *bytes, size_t length)
{
	struct scan scan = {.at = bytes, .end = bytes + length, .line = 1};
	const char *advice = file_signature_advice(bytes, length);

	if (advice) {
		xml_error_at(xml, 0, "%s", advice);
		return false;
	}
	if (memchr(bytes, '\0', length)) {
		xml_error_at(xml, 0, "the file has NUL bytes: it is not text, or not UTF-8");
		return false;
	}
	if (looking_at(&scan, "\xef\xbb\xbf"))
		scan.at += 3;
	while (scan.at < scan.end && strchr(" \t\r\n", *scan.at))
		step(&scan);
	if (scan.at == scan.end) {
		xml_error_at(xml, 0, "the file is empty: it has no element");
		return false;
	}
	if (*scan.at != '<') {
		xml_error_at(xml, scan.line, "this is not XML: it does not start with '<'");
		return false;
	}
	if (!check_encoding(xml, &scan))
		return false;
	while (scan.at < scan.end) {
		long line = scan.line;

		if (looking_at(&scan, "<!--")) {
			skip_past(&scan, "-->");
		} else if (looking_at(&scan, "<![CDATA[")) {
			skip_past(&scan, "]]>");
		} else if (looking_at(&scan, "<?")) {
			skip_past(&scan, "?>");
		} else {
			/* The position may be text after a comment. */
			if (*scan.at == '<' && !looking_at(&scan, "</") && !looking_at(&scan, "<!"))
				note_tag(xml, &scan, bytes);
			if (count_equals(&scan) > EQUALS_MAX) {
				xml_error_at(xml, line, "this tag has more than %d attributes", EQUALS_MAX);
				return false;
			}
		}
	}
	return true;
}
