/* junit.c - results in the format of unit tests for CI servers: a test case for each program. */
#include "report/writers/writers.h"

#include <libxml/tree.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/utf8.h"
#include "report/writers/text.h"

/* Makes text that XML 1.0 permits (section 2.2): no control characters but tab and line feed, no U+FFFE and U+FFFF. */
static char *xml_text(const char *text)
{
	struct strbuf clean = {0};
	char *out;

	utf8_add_clean(&clean, text);
	out = mem_strndup(strbuf_text(&clean), clean.length);
	for (char *c = out; *c; c++) {
		if ((unsigned char)*c < 0x20 && *c != '\t' && *c != '\n')
			*c = ' ';
		if (!strncmp(c, "\xef\xbf\xbe", 3) || !strncmp(c, "\xef\xbf\xbf", 3))
			memcpy(c, "\xef\xbf\xbd", 3); /* NOLINT(bugprone-not-null-terminated-result) */
	}
	strbuf_release(&clean);
	return out;
}

static void set_attribute(xmlNode *node, const char *name, const char *value)
{
	char *text = xml_text(value);

	xmlNewProp(node, BAD_CAST name, BAD_CAST text);
	free(text);
}

static xmlNode *add_text_node(xmlNode *parent, const char *name, const char *value)
{
	char *text = xml_text(value);
	xmlNode *node = xmlNewTextChild(parent, NULL, BAD_CAST name, BAD_CAST text);

	free(text);
	return node;
}

static void add_finding(struct strbuf *out, const struct report_run *run, const struct finding *finding,
			struct finding_style style)
{
	if (style.status == FINDING_FAILS)
		text_finding(out, run->scene->machine, finding, style);
}

/* "part.nc:118:1: error: the machine has no B axis" */
static void add_error(struct strbuf *out, const struct report_program *program, const struct report_error *error)
{
	strbuf_addf(out, "%s:", error->file ? error->file : program->name);
	if (error->line)
		strbuf_addf(out, "%ld:", error->line);
	if (error->line && error->column)
		strbuf_addf(out, "%d:", error->column);
	strbuf_addf(out, " error: %s", error->text);
}

/* <failure> or <error> */
static void add_outcome(xmlNode *testcase, const char *element, const char *type, const char *message,
			const char *body)
{
	xmlNode *node = add_text_node(testcase, element, body);

	set_attribute(node, "message", message);
	set_attribute(node, "type", type);
}

/* The first error is the message; all errors and the findings before them are the text. */
static void add_errors(xmlNode *testcase, const struct report_program *program, const char *findings)
{
	struct strbuf message = {0}, body = {0};

	for (size_t i = 0; i < program->error_count; i++) {
		add_error(&body, program, &program->errors[i]);
		if (!i)
			strbuf_add(&message, body.text, body.length);
		strbuf_addf(&body, "\n");
	}
	strbuf_addf(&body, "%s", findings);
	add_outcome(testcase, "error", "incomplete", strbuf_text(&message), strbuf_text(&body));
	strbuf_release(&message);
	strbuf_release(&body);
}

static void add_node(struct strbuf *out, xmlDoc *doc, xmlNode *node)
{
	xmlBuffer *buffer = xmlBufferCreate();

	xmlNodeDump(buffer, doc, node, 2, 1);
	strbuf_addf(out, "    %s\n", (const char *)xmlBufferContent(buffer));
	xmlBufferFree(buffer);
}

/* The seconds of the check; they differ from run to run. */
static void set_time(xmlNode *testcase, const struct report_program *program)
{
	const struct check_stats *stats = program->verdict ? program->verdict->stats : NULL;
	char text[32];

	snprintf(text, sizeof(text), "%.3f", stats ? stats->seconds_interpret + stats->seconds_check : 0.0);
	set_attribute(testcase, "time", text);
}

static void add_program(struct strbuf *out, const struct report_run *run, const struct report_program *program)
{
	xmlDoc *doc = xmlNewDoc(BAD_CAST "1.0");
	xmlNode *testcase = xmlNewDocNode(doc, NULL, BAD_CAST "testcase", NULL);
	struct strbuf verdict = {0};

	xmlDocSetRootElement(doc, testcase);
	set_attribute(testcase, "classname", run->scene->machine->path);
	set_attribute(testcase, "name", program->name);
	set_attribute(testcase, "file", program->name);
	set_time(testcase, program);
	if (!program->verdict || program->verdict->result == CHECK_INCOMPLETE)
		add_errors(testcase, program, strbuf_text(out));
	else if (program->first_kind >= 0)
		add_outcome(testcase, "failure", finding_kind_name((enum finding_kind)program->first_kind),
			    program->first_text, strbuf_text(out));
	else if (program->failing_warning)
		add_outcome(testcase, "failure", "warning", program->failing_warning, program->failing_warning);
	if (program->verdict) {
		text_verdict(&verdict, program->verdict);
		strbuf_addf(&verdict, "%s", program->waived);
		add_text_node(testcase, "system-out", verdict.text);
	}
	strbuf_clear(out);
	add_node(out, doc, testcase);
	strbuf_release(&verdict);
	xmlFreeDoc(doc);
}

static void add_nothing(struct strbuf *out, const struct report_run *run)
{
	(void)out;
	(void)run;
}

static void add_all(struct strbuf *out, const struct report_run *run, const struct report_end *end,
		    const struct strbuf *items)
{
	const struct run_stats *sums = end->sums;
	char counts[192];

	(void)run;
	snprintf(counts, sizeof(counts), "name=\"fivecheck\" tests=\"%zu\" failures=\"%zu\" errors=\"%zu\"",
		 sums->programs, sums->programs - sums->clear - sums->accepted - sums->incomplete, sums->incomplete);
	strbuf_addf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites %s>\n", counts);
	strbuf_addf(out, "  <testsuite %s skipped=\"0\" time=\"%.3f\">\n%s  </testsuite>\n</testsuites>\n", counts,
		    sums->check.seconds_interpret + sums->check.seconds_check, strbuf_text(items));
}

/*
 * One test suite. A program with findings has a failure, an incomplete one has an error. The message gives the first
 * place, the text all of them.
 *
 * There is no published standard. The form is that of the schema of Jenkins' xUnit plugin (junit-10.xsd) with one
 * additional attribute, "file", with which GitLab links to the program. The schema known from Ant requires the
 * computer's name and a time of day, but reports of the same input must be equal.
 */
const struct report_writer junit_writer = {
	.name = "junit", .mark = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites ",
	.whole = true, .collects = true, .begin = add_nothing, .finding = add_finding,
	.program = add_program, .end = add_all,
};
