#include "report/waiver_writer.h"

#include <stdlib.h>
#include <string.h>

#include "base/axes.h"
#include "base/mem.h"
#include "base/xml_text.h"
#include "report/format/format_units.h"

/* The attributes of a waiver, and the number of findings with them. */
struct group {
	char *attributes;	/* owned */
	long times;
};

struct groups {
	struct group *items;
	size_t count, capacity;
};

/* The SHA-256 of the file of that kind, "none" if there is no such file; NULL: it is unknown. */
static const char *digest_of(const struct ndjson_run *run, const char *kind)
{
	const json_t *files = json_object_get(run->header, "files");

	for (size_t i = 0; i < json_array_size(files); i++) {
		const json_t *file = json_array_get(files, i);
		const char *known = ndjson_run_text(file, "kind");

		if (known && !strcmp(known, kind))
			return ndjson_run_text(file, "sha256");
	}
	return "none";
}

/* Control characters become spaces, as in all reports; waivers are compared in that form. */
static void add_plain(struct strbuf *out, const char *name, const char *text)
{
	struct strbuf plain = {0};

	format_units_add_plain(&plain, text ? text : "");
	xml_text_attribute(out, name, strbuf_text(&plain));
	strbuf_release(&plain);
}

static void add_axes(struct strbuf *out, const json_t *axes)
{
	struct strbuf text = {0};
	const char *name;
	json_t *value;

	json_object_foreach ((json_t *)axes, name, value) {
		int slot = slot_of_letter(*name);

		strbuf_addf(&text, "%s%s ", text.length ? ", " : "", name);
		format_units_add(&text, json_number_value(value));
		strbuf_addf(&text, " %s", slot < 0 ? "" : format_units_unit(slot));
	}
	xml_text_attribute(out, "axes", strbuf_text(&text));
	strbuf_release(&text);
}

static char *attributes_of(const char *program, const json_t *finding)
{
	const char *axis = ndjson_run_text(finding, "axis");
	struct strbuf text = {0};

	add_plain(&text, "program", program);
	add_plain(&text, "kind", ndjson_run_text(finding, "kind"));
	if (axis) {
		add_plain(&text, "axis", axis);
	} else {
		add_plain(&text, "a", ndjson_run_text(finding, "a"));
		add_plain(&text, "b", ndjson_run_text(finding, "b"));
	}
	add_plain(&text, "block", ndjson_run_text(finding, "block"));
	strbuf_addf(&text, "\n   ");
	add_axes(&text, json_object_get(finding, "axes"));
	return text.text;
}

static void add_group(struct groups *groups, char *attributes)
{
	for (size_t i = 0; i < groups->count; i++) {
		if (!strcmp(groups->items[i].attributes, attributes)) {
			groups->items[i].times++;
			free(attributes);
			return;
		}
	}
	groups->items = mem_grow(groups->items, &groups->capacity, groups->count + 1, sizeof(*groups->items));
	groups->items[groups->count++] = (struct group){attributes, 1};
}

/* The line with the name of a program follows its findings. */
static const char *program_after(const struct ndjson_run *run, size_t i)
{
	while (!ndjson_run_is_program(run->lines[i]))
		i++;
	return ndjson_run_text(run->lines[i], "file");
}

static long collect(struct groups *groups, const struct ndjson_run *run)
{
	long findings = 0;

	for (size_t i = 0; i < run->count; i++) {
		const json_t *line = run->lines[i];

		if (ndjson_run_is_program(line) || json_object_get(line, "accepted"))
			continue;
		add_group(groups, attributes_of(program_after(run, i), line));
		findings++;
	}
	return findings;
}

long waiver_writer_add(struct strbuf *out, const struct ndjson_run *run, const char *reason, const char *expires,
		       struct diag *diag)
{
	const char *machine = digest_of(run, "machine"), *setup = digest_of(run, "setup");
	struct groups groups = {0};
	long findings;

	if (!machine || !setup || !strcmp(machine, "none")) {
		diag_error(
		    diag, (struct srcloc){run->path, 1, 0},
		    "the digest of the machine or of the setup is missing: run the check again with regular files");
		return -1;
	}
	findings = collect(&groups, run);
	strbuf_addf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<waivers version=\"1\"");
	xml_text_attribute(out, "machine_sha256", machine);
	strbuf_addf(out, "\n ");
	xml_text_attribute(out, "setup_sha256", setup);
	strbuf_addf(out, ">\n");
	for (size_t i = 0; i < groups.count; i++) {
		strbuf_addf(out, "  <waiver%s", groups.items[i].attributes);
		if (groups.items[i].times > 1)
			strbuf_addf(out, " times=\"%ld\"", groups.items[i].times);
		strbuf_addf(out, "\n   ");
		add_plain(out, "reason", reason);
		xml_text_attribute(out, "expires", expires);
		strbuf_addf(out, "/>\n");
		free(groups.items[i].attributes);
	}
	strbuf_addf(out, "</waivers>\n");
	free(groups.items);
	return findings;
}
