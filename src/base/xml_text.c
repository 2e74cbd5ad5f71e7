#include "base/xml_text.h"

#include "base/utf8.h"

/*
 * Appends the character at `text`, or a replacement for a character that XML does not permit; returns its bytes in
 * `text`.
 */
static size_t add_character(struct strbuf *out, const char *text)
{
	size_t control = strbuf_control_bytes(text), length = utf8_length(text);

	if (control && *text != '\t' && *text != '\n' && *text != '\r')
		strbuf_addf(out, "?");
	else if (length)
		strbuf_add(out, text, length);
	else
		strbuf_addf(out, "\xef\xbf\xbd");
	return length ? length : 1;
}

void xml_text_attribute(struct strbuf *out, const char *name, const char *value)
{
	strbuf_addf(out, " %s=\"", name);
	while (*value) {
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
			value += add_character(out, value);
			continue;
		}
		value++;
	}
	strbuf_addf(out, "\"");
}

void xml_text_comment(struct strbuf *out, const char *text)
{
	strbuf_addf(out, "<!-- ");
	while (*text) {
		if (*text == '-' && text[1] == '-') {
			strbuf_addf(out, "=");
			text++;
		} else {
			text += add_character(out, text);
		}
	}
	strbuf_addf(out, " -->\n");
}
