#include "gcode/text/reader_fault.h"

#include <errno.h>
#include <string.h>

struct reader_fault reader_fault_of(const struct reader *reader, enum reader_status status, const char *text)
{
	struct reader_fault fault = {status, reader->line, 0, NULL};

	if (status == READER_NUL_BYTE || status == READER_MIXED_ENDS)
		fault.column = (int)strlen(text) + 1;
	else if (status == READER_NO_TEXT)
		fault.advice = text;
	else if (status == READER_FAILED)
		fault.line = 0;
	return fault;
}

void reader_fault_report(const struct reader_fault *fault, const char *file, struct diag *diag)
{
	const struct srcloc loc = {file, fault->line, fault->column};

	switch (fault->status) {
	case READER_TOO_LONG:
		diag_error(diag, loc, "a line of more than %d bytes is not an NC block", LINE_LENGTH_MAX);
		break;
	case READER_NUL_BYTE:
		diag_error(diag, loc,
			   "a NUL byte: the file was not written completely, or is no NC program; write or copy it "
			   "again");
		break;
	case READER_MIXED_ENDS:
		diag_error(diag, loc,
			   "mixed line ends: some are a carriage return alone, some have a line feed; save the file "
			   "with one kind of line end");
		break;
	case READER_NO_TEXT:
		diag_error(diag, loc, "%s", fault->advice);
		break;
	default:
		diag_error(diag, loc, "cannot read: %s", strerror(errno));
		break;
	}
}
