#include "machine/xml/xml_file.h"

#include <errno.h>
#include <fcntl.h>
#include <libxml/parser.h>
#include <libxml/xmlmemory.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/mem.h"
#include "machine/xml/xml_scan.h"

/* The largest permitted file. A machine has kilobytes; the limit also keeps checks of all pairs of names fast. */
#define FILE_SIZE_MAX ((size_t)4 * 1024 * 1024)

#if LIBXML_VERSION >= 21200
typedef const xmlError *xml_fault;
#else
typedef xmlError *xml_fault;
#endif

/* While it is installed, libxml2's messages become errors of the reader, and nothing goes to standard error. */
struct capture {
	struct xml_reader *xml;
	void *old_context, *old_generic_context;
	xmlStructuredErrorFunc old_handler;
	xmlGenericErrorFunc old_generic;
	bool reported;	/* the first message; the others follow from it and are not shown */
};

static void on_fault(void *context, xml_fault fault)
{
	struct capture *capture = context;
	const char *message = fault->message ? fault->message : "unknown fault";
	size_t length = strcspn(message, "\n");
	long line = fault->line > 0 ? fault->line : 0;
	char *text;

	if (fault->level < XML_ERR_ERROR || capture->reported)
		return;
	capture->reported = true;
	text = mem_strndup(message, length);
	for (size_t i = 0; i < length; i++)
		if ((unsigned char)text[i] < 0x20 || text[i] == 0x7f)
			text[i] = '?';
	xml_error_at(capture->xml, line, "this is not well-formed XML: %s", text);
	free(text);
}

static void __attribute__((format(printf, 2, 3))) drop_message(void *context, const char *format, ...)
{
	(void)context;
	(void)format;
}

static void capture_begin(struct capture *capture, struct xml_reader *xml)
{
	*capture = (struct capture){
		.xml = xml,
		.old_context = xmlStructuredErrorContext,
		.old_generic_context = xmlGenericErrorContext,
		.old_handler = xmlStructuredError,
		.old_generic = xmlGenericError,
	};
	xmlSetStructuredErrorFunc(capture, on_fault);
	xmlSetGenericErrorFunc(NULL, drop_message);
}

static void capture_end(struct capture *capture)
{
	xmlSetStructuredErrorFunc(capture->old_context, capture->old_handler);
	xmlSetGenericErrorFunc(capture->old_generic_context, capture->old_generic);
}

/* Reads a descriptor to its end; the caller frees the result. NULL: reported. */
static char *read_all(struct xml_reader *xml, int fd, size_t *length)
{
	char *bytes = mem_alloc(FILE_SIZE_MAX + 1);
	size_t have = 0;
	ssize_t got;

	while (have <= FILE_SIZE_MAX) {
		got = read(fd, bytes + have, FILE_SIZE_MAX + 1 - have);
		if (got < 0 && errno == EINTR)
			continue;
		if (got < 0) {
			xml_error_at(xml, 0, "cannot read: %s", strerror(errno));
			free(bytes);
			return NULL;
		}
		if (got == 0)
			break;
		have += (size_t)got;
	}
	if (have > FILE_SIZE_MAX) {
		xml_error_at(xml, 0, "larger than %zu MiB: this is not a machine, setup or waivers file",
			     FILE_SIZE_MAX / 1024 / 1024);
		free(bytes);
		return NULL;
	}
	bytes[have] = '\0';
	*length = have;
	return mem_realloc(bytes, have + 1, 1);
}

static char *read_file(struct xml_reader *xml, size_t *length)
{
	struct stat status;
	char *bytes = NULL;
	int fd;

	if (strcmp(xml->path, "-") == 0) {
		xml_error_at(xml, 0, "XML files are not read from standard input: name a file");
		return NULL;
	}
	/* O_NONBLOCK: opening a FIFO must not wait for its writer. */
	fd = open(xml->path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
	if (fd < 0) {
		xml_error_at(xml, 0, "cannot open: %s", strerror(errno));
		return NULL;
	}
	if (fstat(fd, &status) != 0)
		xml_error_at(xml, 0, "cannot read: %s", strerror(errno));
	else if (S_ISDIR(status.st_mode))
		xml_error_at(xml, 0, "is a directory, not an XML file");
	else if (!S_ISREG(status.st_mode))
		xml_error_at(xml, 0, "is not a regular file");
	else
		bytes = read_all(xml, fd, length);
	close(fd);
	return bytes;
}

/* Reports the fault at the parser's position, and stops the parser. */
static void stop_parser(xmlParserCtxt *parser, const char *fault)
{
	struct capture *capture = parser->_private;

	if (!capture->reported)
		xml_error_at(capture->xml, parser->input ? parser->input->line : 0, "%s", fault);
	capture->reported = true;
	xmlStopParser(parser);
}

/*
 * Called at the declaration, before its entities are defined. A definition elsewhere is never read, so files of other
 * programs may refer to one.
 */
static void judge_doctype(void *context, const xmlChar *name, const xmlChar *public_id, const xmlChar *system_id)
{
	xmlParserCtxt *parser = context;
	const struct capture *capture = parser->_private;

	(void)name;
	(void)public_id;
	(void)system_id;
	if (!capture->xml->foreign || !parser->input || *parser->input->cur != '>')
		stop_parser(parser, "document type declarations (<!DOCTYPE ...>) are not allowed; remove them");
}

/* Called for entities that XML does not define itself. */
static xmlEntity *refuse_entity(void *context, const xmlChar *name)
{
	(void)name;
	stop_parser(context, "only the entities of XML itself are known (&lt; &amp; ...); write the text");
	return NULL;
}

static void *library_realloc(void *block, size_t size)
{
	return mem_realloc(block, size, 1);
}

static char *library_strdup(const char *text)
{
	return mem_strndup(text, strlen(text));
}

bool xml_file_parse(struct xml_reader *xml)
{
	const int options = XML_PARSE_NONET | XML_PARSE_NOCDATA | XML_PARSE_BIG_LINES;
	struct capture capture;
	xmlParserCtxt *parser;
	size_t length = xml->text ? strlen(xml->text) : 0;
	char *bytes = xml->text ? mem_strndup(xml->text, length) : read_file(xml, &length);

	if (!bytes)
		return false;
	xml->bytes = bytes;
	if (!xml_scan(xml, bytes, length))
		return false;
	/* libxml2 itself does not survive every failed allocation. */
	xmlMemSetup(free, mem_alloc, library_realloc, library_strdup);
	capture_begin(&capture, xml);
	parser = xmlNewParserCtxt();
	if (parser) {
		parser->_private = &capture;
		parser->sax->internalSubset = judge_doctype;
		if (xml->foreign)
			parser->sax->getEntity = refuse_entity;
		xml->doc = xmlCtxtReadMemory(parser, bytes, (int)length, NULL, NULL, options);
		xmlFreeParserCtxt(parser);
	}
	capture_end(&capture);
	if (!xml->doc && !xml->errors)
		xml_error_at(xml, 0, "the XML parser gave up");
	return xml->doc && !xml->errors;
}
