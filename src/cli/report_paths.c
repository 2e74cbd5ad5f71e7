#include "cli/report_paths.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "report/output.h"

static bool may_stand_in_name(char c)
{
	return ascii_is_letter(c) || ascii_is_digit(c) || c == '_' || c == '-';
}

void report_paths_add_stem(struct strbuf *out, const char *program)
{
	const char *slash = strrchr(program, '/'), *base = slash ? slash + 1 : program, *dot = strrchr(base, '.');
	const size_t length = dot && dot > base ? (size_t)(dot - base) : strlen(base);

	for (size_t i = 0; i < length; i++)
		strbuf_addf(out, "%c", may_stand_in_name(base[i]) ? base[i] : '_');
}

void report_paths_add(struct strbuf *out, const char *path, const char *name)
{
	const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');

	if (!*name) {
		strbuf_addf(out, "%s", path);
		return;
	}
	strbuf_add(out, path, dot ? (size_t)(dot - path) : strlen(path));
	strbuf_addf(out, "-%s%s", name, dot ? dot : "");
}

bool report_paths_can_write(const char *path, struct diag *diag)
{
	struct stat status;
	struct output out;

	/* A pipe may be opened only once. */
	if (!path || (!stat(path, &status) && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)))
		return true;
	if (!output_open(&out, path, diag))
		return false;
	output_discard(&out);
	return true;
}

/* Is there a file that is not a report, picture or scene? It might be a subprogram that is not known yet. */
static bool holds_other(const char *path)
{
	static const char *const marks[] = {"<!doctype html>", "<svg ", "\x89PNG", "glTF"};
	struct stat status;
	char begin[16] = "";
	size_t count;
	FILE *file;

	if (stat(path, &status) || !S_ISREG(status.st_mode) || !status.st_size)
		return false;
	file = fopen(path, "rb");
	if (!file && errno == ENOMEM)
		mem_exhausted();
	if (!file)
		return false;
	count = fread(begin, 1, sizeof(begin) - 1, file);
	fclose(file);
	for (size_t i = 0; i < sizeof(marks) / sizeof(*marks); i++) {
		if (count >= strlen(marks[i]) && !memcmp(begin, marks[i], strlen(marks[i])))
			return false;
	}
	return true;
}

bool report_paths_may_replace(const char *option, const char *path, struct diag *diag)
{
	if (!holds_other(path))
		return true;
	diag_error(diag, (struct srcloc){0},
		   "--%s would overwrite %s, which is not a report or picture; remove it, or choose another name",
		   option,
		   path);
	return false;
}
