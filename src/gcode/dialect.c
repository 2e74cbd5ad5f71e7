#include "gcode/dialect.h"

bool dialect_answers(const struct dialect *dialect, const struct line_place *at, int column, int answer,
		     const char *question)
{
	if (answer)
		return true;
	return fault(at, column, "%s is not known of the %s dialect", question, dialect->name);
}
