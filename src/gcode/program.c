#include "gcode/program.h"

#include <string.h>

void program_release(struct program *program)
{
	sources_release(&program->sources);
	strbuf_release(&program->last_pass);
	strbuf_release(&program->line);
}

void program_keep_line(struct program *program, struct line_place *at)
{
	if (at->text == program->line.text)
		return;
	strbuf_clear(&program->line);
	strbuf_add(&program->line, at->text, strlen(at->text));
	at->text = strbuf_text(&program->line);
}

bool program_jump(struct program *program, const struct position *to, const struct line_place *at, int column)
{
	if (!reader_seek(&to->source->reader, to->offset, to->line))
		return fault(at, column,
			     "a jump to line %ld of %s, which is no longer available in the pipe (the last %zu MiB are "
			     "kept); give the program as a file",
			     to->line, to->source->name, READER_WINDOW >> 20);
	program->source = to->source;
	return true;
}

bool program_count(struct program *program, long long limit, const struct line_place *at)
{
	if (limit <= 0)
		limit = PROGRAM_BLOCKS_MAX;
	program->blocks++;
	if (program->faulty && program->blocks - program->faulty_from > PROGRAM_FAULTY_BLOCKS_MAX)
		return fault(at, 1,
			     "%lld blocks of loops and subprograms were executed since the first error, which may be "
			     "why they do not end; the rest of the program is not searched for errors",
			     PROGRAM_FAULTY_BLOCKS_MAX);
	if (program->blocks <= limit)
		return true;
	return fault(at, 1,
		     "%lld blocks of loops and subprograms were executed: is this loop endless? --max-blocks sets "
		     "another limit",
		     limit);
}

bool program_restart(struct program *program, struct strbuf *pass, const struct line_place *at, int column,
		     bool *same)
{
	struct strbuf *last = &program->last_pass;

	*same = pass->length == last->length && !memcmp(pass->text, last->text, pass->length);
	strbuf_release(last);
	*last = *pass;
	program->repeated = true;
	return *same || program_jump(program, &program->start, at, column);
}
