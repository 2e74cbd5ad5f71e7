/* sinumerik_refused.h - for tests of programs of the sinumerik dialect that are refused. */
#ifndef SINUMERIK_REFUSED_H
#define SINUMERIK_REFUSED_H

#include "gcode_refusal.h"
#include "sinumerik_case.h"

struct refused_program {
	const char *program;
	int line, column;	/* column 0: the line as a whole */
	const char *message;
};

/* The message is the only one, and the caret stands below the column of the line that it names. */
static inline void sinumerik_refuses(const struct refused_program *bad)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	case_refuses_at(&c, bad->program, bad->line, bad->column, bad->message);
}

/* A program, and its first message without the place. */
struct refused_words {
	const char *program, *message;
};

static inline void sinumerik_refuses_words(const struct refused_words *bad)
{
	struct strbuf words = {0};
	struct gcode_case c;

	sinumerik_case_init(&c);
	strbuf_addf(&words, ": error: %s\n", bad->message);
	case_refuses(&c, strbuf_text(&words), "%s", bad->program);
	strbuf_release(&words);
}

#endif
