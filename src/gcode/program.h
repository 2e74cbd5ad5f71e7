/* program.h - where in its files a program is being carried out: the line in hand, jumps, starting anew. */
#ifndef FIVECHECK_GCODE_PROGRAM_H
#define FIVECHECK_GCODE_PROGRAM_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/text/fault.h"
#include "gcode/text/source.h"

/* Blocks in loops and calls, if the configuration sets no other limit. */
#define PROGRAM_BLOCKS_MAX 100000000LL

/* The same behind a fault, after which a loop may lack what ends it. */
#define PROGRAM_FAULTY_BLOCKS_MAX 100000LL

/* All zero before program_open. */
struct program {
	struct sources sources;
	struct source *source;	/* that the line in hand comes from */
	struct position start;	/* of the first line, behind a byte order mark; no source before it was read */
	unsigned long lines;	/* that were begun, again and again in loops */
	long long blocks;	/* that were counted in loops and calls */
	long long faulty_from;	/* the count at the first fault, of a program that is read on */
	bool faulty;
	bool repeated;	/* it has been started anew */
	struct strbuf last_pass;	/* what it left behind then */
};

void program_release(struct program *program);

/* Lines of the program itself that have been read so far. */
static inline long program_lines(const struct program *program)
{
	const struct sources *sources = &program->sources;

	return sources->count ? sources->items[0]->reader.furthest : 0;
}

/* The next line in hand is the one at `to`. False: reported at the column. */
bool program_jump(struct program *program, const struct position *to, const struct line_place *at, int column);

/* Counts a block of a loop or a call against the limit; 0: the default. False: reported. */
bool program_count(struct program *program, long long limit, const struct line_place *at);

/*
 * Starts the program anew, unless `pass` is what the pass before left behind,
 * too: then this one would make the same moves for ever, and *same is true.
 * Takes over the storage of `pass`. False: reported at the column.
 */
bool program_restart(struct program *program, struct strbuf *pass, const struct line_place *at, int column,
		     bool *same);

#endif
