/* reader_fault.h - the messages about bytes that are no lines of a program. */
#ifndef FIVECHECK_GCODE_TEXT_READER_FAULT_H
#define FIVECHECK_GCODE_TEXT_READER_FAULT_H

#include "base/diag.h"
#include "gcode/text/reader.h"

/* What reader_next returned: a line, the end, or a fault. */
struct reader_fault {
	enum reader_status status;
	long line;	/* of the line, or of the last line before the end; 0: of no line */
	int column;	/* from 1; 0: of the whole line */
	const char *advice;	/* constant, for READER_NO_TEXT; otherwise NULL */
};

/* `status` and `text` are what reader_next just returned. */
struct reader_fault reader_fault_of(const struct reader *reader, enum reader_status status, const char *text);

/* Reports a fault in `file`; for READER_FAILED errno must still say why. */
void reader_fault_report(const struct reader_fault *fault, const char *file, struct diag *diag);

#endif
