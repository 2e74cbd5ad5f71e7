#include "report/format/base64.h"

#include <stdint.h>

static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/* The code of one to three bytes. */
static void add_group(struct strbuf *out, const unsigned char *bytes, size_t count)
{
	char code[4] = {'=', '=', '=', '='};
	uint32_t bits = 0;

	for (size_t i = 0; i < 3; i++)
		bits = bits << 8 | (i < count ? bytes[i] : 0);
	for (size_t i = 0; i <= count; i++)
		code[i] = digits[bits >> (18 - 6 * i) & 63];
	strbuf_add(out, code, sizeof(code));
}

void base64_add(struct strbuf *out, const unsigned char *bytes, size_t count)
{
	for (size_t i = 0; i < count; i += 3)
		add_group(out, bytes + i, count - i < 3 ? count - i : 3);
}
