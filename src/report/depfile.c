#include "report/depfile.h"

#include <string.h>

bool depfile_add_name(struct strbuf *out, const char *name, bool target, struct diag *diag)
{
	size_t backslashes = 0;

	if (strpbrk(name, "\r\n")) {
		diag_error(diag, (struct srcloc){0},
			   "--depfile: a makefile cannot contain a file name with a line break");
		return false;
	}
	if (out->length && !strchr(" \n", out->text[out->length - 1]))
		strbuf_add(out, " ", 1);
	for (const char *c = name; *c; c++) {
		bool quoted = strchr(" \t#:*?[]", *c) || (target && *c == '%');

		/* Backslashes must be doubled directly before an escaped character, and only there. */
		for (size_t i = 0; quoted && i < backslashes; i++)
			strbuf_add(out, "\\", 1);
		backslashes = *c == '\\' ? backslashes + 1 : 0;
		if (quoted)
			strbuf_add(out, "\\", 1);
		if (*c == '$')
			strbuf_add(out, "$", 1);
		strbuf_add(out, c, 1);
	}
	return true;
}
