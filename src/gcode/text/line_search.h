/* line_search.h - looks for lines of a file; the next line that its reader returns stays the same. */
#ifndef FIVECHECK_GCODE_TEXT_LINE_SEARCH_H
#define FIVECHECK_GCODE_TEXT_LINE_SEARCH_H

#include "gcode/text/source.h"

enum line_sought {
	LINE_OTHER,
	LINE_SOUGHT,
	LINE_BEHIND	/* the part of the file that is searched ends before this line */
};

struct line_search {
	enum line_sought (*judge)(void *context, const char *text, long line);
	void *context;
	const struct cancel *cancel;	/* NULL: nobody cancels */
	long last;	/* the line that ends the search; 0: the end of the file */
	int most;	/* the number of lines found that ends the search */
	/* The result; 0 before the first search. Further searches add to it. */
	int count;
	struct position first, second;	/* if there are so many */
	struct position behind;	/* the line after the last one found */
	bool unfinished;	/* the next line to be searched is not in the window of a pipe */
};

/*
 * Searches from this line on. The lines overwrite the text of the current line. On a pipe the search may go as far as
 * READER_WINDOW less LINE_LENGTH_MAX after the next line, whatever has arrived. False: unfinished, or cancelled.
 */
bool line_search_run(struct line_search *search, const struct position *from);

/* Reports that the search for the name was not finished; false. */
bool line_search_refuse_pipe(const struct line_place *at, int column, const char *name);

/* Reports that it is not certain which of two lines the name means; false. */
bool line_search_refuse(const struct line_place *at, int column, const char *name, const struct position *a,
			const struct position *b);

#endif
