/* fuzz.h - what the fuzzers share: diagnostics that are only formatted, and input as a file of its own. */
#ifndef FIVECHECK_TESTS_FUZZ_H
#define FIVECHECK_TESTS_FUZZ_H

#include <fcntl.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/diag.h"
#include "base/strbuf.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Every message has one line of printable text, or nothing that reads it can be trusted. */
static inline void fuzz_note(void *context, const struct diag_entry *entry)
{
	struct strbuf text = {0};

	(void)context;
	if (strchr(entry->text, '\n') || !*entry->text)
		abort();
	diag_format(&text, entry);
	strbuf_release(&text);
}

/* The same file for every input of this process. */
static inline const char *fuzz_file(const uint8_t *data, size_t size)
{
	static char path[64];
	int fd;

	if (!*path)
		snprintf(path, sizeof(path), "/tmp/fivecheck-fuzz-%ld", (long)getpid());
	fd = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
	if (fd < 0 || write(fd, data, size) != (ssize_t)size || close(fd))
		abort();
	return path;
}

#endif
