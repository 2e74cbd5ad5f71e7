#include "machine/library/vericut_text.h"

#include <string.h>

#include "base/ascii.h"
#include "base/has_ending.h"

/* The first lines of a file give its version. */
#define HEAD_MAX 4096

static const struct {
	const char *end, *what;
} kinds[] = {
	{".mch", "a machine"}, {".vcproject", "a project"}, {".usr", "a job (user file)"},
	{".tls", "a tool library"}, {".ctl", "a control"},
};

/*
 * XML and JSON begin differently, and files of other programs have some of these names. Text has no control characters.
 */
static bool is_plain_text(const char *text)
{
	const char *start = text + strspn(text, " \t\r\n\xef\xbb\xbf");

	if (!*start || strchr("<{[", *start))
		return false;
	for (const char *at = text; *at && at - text < HEAD_MAX; at++)
		if (((unsigned char)*at < ' ' && !strchr("\t\r\n\f\x1a", *at)) || (unsigned char)*at >= 0xfe)
			return false;
	return true;
}

/* The digits and dots after the word "version" in the first lines; *length is 0 if there are none. */
static const char *version_of(const char *text, size_t *length)
{
	static const char word[] = "version";

	*length = 0;
	for (const char *at = text; *at && at - text < HEAD_MAX && !*length; at++) {
		const char *number;

		if (!ascii_same_start(at, word, sizeof(word) - 1))
			continue;
		number = at + sizeof(word) - 1;
		number += strspn(number, " \t:=-_\"");
		*length = strspn(number, "0123456789.");
		text = *length ? number : text;
	}
	return text;
}

bool vericut_text_refuse(const char *path, const char *text, struct diag *diag)
{
	size_t length;
	const char *version;

	if (!is_plain_text(text))
		return false;
	for (size_t i = 0; i < sizeof(kinds) / sizeof(*kinds); i++) {
		if (!has_ending(path, kinds[i].end))
			continue;
		version = version_of(text, &length);
		diag_error(diag, (struct srcloc){.file = path},
			   "this is %s of VERICUT in text form, %s%.*s, a format that is not published and cannot be "
			   "read. Open it in VERICUT 7 or later and save it under a new name: it is then XML, which "
			   "can be imported",
			   kinds[i].what, length ? "of version " : "of version 6 or before",
			   (int)(length < 20 ? length : 20), version);
		return true;
	}
	return false;
}
