#include "report/html/index_page.h"

#include "report/format/html_text.h"
#include "report/html/plain_html.h"
#include "report/output.h"

bool index_page_write(const char *path, const struct index_page_row *rows, size_t count, struct diag *diag)
{
	struct strbuf text = {0};
	struct output out;
	bool good = output_open(&out, path, diag);

	plain_html_add_head(&text, "fivecheck", false);
	strbuf_addf(&text, "<main id=\"plain\">\n<h1>fivecheck: %zu programs</h1>\n<table>\n"
			   "<tr><th>Program</th><th>Verdict</th><th></th></tr>\n", count);
	for (size_t i = 0; i < count; i++) {
		strbuf_addf(&text, "<tr class=\"%s\"><td>", rows[i].word);
		if (rows[i].link)
			strbuf_addf(&text, "<a href=\"%s\">", rows[i].link);
		html_text_add(&text, rows[i].program);
		strbuf_addf(&text, "%s</td><td>%s</td><td>", rows[i].link ? "</a>" : "", rows[i].word);
		html_text_add(&text, rows[i].sentence);
		strbuf_addf(&text, "</td></tr>\n");
	}
	strbuf_addf(&text, "</table>\n</main>\n</body>\n</html>\n");
	if (good) {
		output_text(&out, &text);
		good = output_commit(&out, diag);
	}
	strbuf_release(&text);
	return good;
}
