#include "cli/scan/scan_setup.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "cli/scan/any_machine.h"

/* The largest number of tools and offsets for one set of programs; a longer list is not useful. */
#define ELEMENTS_MAX 2000

void scan_setup_release(struct scan_setup *setup)
{
	for (size_t i = 0; i < setup->count; i++) {
		free(setup->items[i].element);
		free(setup->items[i].place);
	}
	free(setup->items);
	*setup = (struct scan_setup){0};
}

static bool is_known(const struct scan_setup *setup, const char *element, size_t length)
{
	for (size_t i = 0; i < setup->count; i++) {
		if (strlen(setup->items[i].element) == length && !memcmp(setup->items[i].element, element, length))
			return true;
	}
	return false;
}

/* A length offset with the number of a tool is that of the tool, unless the setup has another one. */
static bool is_of_tool(const struct scan_setup *setup, const char *element)
{
	static const char offset[] = "<offset number=\"", length[] = " length=\"\"/>";
	struct strbuf tool = {0};
	const char *number = element + sizeof(offset) - 1;
	bool is;

	if (strncmp(element, offset, sizeof(offset) - 1) != 0 || !strchr(number, ' '))
		return false;
	strbuf_addf(&tool, "<tool number=\"%.*s%s", (int)strcspn(number, " "), number, length);
	is = !strncmp(strchr(number, ' '), length, sizeof(length) - 1) &&
	     is_known(setup, strbuf_text(&tool), tool.length);
	strbuf_release(&tool);
	return is;
}

/* "...: add <tool number="1" length=""/> with its shape" */
static void take_element(void *context, const struct diag_entry *entry)
{
	static const char key[] = "add <";
	struct scan_setup *setup = context;
	const char *from = entry->severity == DIAG_ERROR ? strstr(entry->text, key) : NULL;
	const char *end = from ? strstr(from, "/>") : NULL;
	struct strbuf place = {0};
	size_t length;

	if (!end || setup->count == ELEMENTS_MAX)
		return;
	from += sizeof(key) - 2;
	length = (size_t)(end + 2 - from);
	if (is_known(setup, from, length) || is_of_tool(setup, from))
		return;
	strbuf_addf(&place, "%s:%ld", entry->loc.file ? entry->loc.file : "", entry->loc.line);
	setup->items = mem_grow(setup->items, &setup->capacity, setup->count + 1, sizeof(*setup->items));
	setup->items[setup->count++] = (struct scan_setup_item){mem_strndup(from, length),
								mem_strndup(strbuf_text(&place), place.length)};
	strbuf_release(&place);
}

void scan_setup_read(struct scan_setup *setup, const struct gcode_config *config, FILE *in, const char *name)
{
	struct gcode_config empty = *config;
	struct diag diag = {.handle = take_element, .context = setup};

	empty.has_setup = true;
	empty.any_tool = NULL;
	empty.tool_count = empty.length_count = empty.radius_count = empty.work_offset_count = 0;
	empty.read.all_faults = true;
	any_machine_read(&empty, in, name, &diag);
}

void scan_setup_add(struct strbuf *out, const struct scan_setup *setup)
{
	for (size_t i = 0; i < setup->count; i++)
		strbuf_addf(out, "%s\t%s\n", setup->items[i].element, setup->items[i].place);
}
