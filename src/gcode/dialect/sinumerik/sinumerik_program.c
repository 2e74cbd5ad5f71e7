#include "gcode/dialect/sinumerik/sinumerik_program.h"

#include <stdio.h>
#include <string.h>

#include "gcode/dialect/sinumerik/sinumerik_builder.h"
#include "gcode/dialect/sinumerik/sinumerik_name.h"
#include "gcode/dialect/sinumerik/sinumerik_seek.h"
#include "gcode/eval/expr.h"
#include "gcode/program.h"

bool sinumerik_program_name(struct interp *interp, const char *path, int column, char name[SINUMERIK_NAME + 1])
{
	static const char *const types[] = {"_MPF", "_SPF", ".MPF", ".SPF"};
	const char *base = path;
	size_t length;

	for (const char *at = path; *at; at++)
		base = *at == '/' || *at == '\\' || *at == ':' ? at + 1 : base;
	if (!strncmp(base, "_N_", 3))
		base += 3;
	length = strlen(base);
	for (size_t i = 0; i < sizeof(types) / sizeof(types[0]) && length > 4; i++) {
		bool same = true;

		for (size_t k = 0; k < 4; k++)
			same = same && sinumerik_upper(base[length - 4 + k]) == types[i][k];
		if (same) {
			length -= 4;
			break;
		}
	}
	if (length == 0 || length > SINUMERIK_NAME)
		return fault(&interp->at, column, "\"%s\" names no subprogram", path);
	for (size_t i = 0; i < length; i++)
		name[i] = sinumerik_upper(base[i]);
	name[length] = '\0';
	return true;
}

/* Controls store names in upper case; files on other computers have either case. */
static bool find_file(struct interp *interp, const char *name, int column, struct source **source)
{
	static const char *const ends[] = {".SPF", ".spf", ".MPF", ".mpf", "_SPF", "_MPF", ""};
	char file[SINUMERIK_NAME + 16];

	*source = NULL;
	for (size_t i = 0; i < 2 * sizeof(ends) / sizeof(ends[0]) && !*source; i++) {
		snprintf(file, sizeof(file), "%s%s", name, ends[i / 2]);
		for (char *at = file; *at && i % 2 && at < file + strlen(name); at++) {
			if (*at >= 'A' && *at <= 'Z')
				*at = (char)(*at - 'A' + 'a');
		}
		if (!sources_find(&interp->program.sources, &interp->config->read, file, &interp->at, column, source))
			return false;
	}
	return true;
}

static bool fault_missing(struct interp *interp, const char *name, int column)
{
	if (sinumerik_builder_number(name) > 0)
		return fault(
		    &interp->at, column,
		    "there is no file %s.SPF (or .spf, .MPF, .mpf, in upper or lower case) beside the program or "
		    "in a folder of --include; if %s is the builder's and moves no axis, set <macro "
		    "program=\"%ld\" action=\"none\"/> in the machine file's <controller>",
		    name, name, sinumerik_builder_number(name));
	return fault(
	    &interp->at, column,
	    "%s is neither a word that is known nor a subprogram: no file %s.SPF (or .spf, .MPF, .mpf, in upper or "
	    "lower case) lies beside the program or in a folder of --include; if %s is the builder's and moves no "
	    "axis, set <macro program=\"%s\" action=\"none\"/> in the machine file's <controller>",
	    name, name, name, name);
}

bool sinumerik_program_find(struct interp *interp, const char *name, int column, struct position *entry)
{
	bool found = false;

	*entry = (struct position){.line = 1};
	if (!find_file(interp, name, column, &entry->source))
		return false;
	if (entry->source)
		return true;
	return sinumerik_seek_program(interp, name, column, entry, &found) &&
	       (found || fault_missing(interp, name, column));
}
