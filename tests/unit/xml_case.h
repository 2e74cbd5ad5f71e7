/* xml_case.h - for tests of the readers: files in a folder of their own, and the messages about them. */
#ifndef FIVECHECK_TESTS_XML_CASE_H
#define FIVECHECK_TESTS_XML_CASE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "suite.h"

/* A faulty file: its content and all of its messages. */
struct xml_case {
	const char *content;
	const char *messages;
};

struct messages {
	struct diag diag;
	struct strbuf text;
};

static char folder[64];

/* Without columns and excerpts, which test_xml_place checks. */
static inline void keep_message(void *context, const struct diag_entry *entry)
{
	struct diag_entry line = *entry;

	line.loc.column = 0;
	line.excerpt = NULL;
	diag_format(context, &line);
}

static inline void messages_init(struct messages *messages)
{
	messages->text = (struct strbuf){0};
	messages->diag = (struct diag){.handle = keep_message, .context = &messages->text};
}

static inline void write_bytes(const char *path, const char *bytes, size_t count)
{
	FILE *file = fopen(path, "wb");

	ck_assert_ptr_nonnull(file);
	ck_assert_uint_eq(fwrite(bytes, 1, count, file), count);
	ck_assert_int_eq(fclose(file), 0);
}

static inline void write_text(const char *path, const char *text)
{
	write_bytes(path, text, strlen(text));
}

/* Fixtures of a test case: every test runs in an empty folder. */
static inline void enter_folder(void)
{
	snprintf(folder, sizeof(folder), "/tmp/fivecheck-test-XXXXXX");
	ck_assert_ptr_nonnull(mkdtemp(folder));
	ck_assert_int_eq(chdir(folder), 0);
}

static inline void leave_folder(void)
{
	static const char *const names[] = {"m.xml", "s.xml", "sub/m.xml", "fifo"};

	for (size_t i = 0; i < COUNT(names); i++)
		unlink(names[i]);
	rmdir("sub");
	ck_assert_int_eq(chdir("/"), 0);
	ck_assert_int_eq(rmdir(folder), 0);
}

#endif
