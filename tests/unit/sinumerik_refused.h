/* sinumerik_refused.h - for tests of programs of the sinumerik dialect that are refused. */
#ifndef SINUMERIK_REFUSED_H
#define SINUMERIK_REFUSED_H

#include "sinumerik_case.h"

struct refused_program {
	const char *program;
	int line, column;	/* column 0: the line as a whole */
	const char *message;
};

/* The message is the only one, and the caret stands below the column of the line that it names. */
static inline void sinumerik_refuses(const struct refused_program *bad)
{
	struct strbuf expected = {0};
	const char *line = bad->program;
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(!case_run(&c, bad->program), "accepted: %s", bad->program);
	for (int i = 1; i < bad->line; i++)
		line = strchr(line, '\n') + 1;
	if (bad->column)
		strbuf_addf(&expected, "p.nc:%d:%d: error: %s\n    %.*s\n    %*s\n", bad->line, bad->column, bad->message,
			    (int)strcspn(line, "\n"), line, bad->column, "^");
	else
		strbuf_addf(&expected, "p.nc:%d: error: %s\n", bad->line, bad->message);
	ck_assert_str_eq(strbuf_text(&c.messages), strbuf_text(&expected));
	strbuf_release(&expected);
	case_release(&c);
}

#endif
