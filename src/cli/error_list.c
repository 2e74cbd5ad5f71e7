#include "cli/error_list.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static void keep_warning(struct error_list *errors, const struct diag_entry *entry)
{
	struct strbuf text = {0};

	if (errors->warnings++)
		return;
	if (entry->loc.file)
		strbuf_addf(&text, "%s:", entry->loc.file);
	if (entry->loc.file && entry->loc.line)
		strbuf_addf(&text, "%ld:", entry->loc.line);
	strbuf_addf(&text, "%s%s", text.length ? " " : "", entry->text);
	errors->first_warning = text.text;
}

void error_list_add(struct error_list *errors, const struct diag_entry *entry)
{
	const char *file = entry->loc.file;

	if (entry->severity == DIAG_WARNING)
		keep_warning(errors, entry);
	if (entry->severity != DIAG_ERROR || errors->count == ERROR_LIST_MAX)
		return;
	errors->items = mem_realloc(errors->items, errors->count + 1, sizeof(*errors->items));
	errors->items[errors->count++] = (struct report_error){
		.file = file ? mem_strndup(file, strlen(file)) : NULL,
		.line = entry->loc.line,
		.column = entry->loc.column,
		.text = mem_strndup(entry->text, strlen(entry->text)),
		.block = entry->block,
		.excerpt = entry->excerpt ? mem_strndup(entry->excerpt, strlen(entry->excerpt)) : NULL,
	};
}

void error_list_release(struct error_list *errors)
{
	for (size_t i = 0; i < errors->count; i++) {
		free(errors->items[i].file);
		free(errors->items[i].text);
		free(errors->items[i].excerpt);
	}
	free(errors->items);
	free(errors->first_warning);
	*errors = (struct error_list){0};
}
