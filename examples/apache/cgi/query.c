#include "query.h"

#include <ctype.h>
#include <string.h>

#include "request.h"
#include "safe_path.h"

static int hex(char digit)
{
	const char *digits = "0123456789abcdef", *at = digit ? strchr(digits, tolower((unsigned char)digit)) : NULL;

	return at ? (int)(at - digits) : -1;
}

/* Decodes %xx and + in place. False: malformed, or a byte that no name has. */
static bool decode(char *text)
{
	char *to = text;

	for (const char *from = text; *from; from++) {
		int value = (unsigned char)*from;

		if (value == '+') {
			value = ' ';
		} else if (value == '%') {
			if (hex(from[1]) < 0 || hex(from[2]) < 0)
				return false;
			value = 16 * hex(from[1]) + hex(from[2]);
			from += 2;
		}
		if (value < 32 || value == 127)
			return false;
		*to++ = (char)value;
	}
	*to = '\0';
	return true;
}

static void take_once(char **word, char *value, struct request *request)
{
	if (*word)
		request_refuse(request, "400 Bad Request", "the query has a word twice");
	*word = value;
}

static void take_word(struct query *query, const char *name, char *value, struct request *request)
{
	if (!strcmp(name, "machine"))
		take_once(&query->machine, value, request);
	else if (!strcmp(name, "setup"))
		take_once(&query->setup, value, request);
	else if (!strcmp(name, "clearance"))
		take_once(&query->clearance, value, request);
	else if (!strcmp(name, "dialect"))
		take_once(&query->dialect, value, request);
	else if (!strcmp(name, "all") && !strcmp(value, "1"))
		query->all = true;
	else if (!strcmp(name, "format") && (!strcmp(value, "text") || !strcmp(value, "ndjson")))
		query->ndjson = !strcmp(value, "ndjson");
	else if (!strcmp(name, "program") && query->program_count < PROGRAMS_MAX)
		query->programs[query->program_count++] = value;
	else
		request_refuse(request, "400 Bad Request",
			       "the query has a word or value that is not known, or too many programs");
}

static bool is_word_of(const char *word, const char *letters)
{
	const size_t length = strlen(word);

	return length <= NUMBER_LENGTH && strspn(word, letters) == length;
}

void query_read(struct query *query, char *text, struct request *request)
{
	char *next = text;

	while (next && *next) {
		char *word = next, *value;

		next = strchr(word, '&');
		if (next)
			*next++ = '\0';
		value = strchr(word, '=');
		if (!value)
			request_refuse(request, "400 Bad Request", "the query has a word without a value");
		*value++ = '\0';
		if (!decode(value))
			request_refuse(request, "400 Bad Request", "the query is malformed");
		take_word(query, word, value, request);
	}
	if (!query->machine || !query->program_count)
		request_refuse(request, "400 Bad Request",
			       "the query must name a machine and a program: ?machine=machine.xml&program=part.nc");
	for (int i = 0; i < query->program_count; i++) {
		if (!is_safe_path(query->programs[i]))
			request_refuse(request, "400 Bad Request", "this is no name of a program");
	}
	if (!is_safe_path(query->machine) || (query->setup && !is_safe_path(query->setup)))
		request_refuse(request, "400 Bad Request", "this is no name of a file");
	if (query->clearance && !is_word_of(query->clearance, "0123456789."))
		request_refuse(request, "400 Bad Request", "the clearance is no number, or has more than %d characters",
			       NUMBER_LENGTH);
	if (query->dialect && !is_word_of(query->dialect, "abcdefghijklmnopqrstuvwxyz"))
		request_refuse(request, "400 Bad Request", "this is no name of a control");
}
