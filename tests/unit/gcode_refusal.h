/* gcode_refusal.h - programs that must be refused, and what is said about them. Each function releases its case. */
#ifndef GCODE_REFUSAL_H
#define GCODE_REFUSAL_H

#include <stdarg.h>

#include "gcode_case.h"

/* These words stand somewhere in the messages about a program that printf would make. */
__attribute__((format(printf, 3, 4))) static inline void case_refuses(struct gcode_case *c, const char *words,
								       const char *format, ...)
{
	struct strbuf program = {0};
	va_list args;

	va_start(args, format);
	strbuf_addv(&program, format, args);
	va_end(args);
	ck_assert_msg(!case_run(c, strbuf_text(&program)), "accepted: %s", strbuf_text(&program));
	ck_assert_msg(strstr(strbuf_text(&c->messages), words), "%s%s", strbuf_text(&program), strbuf_text(&c->messages));
	strbuf_release(&program);
	case_release(c);
}

/* This is the only message; the line and a caret below the column follow it. Column 0: it is about the line as a whole. */
static inline void case_refuses_at(struct gcode_case *c, const char *program, int line, int column, const char *message)
{
	struct strbuf expected = {0};
	const char *text = program;

	ck_assert_msg(!case_run(c, program), "accepted: %s", program);
	for (int i = 1; i < line; i++)
		text = strchr(text, '\n') + 1;
	if (column)
		strbuf_addf(&expected, "p.nc:%d:%d: error: %s\n    %.*s\n    %*s\n", line, column, message,
			    (int)strcspn(text, "\r\n"), text, column, "^");
	else
		strbuf_addf(&expected, "p.nc:%d: error: %s\n", line, message);
	ck_assert_str_eq(strbuf_text(&c->messages), strbuf_text(&expected));
	strbuf_release(&expected);
	case_release(c);
}

/* The same in the last line of a program that printf would make. */
__attribute__((format(printf, 4, 5))) static inline void case_refuses_last(struct gcode_case *c, int column,
									     const char *message, const char *format, ...)
{
	struct strbuf program = {0};
	va_list args;
	int line = 0;

	va_start(args, format);
	strbuf_addv(&program, format, args);
	va_end(args);
	for (const char *p = strbuf_text(&program); *p; p++)
		line += *p == '\n';
	case_refuses_at(c, strbuf_text(&program), line, column, message);
	strbuf_release(&program);
}

#endif
