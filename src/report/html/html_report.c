#include "report/html/html_report.h"

#include <string.h>

#include "report/format/html_text.h"
#include "report/html/page.h"
#include "report/html/plain_html.h"
#include "report/html/report_head.h"
#include "report/html/report_levels.h"
#include "report/html/viewer.h"

/* The text of a value, packed. */
static void pack_json(struct strbuf *out, const json_t *value)
{
	struct strbuf text = {0};

	html_text_add_json(&text, value);
	page_pack(out, &text, DEFLATE_SMALL);
	strbuf_release(&text);
}

/* The most bytes that the head will need in addition: the description of a chunk has about this length, packed. */
static size_t length_of_head(const json_t *head, const struct recorder *recorder)
{
	enum { CHUNK_BYTES = 30 };
	struct strbuf text = {0};
	size_t length;

	pack_json(&text, head);
	length = text.length + CHUNK_BYTES * (recorder->path.chunk_count + recorder->clearance.chunk_count);
	strbuf_release(&text);
	return length;
}

static void add_scripts(struct strbuf *out, const struct strbuf *viewer)
{
	const struct viewer_file boot = viewer_boot_script();

	strbuf_addf(out, "<script type=\"text/plain\" id=\"fivecheck-viewer\">");
	strbuf_add(out, strbuf_text(viewer), viewer->length);
	strbuf_addf(out, "</script>\n<script>");
	strbuf_add(out, boot.bytes, boot.count);
	strbuf_addf(out, "</script>\n</body>\n</html>\n");
}

static bool write_page(struct page *page, const struct html_contents *report)
{
	const struct viewer_file script = viewer_script();
	struct strbuf text = {0}, viewer = {0}, source = {0};
	json_t *head = report_head_json(report);
	bool good;

	strbuf_add(&source, script.bytes, script.count);
	page_pack(&viewer, &source, DEFLATE_SMALL);
	plain_html_add_head(&text, report->program->name, true);
	plain_html_add_main(&text, report);
	page_text(page, &text);
	page->written += report->scene->meshes.length;
	output_write(&page->out, strbuf_text(&report->scene->meshes), report->scene->meshes.length);
	page->blobs = report->scene->blobs;
	stock_pack_write(report->stock, page, head);
	good = report_levels_write(page, report, head, viewer.length + length_of_head(head, report->recorder));
	strbuf_addf(&text, "<script type=\"text/plain\" id=\"fivecheck-head\">");
	pack_json(&text, head);
	strbuf_addf(&text, "</script>\n");
	add_scripts(&text, &viewer);
	page_text(page, &text);
	json_decref(head);
	strbuf_release(&source);
	strbuf_release(&viewer);
	strbuf_release(&text);
	return good;
}

bool html_report_write(const struct html_contents *report, const char *path, struct diag *diag)
{
	struct page page = {0};
	int error = report->recorder->path.error ? report->recorder->path.error : report->recorder->clearance.error;

	if (!error && !output_open(&page.out, path, diag))
		return false;
	if (!error && write_page(&page, report))
		return output_commit(&page.out, diag);
	output_discard(&page.out);
	error = report->recorder->path.error ? report->recorder->path.error : report->recorder->clearance.error;
	diag_error(diag, (struct srcloc){0}, "cannot write %s: its temporary file: %s", path, strerror(error));
	return false;
}
