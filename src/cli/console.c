#include "cli/console.h"

#include "report/quantity.h"

#include <math.h>
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

void console_expect(struct console *console, size_t programs)
{
	console->programs = programs;
	console->done = 0;
	console->started = console->shown = console_seconds();
}

/* "12 of 40 programs, 3.1/s, 9 s left" */
static void add_run(struct strbuf *out, const struct console *console)
{
	double spent = console_seconds() - console->started;
	double rate = spent > 0 ? (double)console->done / spent : 0;

	strbuf_addf(out, "%zu of %zu programs", console->done, console->programs);
	if (!console->done || !(rate > 0))
		return;
	strbuf_addf(out, rate < 1 ? ", %.3f/s" : ", %.1f/s", rate);
	if (console->done < console->programs) {
		strbuf_addf(out, ", ");
		quantity_add_duration(out, ceil((double)(console->programs - console->done) / rate));
		strbuf_addf(out, " left");
	}
}

enum { BAR_WIDTH = 20 };

static void add_bar(struct strbuf *out, const struct console *console)
{
	size_t full = console->programs ? console->done * BAR_WIDTH / console->programs : 0;

	strbuf_addf(out, "[");
	for (size_t i = 0; i < BAR_WIDTH; i++)
		strbuf_addf(out, i < full ? "#" : " ");
	strbuf_addf(out, "] ");
}

/* file NULL: nothing is known of a single one */
static void show(struct console *console, const char *file, long lines)
{
	bool plain = console->kind == PROGRESS_PLAIN;
	struct strbuf text = {0};

	if (console->programs > 1) {
		if (!plain)
			add_bar(&text, console);
		add_run(&text, console);
		strbuf_addf(&text, file ? "; " : "");
	}
	if (file)
		strbuf_addf(&text, "%s: line %ld", file, lines);
	fprintf(stderr, plain ? "fivecheck: %s\n" : "\r%s\033[K", strbuf_text(&text));
	fflush(stderr);
	strbuf_release(&text);
	console->shown = console_seconds();
	console->progress = !plain;
}

static bool is_wanted(const struct console *console)
{
	return !console->quiet &&
	       (console->kind == PROGRESS_PLAIN || (console->kind == PROGRESS_AUTO && console->terminal));
}

static bool is_due(const struct console *console)
{
	double since = console_seconds() - console->shown;

	return console->kind == PROGRESS_PLAIN ? since >= 10 : !console->progress || since >= 0.2;
}

void console_progress(struct console *console, const char *file, long lines)
{
	if (is_wanted(console) && is_due(console))
		show(console, file, lines);
}

void console_done(struct console *console)
{
	console->done++;
	if (console->programs > 1 && is_wanted(console) && is_due(console))
		show(console, NULL, 0);
}

void console_finish(struct console *console)
{
	console_clear(console);
	/* The last of the plain lines stays as a total. */
	if (console->kind == PROGRESS_PLAIN && is_wanted(console) && console->programs > 1)
		show(console, NULL, 0);
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
