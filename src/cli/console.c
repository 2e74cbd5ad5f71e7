#include "cli/console.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* The first " error:" and the like in bold colour; `text` is as diag_format made it. */
static void add_coloured(struct strbuf *out, const char *text, enum diag_severity severity)
{
	static const char *const words[] = {" note:", " warning:", " error:"};
	static const char *const colours[] = {"\033[1;36m", "\033[1;35m", "\033[1;31m"};
	const char *at = strstr(text, words[severity]);
	size_t length = strlen(words[severity]);

	if (!at) {
		strbuf_addf(out, "%s", text);
		return;
	}
	strbuf_add(out, text, (size_t)(at - text));
	strbuf_addf(out, "%s%.*s\033[0m%s", colours[severity], (int)length, at, at + length);
}

static void print_entry(void *context, const struct diag_entry *entry)
{
	struct console *console = context;
	struct strbuf text = {0}, line = {0};

	if (console->quiet && entry->severity != DIAG_ERROR)
		return;
	console_clear(console);
	diag_format(&text, entry);
	if (console->colour)
		add_coloured(&line, strbuf_text(&text), entry->severity);
	else
		strbuf_add(&line, strbuf_text(&text), text.length);
	fwrite(line.text, 1, line.length, stderr);
	strbuf_release(&text);
	strbuf_release(&line);
}

bool console_wants_colour(int fd)
{
	const char *never = getenv("NO_COLOR"), *term = getenv("TERM");

	return isatty(fd) && !(never && *never) && term && strcmp(term, "dumb") != 0;
}

void console_init(struct console *console)
{
	*console = (struct console){
		.diag = {.handle = print_entry, .context = console},
		.colour = console_wants_colour(STDERR_FILENO),
		.terminal = isatty(STDERR_FILENO),
	};
}

void console_progress(struct console *console, const char *file, long lines)
{
	double now;

	if (!console->terminal || console->quiet)
		return;
	now = console_seconds();
	if (console->progress && now - console->shown < 0.2)
		return;
	console->progress = true;
	console->shown = now;
	fprintf(stderr, "\r%s: line %ld\033[K", file, lines);
	fflush(stderr);
}

void console_clear(struct console *console)
{
	if (!console->progress)
		return;
	fputs("\r\033[K", stderr);
	console->progress = false;
}

double console_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
