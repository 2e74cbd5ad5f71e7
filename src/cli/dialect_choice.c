#include "cli/dialect_choice.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/open_file.h"
#include "base/strbuf.h"
#include "control/dialects.h"
#include "gcode/dialect/family.h"
#include "gcode/interp.h"

#define NAME_ROW(id, ...) #id,
#define NAME_IT "name the dialect: --dialect=NAME"

const char *const dialect_choice_names[] = {DIALECTS(NAME_ROW) "auto", NULL};

bool dialect_choice_is_auto(int choice)
{
	return choice >= 0 && !dialect_names[choice];
}

/* "--dialect=fanuc or --dialect=haas": the dialects that the codes permit. */
static void list_open(const struct family_guess *guess, struct strbuf *out)
{
	int last = -1;

	for (int row = 0; dialect_names[row]; row++)
		last = guess->rows & (1U << row) ? row : last;
	for (int row = 0, count = 0; row <= last; row++) {
		if (guess->rows & (1U << row))
			strbuf_addf(out, "%s--dialect=%s", count++ == 0 ? "" : row < last ? ", " : " or ",
				    dialect_names[row]);
	}
}

static bool refuse(const char *program, const struct family_guess *guess, struct diag *diag)
{
	struct srcloc loc = {program, guess->sign.line, 0};
	struct strbuf open = {0};

	list_open(guess, &open);
	if (guess->end.status == READER_END && guess->end.line == 0)
		diag_error(diag, loc, INTERP_NO_BLOCK);
	else if (guess->end.status != READER_LINE && guess->end.status != READER_END)
		reader_fault_report(&guess->end, program, diag);
	else if (guess->against.line)
		diag_error(diag, (struct srcloc){program, guess->against.line, 0},
			   "--dialect=auto: this line looks like %s (%s), but line %ld looks like %s (%s); " NAME_IT,
			   guess->against.title, guess->against.sign, guess->sign.line, guess->sign.title,
			   guess->sign.sign);
	else if (guess->sign.line && guess->rows == 0)
		diag_error(diag, loc, "--dialect=auto: this looks like %s (%s); if it is not, " NAME_IT,
			   guess->sign.title, guess->sign.sign);
	else if (guess->sign.line)
		diag_error(diag, loc,
			   "--dialect=auto: this looks like %s (%s), which several dialects have; write %s",
			   guess->sign.title, guess->sign.sign, strbuf_text(&open));
	else
		diag_error(diag, loc, "--dialect=auto: the first lines do not show the dialect; write %s",
			   strbuf_text(&open));
	strbuf_release(&open);
	return false;
}

/* What was read ahead in a pipe would be missing in the check. */
static bool can_look_ahead(const char *program, struct diag *diag)
{
	struct stat status;

	if (!strcmp(program, "-")) {
		diag_error(diag, (struct srcloc){0},
			   "--dialect=auto cannot look ahead in standard input; " NAME_IT);
		return false;
	}
	if (stat(program, &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))
		return true;
	diag_error(diag, (struct srcloc){program, 0, 0}, "--dialect=auto cannot look ahead in a pipe; " NAME_IT);
	return false;
}

static bool find_one(const char *program, struct diag *diag, struct family_guess *guess)
{
	struct reader reader;
	int fault;
	FILE *in;

	if (!can_look_ahead(program, diag))
		return false;
	in = open_file(program, diag);
	if (!in)
		return false;
	reader_init(&reader, in);
	errno = 0;
	*guess = family_guess(&reader);
	fault = ferror(in) ? errno : 0;
	reader_release(&reader);
	fclose(in);
	if (fault)
		diag_error(diag, (struct srcloc){program, 0, 0}, "cannot read: %s", strerror(fault));
	return !fault && (guess->row >= 0 || refuse(program, guess, diag));
}

bool dialect_choice_find(char *const *programs, size_t count, struct diag *diag, int *row)
{
	int found = -1;

	for (size_t i = 0; i < count; i++) {
		struct family_guess guess;

		if (!find_one(programs[i], diag, &guess))
			return false;
		if (found >= 0 && guess.row != found) {
			diag_error(diag, (struct srcloc){programs[i], guess.sign.line, 0},
				   "--dialect=auto: this is %s (%s), but %s is for %s; check them in separate runs",
				   guess.sign.title, guess.sign.sign, programs[0], dialect_rows[found].title);
			return false;
		}
		if (found < 0)
			diag_note(diag, (struct srcloc){programs[i], guess.sign.line, 0},
				  "read in the %s dialect: %s (%s)", dialect_names[guess.row], guess.sign.title,
				  guess.sign.sign);
		found = guess.row;
	}
	if (found >= 0)
		*row = found;
	return found >= 0;
}
