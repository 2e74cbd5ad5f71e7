#include "machine/description.h"

void description_fault(struct description_file *file, const void *at, const char *attribute, const char *format, ...)
{
	va_list args;

	file->faults++;
	va_start(args, format);
	file->report(file->reader, at, attribute, format, args);
	va_end(args);
}

struct quotation description_quote(const struct description_file *file, const void *at, const char *attribute)
{
	return file->quote(file->reader, at, attribute);
}

struct srcloc description_place(const struct description_file *file, const void *at)
{
	return (struct srcloc){.file = file->path, .line = file->line(file->reader, at)};
}
