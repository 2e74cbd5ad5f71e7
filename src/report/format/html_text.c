#include "report/format/html_text.h"

#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"

static const char *entity_of(char c)
{
	switch (c) {
	case '&':
		return "&amp;";
	case '<':
		return "&lt;";
	case '>':
		return "&gt;";
	case '"':
		return "&quot;";
	case '\'':
		return "&#39;";
	default:
		return (unsigned char)c < ' ' || c == 127 ? " " : NULL;
	}
}

void html_text_add(struct strbuf *out, const char *text)
{
	struct strbuf clean = {0};

	if (!text)
		return;
	utf8_add_clean(&clean, text);
	for (const char *c = strbuf_text(&clean); *c; c++) {
		const char *entity = entity_of(*c);

		if (entity)
			strbuf_add(out, entity, strlen(entity));
		else
			strbuf_add(out, c, 1);
	}
	strbuf_release(&clean);
}

void html_text_add_json(struct strbuf *out, const json_t *value)
{
	char *text = json_dumps(value, JSON_COMPACT | JSON_REAL_PRECISION(12));

	for (const char *c = text; *c;) {
		const size_t plain = strcspn(c, "<");

		strbuf_add(out, c, plain);
		c += plain;
		if (*c) {
			strbuf_addf(out, "\\u003c");
			c++;
		}
	}
	free(text);
}
