#include "report/html/page.h"

#include "report/format/seven_bit.h"

void page_text(struct page *page, struct strbuf *text)
{
	page->written += text->length;
	output_text(&page->out, text);
}

void page_pack(struct strbuf *out, const struct strbuf *bytes, enum deflate_level level)
{
	struct strbuf small = {0};

	deflate_add(&small, strbuf_text(bytes), bytes->length, level);
	seven_bit_add(out, strbuf_text(&small), small.length);
	strbuf_release(&small);
}

void page_add_blob(struct strbuf *out, int number, const struct strbuf *packed)
{
	strbuf_addf(out, "<script type=\"text/plain\" id=\"blob-%d\">", number);
	strbuf_add(out, strbuf_text(packed), packed->length);
	strbuf_addf(out, "</script>\n");
}

int page_blob(struct page *page, const struct strbuf *packed)
{
	struct strbuf text = {0};

	page_add_blob(&text, page->blobs, packed);
	page_text(page, &text);
	strbuf_release(&text);
	return page->blobs++;
}
