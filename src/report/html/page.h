/* page.h - an HTML page that is being written: counts its size and numbers its blobs. */
#ifndef FIVECHECK_REPORT_HTML_PAGE_H
#define FIVECHECK_REPORT_HTML_PAGE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "report/format/deflate.h"
#include "report/output.h"

struct page {
	struct output out;
	size_t written;	/* bytes */
	int blobs;	/* that have a number */
};

/* Writes a text and empties it. */
void page_text(struct page *page, struct strbuf *text);

/* The bytes, deflated, as text (seven_bit.h). */
void page_pack(struct strbuf *out, const struct strbuf *bytes, enum deflate_level level);

/* Appends a blob (report_data.h) that is already packed. */
void page_add_blob(struct strbuf *out, int number, const struct strbuf *packed);

/* Writes a packed blob and returns its number. */
int page_blob(struct page *page, const struct strbuf *packed);

#endif
