/* program.h - the present place of a program in its files: the current line, jumps, restarts. */
#ifndef FIVECHECK_GCODE_PROGRAM_H
#define FIVECHECK_GCODE_PROGRAM_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/text/fault.h"
#include "gcode/text/source.h"

/* The most blocks in loops and calls, if the configuration sets no other limit. */
#define PROGRAM_BLOCKS_MAX 100000000LL

/* The same after a fault, because the condition that ends a loop may then be missing. */
#define PROGRAM_FAULTY_BLOCKS_MAX 100000LL

/* All zero before program_open. */
struct program {
	struct sources sources;
	struct source *source;	/* of the current line */
	struct position start;	/* of the first line, after a byte order mark; no source before it was read */
	unsigned long lines;	/* started so far, each time that a loop repeats them */
	long long blocks;	/* counted in loops and calls */
	long long faulty_from;	/* value of `blocks` at the first fault, if the program is read on */
	bool faulty;
	bool repeated;	/* the program has been restarted */
	struct strbuf last_pass;	/* the state at the end of the last pass */
	struct strbuf line;	/* the current line, if it was kept or a macro has changed it */
};

void program_release(struct program *program);

/* Lines of the program itself that have been read so far. */
static inline long program_lines(const struct program *program)
{
	const struct sources *sources = &program->sources;

	return sources->count ? sources->items[0]->reader.furthest : 0;
}

/* Copies the text of the current line, which reading further lines would overwrite; at->text is then the copy. */
void program_keep_line(struct program *program, struct line_place *at);

/* Jumps to the line at `to`. False: reported at the column. */
bool program_jump(struct program *program, const struct position *to, const struct line_place *at, int column);

/* Counts a block of a loop or a call against the limit; 0: the default. False: reported. */
bool program_count(struct program *program, long long limit, const struct line_place *at);

/*
 * Restarts the program. If `pass` equals the state at the end of the pass before, all further passes would make the
 * same moves: then *same is true and the program is not restarted. Takes over the storage of `pass`. False: reported at
 * the column.
 */
bool program_restart(struct program *program, struct strbuf *pass, const struct line_place *at, int column,
		     bool *same);

#endif
