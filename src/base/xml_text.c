#include "base/xml_text.h"

void xml_text_attribute(struct strbuf *out, const char *name, const char *value)
{
	strbuf_addf(out, " %s=\"", name);
	for (; *value; value++) {
		switch (*value) {
		case '&':
			strbuf_addf(out, "&amp;");
			break;
		case '<':
			strbuf_addf(out, "&lt;");
			break;
		case '"':
			strbuf_addf(out, "&quot;");
			break;
		default:
			strbuf_add(out, value, 1);
		}
	}
	strbuf_addf(out, "\"");
}

void xml_text_comment(struct strbuf *out, const char *text)
{
	strbuf_addf(out, "<!-- ");
	for (; *text; text++)
		strbuf_add(out, *text == '-' && text[1] == '-' ? "=" : text, 1);
	strbuf_addf(out, " -->\n");
}
