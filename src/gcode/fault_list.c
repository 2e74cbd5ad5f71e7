#include "gcode/fault_list.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static bool is_told(const struct fault_list *list, const char *text)
{
	for (size_t i = 0; i < list->count; i++) {
		if (!strcmp(list->texts[i], text))
			return true;
	}
	return false;
}

static void handle(void *context, const struct diag_entry *entry)
{
	struct fault_list *list = context;

	if (entry->severity != DIAG_NOTE)
		list->left_out = list->beyond;
	if (entry->severity == DIAG_ERROR) {
		list->left_out = true;
		if (is_told(list, entry->text)) {
			list->again++;
		} else if (list->count == FAULT_LIST_MAX) {
			list->beyond++;
		} else {
			list->texts[list->count++] = mem_strndup(entry->text, strlen(entry->text));
			list->left_out = false;
		}
	}
	if (!list->left_out)
		diag_pass(list->to, entry);
}

void fault_list_init(struct fault_list *list, struct diag *to)
{
	*list = (struct fault_list){.diag = {.handle = handle, .context = list}, .to = to};
}

void fault_list_finish(struct fault_list *list, const char *file)
{
	struct srcloc loc = {file, 0, 0};

	if (list->again)
		diag_note(list->to, loc, "%zu more error%s as above", list->again, list->again == 1 ? "" : "s");
	if (list->beyond)
		diag_note(list->to, loc,
			  "%zu more error%s: correct the first %d and check the program again", list->beyond,
			  list->beyond == 1 ? "" : "s", FAULT_LIST_MAX);
	while (list->count > 0)
		free(list->texts[--list->count]);
}
