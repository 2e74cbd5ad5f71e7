/* github.c - findings as workflow commands, which GitHub shows at the lines of a pull request. */
#include "report/writers/writers.h"

#include "base/utf8.h"
#include "report/format/format_units.h"
#include "report/writers/text.h"

/* Escapes % and line ends, and the characters of `more`, which separate properties. */
static void add_escaped(struct strbuf *out, const char *text, const char *more)
{
	struct strbuf clean = {0};

	utf8_add_clean(&clean, text);
	for (const char *c = strbuf_text(&clean); *c; c++) {
		bool special = *c == '%' || *c == '\r' || *c == '\n';

		for (const char *m = more; *m && !special; m++)
			special = *c == *m;
		if (special)
			strbuf_addf(out, "%%%02X", (unsigned)(unsigned char)*c);
		else
			strbuf_add(out, c, 1);
	}
	strbuf_release(&clean);
}

static void add_command(struct strbuf *out, const char *level, const char *file, long line, int column,
			const char *title, const char *text)
{
	strbuf_addf(out, "::%s ", level);
	if (file) {
		strbuf_addf(out, "file=");
		add_escaped(out, file, ":,");
		strbuf_addf(out, ",");
	}
	if (line)
		strbuf_addf(out, "line=%ld,", line);
	if (line && column)
		strbuf_addf(out, "col=%d,", column);
	strbuf_addf(out, "title=");
	add_escaped(out, title, ":,");
	strbuf_addf(out, "::");
	add_escaped(out, text, "");
	strbuf_addf(out, "\n");
}

static void add_finding(struct strbuf *out, const struct report_run *run, const struct finding *f,
			struct finding_style style)
{
	struct strbuf text = {0};

	if (style.status == FINDING_WAIVED)
		return;
	text_sentence(&text, f);
	strbuf_addf(&text, ", at ");
	format_units_add(&text, 100 * f->fraction);
	strbuf_addf(&text, " %% of the block: ");
	format_units_add_axes(&text, run->scene->machine, &f->axes);
	for (size_t i = 0; i < f->caller_count; i++)
		strbuf_addf(&text, "; called from %s:%ld", f->callers[i].file, f->callers[i].line);
	add_command(out, style.status == FINDING_FAILS ? "error" : "warning", f->file, f->line, f->column,
		    finding_kind_name(f->kind), strbuf_text(&text));
	strbuf_release(&text);
}

static void add_program(struct strbuf *out, const struct report_run *run, const struct report_program *program)
{
	(void)run;
	for (size_t i = 0; i < program->error_count; i++) {
		const struct report_error *error = &program->errors[i];

		add_command(out, "error", error->file ? error->file : program->name, error->line, error->column,
			    "incomplete", error->text);
	}
	for (int i = 0; program->verdict && i < VERDICT_CAUTIONS; i++) {
		struct strbuf text = {0};

		if (verdict_add_caution(&text, program->verdict, i))
			add_command(out, "notice", program->name, 0, 0, "caution", strbuf_text(&text));
		strbuf_release(&text);
	}
}

static void add_end(struct strbuf *out, const struct report_run *run, const struct report_end *end,
		    const struct strbuf *items)
{
	(void)run;
	(void)items;
	/* One notice for all waived findings: the ten permitted items are needed for findings that fail. */
	if (end->sums->waived)
		strbuf_addf(out, "::notice title=fivecheck::%ld waived (--waivers)\n", end->sums->waived);
	if (end->left_out)
		strbuf_addf(out, "::error title=fivecheck::%zu more %s not shown here\n", end->left_out,
			    end->left_out == 1 ? "is" : "are");
}

static void add_nothing(struct strbuf *out, const struct report_run *run)
{
	(void)out;
	(void)run;
}

/*
 * A line "::error file=...,line=...,col=...,title=...::text" for each finding and each error, at most ten, because
 * GitHub shows no more for one step; then the number of the others. A "::notice" for each caution, at most ten as well.
 * Source: GitHub, "Workflow commands for GitHub Actions".
 */
const struct report_writer github_writer = {
    .name = "github",
    .mark = "::",
    .limit = 10,
    .free = "::notice ",
    .begin = add_nothing,
    .finding = add_finding,
    .program = add_program,
    .end = add_end,
};
