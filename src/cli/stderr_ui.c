#include "cli/stderr_ui.h"

#include "report/format/format_units.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

/* Colours the first " note:", " warning:" or " error:" of a text that diag_format made. */
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

/* With --quiet: is it an error, or a note that follows an error directly and does not concern a file as a whole? */
static bool is_kept(struct stderr_ui *ui, const struct diag_entry *entry)
{
	bool of_file = entry->loc.file && !entry->loc.line;

	ui->after_error = entry->severity == DIAG_ERROR ||
			  (ui->after_error && entry->severity == DIAG_NOTE && !of_file);
	return ui->after_error;
}

static void print_entry(void *context, const struct diag_entry *entry)
{
	struct stderr_ui *ui = context;
	struct strbuf text = {0}, line = {0};

	if (ui->quiet && !is_kept(ui, entry))
		return;
	stderr_ui_clear(ui);
	diag_format(&text, entry);
	if (ui->colour)
		add_coloured(&line, strbuf_text(&text), entry->severity);
	else
		strbuf_add(&line, strbuf_text(&text), text.length);
	fwrite(line.text, 1, line.length, stderr);
	strbuf_release(&text);
	strbuf_release(&line);
}

/* Is it a terminal that supports control sequences? A host without terminals (src/wasi) needs none of this. */
static bool takes_escapes(int fd)
{
	const char *term;

	if (!isatty(fd))
		return false;
	term = getenv("TERM");
	return term && strcmp(term, "dumb") != 0;
}

bool stderr_ui_wants_colour(int fd, enum color_choice choice)
{
	const char *never = getenv("NO_COLOR");

	if (choice != COLOR_AUTO)
		return choice == COLOR_ALWAYS;
	return takes_escapes(fd) && !(never && *never);
}

void stderr_ui_init(struct stderr_ui *ui)
{
	*ui = (struct stderr_ui){
		.diag = {.handle = print_entry, .context = ui},
		.colour = stderr_ui_wants_colour(STDERR_FILENO, COLOR_AUTO),
		.terminal = isatty(STDERR_FILENO),
		.renews = takes_escapes(STDERR_FILENO),
	};
}

void stderr_ui_expect(struct stderr_ui *ui, size_t programs)
{
	ui->programs = programs;
	ui->done = 0;
	ui->started = ui->shown = stderr_ui_seconds();
}

enum { BAR_WIDTH = 20, WIDTH_DEFAULT = 80 };

/* The content of the progress line. */
struct progress {
	const char *file;	/* the program that is being read; NULL: unknown */
	long lines;
	double share;	/* of the run; 0: unknown */
	double spent;	/* s */
};

/* "1 h 02 min", "12 s": an estimate has no decimals. */
static void add_estimate(struct strbuf *out, double seconds)
{
	double whole = ceil(seconds), minutes = floor(whole / 60);

	if (whole < 60)
		strbuf_addf(out, "%.0f s", whole);
	else if (minutes < 60)
		strbuf_addf(out, "%.0f min %02.0f s", minutes, whole - 60 * minutes);
	else
		strbuf_addf(out, "%.0f h %02.0f min", floor(minutes / 60), fmod(minutes, 60));
}

static bool begins_character(char byte)
{
	return ((unsigned char)byte & 0xc0) != 0x80;
}

/* A character of UTF-8 counts as one column. */
static size_t columns_of(const char *text)
{
	size_t columns = 0;

	for (; *text; text++)
		columns += begins_character(*text);
	return columns;
}

/* The number of bytes of the text that fit into the columns; no character is divided. */
static int cut(const char *text, size_t columns)
{
	size_t length = 0;

	for (; text[length]; length++) {
		if (begins_character(text[length]) && !columns--)
			break;
	}
	return (int)length;
}

/* The name; a longer one without its first characters. */
static void add_name(struct strbuf *out, const char *file, size_t columns)
{
	struct strbuf name = {0};
	size_t have;

	format_units_add_plain(&name, file);
	have = columns_of(strbuf_text(&name));
	if (have > columns)
		strbuf_addf(out, "...%s", strbuf_text(&name) + cut(strbuf_text(&name), have - columns + strlen("...")));
	else
		strbuf_addf(out, "%s", strbuf_text(&name));
	strbuf_release(&name);
}

/*
 * "12 of 40 programs, 3.1/s, 9 s left; part.nc: line 4711"; with one program "part.nc: line 4711, 52000 lines/s".
 * `columns`: those for the name.
 */
static void add_run(struct strbuf *out, const struct stderr_ui *ui, const struct progress *now, size_t columns)
{
	bool several = ui->programs > 1;
	double rate = now->spent > 0 ? (double)(several ? (long)ui->done : now->lines) / now->spent : 0;

	if (several)
		strbuf_addf(out, "%zu of %zu programs", ui->done, ui->programs);
	else
		add_name(out, now->file ? now->file : "", columns);
	if (!several)
		strbuf_addf(out, ": line %ld", now->lines);
	if (rate > 0)
		strbuf_addf(out, several && rate < 1 ? ", %.3f%s" : several ? ", %.1f%s" : ", %.0f%s", rate,
			    several ? "/s" : " lines/s");
	if (now->share > 0 && now->share < 1) {
		strbuf_addf(out, ", ");
		add_estimate(out, now->spent * (1 - now->share) / now->share);
		strbuf_addf(out, " left");
	}
	if (several && now->file && now->lines) {
		strbuf_addf(out, "; ");
		add_name(out, now->file, columns);
		strbuf_addf(out, ": line %ld", now->lines);
	}
}

static void add_bar(struct strbuf *out, double share)
{
	int full = (int)(share * BAR_WIDTH);

	strbuf_addf(out, "[");
	for (int i = 0; i < BAR_WIDTH; i++)
		strbuf_addf(out, i < full ? "#" : " ");
	strbuf_addf(out, "] ");
}

/* Columns of the terminal minus one: a line that fills the last column wraps and cannot be erased. */
static size_t width(void)
{
	struct winsize size;

	if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) || size.ws_col < 2)
		return WIDTH_DEFAULT - 1;
	return (size_t)size.ws_col - 1;
}

/* With fewer columns there is no bar. A name is not made shorter than NAME_LEAST. */
enum { BAR_LEAST = 72, NAME_LEAST = 12 };

/* A line that fits into the columns, if necessary with a shorter name. */
static void add_line(struct strbuf *out, const struct stderr_ui *ui, const struct progress *now, bool bar)
{
	const size_t room = width();
	struct strbuf whole = {0};
	size_t columns, name = now->file ? columns_of(now->file) : 0;

	if (bar && room >= BAR_LEAST)
		add_bar(out, now->share);
	add_run(&whole, ui, now, SIZE_MAX);
	columns = columns_of(strbuf_text(out)) + columns_of(strbuf_text(&whole));
	if (columns > room)
		name = columns - room + NAME_LEAST < name ? name - (columns - room) : NAME_LEAST;
	add_run(out, ui, now, name);
	strbuf_release(&whole);
}

/* Are whole lines printed, instead of one that is renewed? */
static bool is_plain(const struct stderr_ui *ui)
{
	return ui->kind == PROGRESS_PLAIN || !ui->renews;
}

static void show(struct stderr_ui *ui, const char *file, long lines, double share)
{
	double done = (double)ui->done + fmax(share, 0);
	struct progress now = {file, lines, done / (double)ui->programs, stderr_ui_seconds() - ui->started};
	struct strbuf text = {0};

	if (is_plain(ui)) {
		add_run(&text, ui, &now, SIZE_MAX);
		fprintf(stderr, "fivecheck: %s\n", strbuf_text(&text));
	} else {
		add_line(&text, ui, &now, ui->programs > 1 || share >= 0);
		fprintf(stderr, "\r%.*s\033[K", cut(strbuf_text(&text), width()), strbuf_text(&text));
	}
	fflush(stderr);
	strbuf_release(&text);
	ui->shown = stderr_ui_seconds();
	ui->progress = !is_plain(ui);
}

static bool is_wanted(const struct stderr_ui *ui)
{
	return !ui->quiet &&
	       (ui->kind == PROGRESS_PLAIN || (ui->kind == PROGRESS_AUTO && ui->terminal));
}

/* Progress immediately after other output would flicker, and a short run needs none. */
static bool is_due(const struct stderr_ui *ui)
{
	return stderr_ui_seconds() - ui->shown >= (is_plain(ui) ? 10 : 0.2);
}

void stderr_ui_progress(struct stderr_ui *ui, const char *file, long lines, double share)
{
	if (is_wanted(ui) && is_due(ui))
		show(ui, file, lines, share);
}

void stderr_ui_done(struct stderr_ui *ui)
{
	ui->done++;
	if (ui->programs > 1 && is_wanted(ui) && is_due(ui))
		show(ui, NULL, 0, -1);
}

void stderr_ui_finish(struct stderr_ui *ui)
{
	stderr_ui_clear(ui);
	/* The last plain line is the total. */
	if (ui->kind == PROGRESS_PLAIN && is_wanted(ui) && ui->programs > 1)
		show(ui, NULL, 0, -1);
}

void stderr_ui_clear(struct stderr_ui *ui)
{
	if (!ui->progress)
		return;
	fputs("\r\033[K", stderr);
	ui->progress = false;
}

double stderr_ui_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
