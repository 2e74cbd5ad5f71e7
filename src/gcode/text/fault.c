#include "gcode/text/fault.h"

#include <stdarg.h>

struct srcloc line_loc(const struct line_place *at, int column)
{
	return (struct srcloc){at->file, at->line, column};
}

struct line_place fault_place(const struct line_place *at, struct srcloc element)
{
	if (!element.file)
		return *at;
	return (struct line_place){.diag = at->diag, .file = element.file, .line = element.line};
}

void fault_report(const struct line_place *at, int column, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	diag_report(at->diag, DIAG_ERROR, line_loc(at, column), at->text, format, args);
	va_end(args);
}

void caution(const struct line_place *at, int column, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	diag_report(at->diag, DIAG_WARNING, line_loc(at, column), at->text, format, args);
	va_end(args);
}
