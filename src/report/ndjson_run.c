#include "report/ndjson_run.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/open_file.h"
#include "base/strbuf.h"
#include "report/writers/ndjson.h"

/* Bytes: the line of a program with very many errors has some megabytes. */
#define LINE_MAX_LENGTH ((size_t)64 << 20)

const char *ndjson_run_text(const json_t *object, const char *key)
{
	return json_string_value(json_object_get(object, key));
}

static bool is_kind(const json_t *line, const char *kind)
{
	const char *known = ndjson_run_text(line, "kind");

	return known && !strcmp(known, kind);
}

bool ndjson_run_is_program(const json_t *line)
{
	return is_kind(line, "program");
}

/* A run that is being read. */
struct reading {
	struct ndjson_run *run;
	struct srcloc at;
	struct diag *diag;
	size_t programs;	/* lines of this kind */
	size_t pending;	/* findings whose program has not come yet */
	size_t findings;	/* those whose program has come */
};

static bool refuse(const struct reading *reading, const char *why)
{
	diag_error(reading->diag, reading->at, "not the result of a run with --format=ndjson: %s", why);
	return false;
}

static bool take_header(struct reading *reading, json_t *object)
{
	if (!is_kind(object, "header"))
		return refuse(reading, "the header is missing");
	if (json_integer_value(json_object_get(object, "format")) != NDJSON_FORMAT)
		return refuse(reading, "the format has another version: run this version of fivecheck again");
	reading->run->header = json_incref(object);
	return true;
}

/* Is the verdict possible for a program with this number of findings? */
static bool fits(const char *verdict, size_t findings)
{
	if (!strcmp(verdict, "clear") || !strcmp(verdict, "passed"))
		return !findings;
	if (!strcmp(verdict, "found") || !strcmp(verdict, "accepted"))
		return findings > 0;
	return !strcmp(verdict, "incomplete");
}

/* The line of a program gives the number of findings in the lines before it. */
static bool take_program(struct reading *reading, const json_t *object)
{
	const char *verdict = ndjson_run_text(object, "verdict");
	json_int_t findings = json_integer_value(json_object_get(object, "findings"));

	if (!ndjson_run_text(object, "file"))
		return refuse(reading, "a program without a name");
	if (findings != (json_int_t)reading->pending) {
		diag_error(
		    reading->diag, reading->at,
		    "'%s' has %lld %s, but this file has %zu: lines were removed or added; use the file as the run "
		    "wrote it",
		    ndjson_run_text(object, "file"), (long long)findings, findings == 1 ? "finding" : "findings",
		    reading->pending);
		return false;
	}
	if (!verdict || !fits(verdict, reading->pending))
		return refuse(reading, "a program whose verdict does not belong to its findings");
	reading->findings += reading->pending;
	reading->programs++;
	reading->pending = 0;
	return true;
}

static bool take_line(struct reading *reading, json_t *object)
{
	struct ndjson_run *run = reading->run;

	if (!ndjson_run_text(object, "kind"))
		return refuse(reading, "a line without a kind");
	if (!run->header)
		return take_header(reading, object);
	if (is_kind(object, "header"))
		return refuse(reading, "the file has the results of two runs");
	if (run->summary)
		return refuse(reading, "lines after its summary");
	if (is_kind(object, "summary")) {
		run->summary = json_incref(object);
		return true;
	}
	if (ndjson_run_is_program(object) && !take_program(reading, object))
		return false;
	reading->pending += !ndjson_run_is_program(object);
	run->lines = mem_grow(run->lines, &run->capacity, run->count + 1, sizeof(json_t *));
	run->lines[run->count++] = json_incref(object);
	return true;
}

/* Reads the next line, at most up to a byte 0 or the maximum length. False: there are no more. */
static bool next_line(struct strbuf *line, FILE *in)
{
	int c;

	strbuf_clear(line);
	while (line->length < LINE_MAX_LENGTH && (c = getc(in)) != EOF && c != '\n') {
		const char byte = (char)c;

		strbuf_add(line, &byte, 1);
		if (!c)
			break;
	}
	return !ferror(in) && (line->length || !feof(in));
}

static bool take_lines(struct reading *reading, FILE *in)
{
	struct strbuf line = {0};
	bool good = true;

	errno = 0;
	while (good && next_line(&line, in)) {
		json_t *object = json_loadb(strbuf_text(&line), line.length, JSON_REJECT_DUPLICATES, NULL);

		reading->at.line++;
		good = object ? take_line(reading, object) : refuse(reading, "a line that is not a JSON object");
		json_decref(object);
	}
	strbuf_release(&line);
	if (good && ferror(in)) {
		diag_error(reading->diag, (struct srcloc){reading->at.file, 0, 0}, "cannot read: %s",
			   strerror(errno ? errno : EIO));
		good = false;
	}
	return good;
}

static bool is_whole(const struct reading *reading)
{
	const struct ndjson_run *run = reading->run;
	json_int_t programs = json_integer_value(json_object_get(run->header, "programs"));
	json_int_t findings = json_integer_value(json_object_get(run->summary, "findings"));

	if (!run->summary || reading->pending || (json_int_t)reading->programs != programs ||
	    (json_int_t)reading->findings != findings)
		return refuse(reading, "the file is truncated");
	return true;
}

bool ndjson_run_load(struct ndjson_run *run, const char *path, struct diag *diag)
{
	struct reading reading = {.run = run, .at = {path, 0, 0}, .diag = diag};
	FILE *in = open_file(path, diag);
	bool good;

	*run = (struct ndjson_run){.path = path};
	if (!in)
		return false;
	good = take_lines(&reading, in) && is_whole(&reading);
	fclose(in);
	return good;
}

void ndjson_run_release(struct ndjson_run *run)
{
	for (size_t i = 0; i < run->count; i++)
		json_decref(run->lines[i]);
	free(run->lines);
	json_decref(run->header);
	json_decref(run->summary);
	*run = (struct ndjson_run){0};
}
