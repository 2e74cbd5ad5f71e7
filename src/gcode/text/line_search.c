#include "gcode/text/line_search.h"

/* Lines read between two queries of the cancel callback. */
#define ASK_LINES 4096

bool line_search_run(struct line_search *search, const struct position *from)
{
	struct reader *reader = &from->source->reader;
	const struct reader_mark mark = reader_mark(reader);
	const long long end = mark.next + (long long)READER_WINDOW - LINE_LENGTH_MAX;
	enum line_sought line = LINE_OTHER;
	bool good = reader_seek(reader, from->offset, from->line);
	const char *text;

	search->unfinished = !good;
	while (good && line != LINE_BEHIND && search->count < search->most &&
	       (!search->last || reader->line < search->last)) {
		search->unfinished = reader->base < 0 && reader_position(reader) > end;
		if (search->unfinished || reader_next(reader, &text) != READER_LINE)
			break;
		line = search->judge(search->context, text, reader->line);
		if (line == LINE_SOUGHT) {
			search->second = source_here(from->source);
			search->behind = source_next(from->source);
			if (search->count++ == 0)
				search->first = search->second;
		}
		good = reader->line % ASK_LINES != 0 || !cancel_asked(search->cancel);
	}
	reader_return(reader, &mark);
	return good && !search->unfinished;
}

bool line_search_refuse_pipe(const struct line_place *at, int column, const char *name)
{
	return fault(at, column,
		     "%s may be more than %zu MiB before or after this line of the pipe, where it is not looked for; "
		     "give the program as a file",
		     name, READER_WINDOW >> 20);
}

bool line_search_refuse(const struct line_place *at, int column, const char *name, const struct position *a,
			const struct position *b)
{
	return fault(at, column, "%s is in line %ld of %s and in line %ld of %s: which one is meant is not certain",
		     name, a->line, a->source->name, b->line, b->source->name);
}
