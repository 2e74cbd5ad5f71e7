#include "base/diag.h"

#include <string.h>

void diag_pass(struct diag *diag, const struct diag_entry *entry)
{
	diag->errors += entry->severity == DIAG_ERROR;
	diag->warnings += entry->severity == DIAG_WARNING;
	if (diag->handle)
		diag->handle(diag->context, entry);
}

void diag_report(struct diag *diag, enum diag_severity severity, struct srcloc loc, const char *excerpt,
		 const char *format, va_list args)
{
	struct strbuf text = {0};
	struct diag_entry entry = {.severity = severity, .loc = loc, .excerpt = excerpt};

	strbuf_addv(&text, format, args);
	entry.text = strbuf_text(&text);
	diag_pass(diag, &entry);
	strbuf_release(&text);
}

void diag_error(struct diag *diag, struct srcloc loc, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	diag_report(diag, DIAG_ERROR, loc, NULL, format, args);
	va_end(args);
}

void diag_warning(struct diag *diag, struct srcloc loc, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	diag_report(diag, DIAG_WARNING, loc, NULL, format, args);
	va_end(args);
}

void diag_note(struct diag *diag, struct srcloc loc, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	diag_report(diag, DIAG_NOTE, loc, NULL, format, args);
	va_end(args);
}

/* The excerpt with its control characters blanked, and a caret below the column. */
static void format_excerpt(struct strbuf *out, const char *excerpt, int column)
{
	size_t length = strlen(excerpt);

	strbuf_add(out, "    ", 4);
	/* The caret counts bytes. */
	for (size_t i = 0; i < length;) {
		const size_t controls = strbuf_control_bytes(&excerpt[i]);

		strbuf_add(out, controls ? "  " : &excerpt[i], controls ? controls : 1);
		i += controls ? controls : 1;
	}
	strbuf_add(out, "\n", 1);
	if (column > 0 && (size_t)column <= length + 1)
		strbuf_addf(out, "    %*s\n", column, "^");
}

void diag_format(struct strbuf *out, const struct diag_entry *entry)
{
	static const char *const names[] = {"note", "warning", "error"};

	strbuf_add_visible(out, entry->loc.file ? entry->loc.file : "fivecheck");
	strbuf_addf(out, ":");
	if (entry->loc.line > 0)
		strbuf_addf(out, "%ld:", entry->loc.line);
	if (entry->loc.line > 0 && entry->loc.column > 0)
		strbuf_addf(out, "%d:", entry->loc.column);
	strbuf_addf(out, " %s: ", names[entry->severity]);
	strbuf_add_visible(out, entry->text);
	strbuf_addf(out, "\n");
	if (entry->excerpt)
		format_excerpt(out, entry->excerpt, entry->loc.column);
}
