#include "gcode/dialect/fanuc/program_files.h"

#include <stdio.h>
#include <string.h>

#include "gcode/state.h"

/* The spellings of a number: O12, O0012, O00012, and the same without the O. */
#define SPELLINGS 6
#define SPELLING_SIZE 24

/* True if an earlier spelling is the same: O12345 has only two. */
static bool is_repeated(char spellings[SPELLINGS][SPELLING_SIZE], size_t index)
{
	for (size_t i = 0; i < index; i++) {
		if (!strcmp(spellings[i], spellings[index]))
			return true;
	}
	return false;
}

/* Finds the file with this spelling in the folder. False: *source is already another file, which was reported. */
static bool find_spelling(struct interp *interp, size_t folder, const char *spelling, int number, int column,
			  struct source **source)
{
	static const char *const endings[] = {"", ".nc", ".NC", ".cnc", ".CNC", ".tap", ".TAP", ".txt", ".TXT"};

	for (size_t i = 0; i < sizeof(endings) / sizeof(*endings); i++) {
		char name[SPELLING_SIZE + 8];
		struct source *next;

		snprintf(name, sizeof(name), "%.23s%.7s", spelling, endings[i]);
		next = sources_open(&interp->program.sources, &interp->config->read, folder, name);
		if (next && *source && next != *source)
			return fault(&interp->at, column, "%s and %s may both be program O%d", (*source)->name,
				     next->name, number);
		*source = next ? next : *source;
	}
	return true;
}

static bool find_in_folder(struct interp *interp, size_t folder, int number, int column, struct source **source)
{
	static const int digits[] = {1, 4, 5};
	char spellings[SPELLINGS][SPELLING_SIZE];

	for (size_t i = 0; i < SPELLINGS; i++) {
		snprintf(spellings[i], sizeof(spellings[i]), "%s%0*d", i < 3 ? "O" : "", digits[i % 3], number);
		if (!is_repeated(spellings, i) && !find_spelling(interp, folder, spellings[i], number, column, source))
			return false;
	}
	return true;
}

bool program_files_find(struct interp *interp, int number, int column, struct source **source)
{
	const struct read_options *options = &interp->config->read;
	struct sources *sources = &interp->program.sources;

	*source = NULL;
	if (!sources_check_room(sources, &interp->at, column))
		return false;
	for (size_t folder = 0; folder < sources_folder_count(options) && !*source; folder++) {
		if (!find_in_folder(interp, folder, number, column, source))
			return false;
	}
	return sources_check_root(sources, options, &interp->at, column);
}
