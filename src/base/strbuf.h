/* strbuf.h - a string that grows. */
#ifndef FIVECHECK_BASE_STRBUF_H
#define FIVECHECK_BASE_STRBUF_H

#include <stdarg.h>
#include <stddef.h>

/* All zero is the empty string. `text` is NULL or ends in a NUL that is not counted. */
struct strbuf {
	char *text;
	size_t length;
	size_t capacity;
};

void strbuf_add(struct strbuf *buf, const char *bytes, size_t count);

/* Makes the string longer by this number of bytes, which the caller fills in at the result; none may be a NUL. */
char *strbuf_extend(struct strbuf *buf, size_t count);

void strbuf_addf(struct strbuf *buf, const char *format, ...) __attribute__((format(printf, 2, 3)));
void strbuf_addv(struct strbuf *buf, const char *format, va_list args) __attribute__((format(printf, 2, 0)));

/*
 * The bytes of the control character at the start of the text (C0, DEL, C1 in UTF-8); 0: it begins with something else.
 */
size_t strbuf_control_bytes(const char *text);

/* Adds one line of foreign text, such as the name of a file: control characters become question marks. */
void strbuf_add_visible(struct strbuf *buf, const char *text);

/* Empties the string and keeps its storage. */
void strbuf_clear(struct strbuf *buf);
void strbuf_release(struct strbuf *buf);

/* Never NULL. */
const char *strbuf_text(const struct strbuf *buf);

#endif
