#include "cli/error_list.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static void keep_warning(struct faults *faults, const struct diag_entry *entry)
{
	struct strbuf text = {0};

	if (faults->warnings++)
		return;
	if (entry->loc.file)
		strbuf_addf(&text, "%s:", entry->loc.file);
	if (entry->loc.file && entry->loc.line)
		strbuf_addf(&text, "%ld:", entry->loc.line);
	strbuf_addf(&text, "%s%s", text.length ? " " : "", entry->text);
	faults->first_warning = text.text;
}

void faults_keep(struct faults *faults, const struct diag_entry *entry)
{
	const char *file = entry->loc.file;

	if (entry->severity == DIAG_WARNING)
		keep_warning(faults, entry);
	if (entry->severity != DIAG_ERROR || faults->count == FAULTS_MAX)
		return;
	faults->items = mem_realloc(faults->items, faults->count + 1, sizeof(*faults->items));
	faults->items[faults->count++] = (struct report_fault){
		.file = file ? mem_strndup(file, strlen(file)) : NULL,
		.line = entry->loc.line,
		.column = entry->loc.column,
		.text = mem_strndup(entry->text, strlen(entry->text)),
	};
}

void faults_release(struct faults *faults)
{
	for (size_t i = 0; i < faults->count; i++) {
		free(faults->items[i].file);
		free(faults->items[i].text);
	}
	free(faults->items);
	free(faults->first_warning);
	*faults = (struct faults){0};
}

static void pass(void *context, const struct diag_entry *entry)
{
	struct tap *tap = context;

	faults_keep(&tap->faults, entry);
	diag_pass(tap->out, entry);
}

void tap_init(struct tap *tap, struct diag *out)
{
	*tap = (struct tap){.diag = {.handle = pass, .context = tap}, .out = out};
}

void tap_release(struct tap *tap)
{
	faults_release(&tap->faults);
}
