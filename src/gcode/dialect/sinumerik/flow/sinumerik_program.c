#include "gcode/dialect/sinumerik/flow/sinumerik_program.h"

#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_builder.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_seek.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"
#include "gcode/program.h"
#include "gcode/text/line_search.h"

/* Spells a folder in one way: /wks.dir/a.wpd/ and \_N_WKS_DIR\_N_A_WPD\ are the same folder. */
static void spell_folder(char *folder)
{
	char *to = folder;
	bool begins = true;

	for (char *at = folder; *at; at++)
		*at = (char)(*at == '\\' ? '/' : ascii_upper(*at));
	for (const char *at = folder; *at; at++) {
		if (begins && !strncmp(at, "_N_", 3) && at[3])
			at += 3;
		*to = (char)(!strncmp(at, "_DIR/", 5) || !strncmp(at, "_WPD/", 5) ? '.' : *at);
		begins = *to++ == '/';
	}
	*to = '\0';
}

/* Programs of one name in two folders of the control are two programs, but only one of them can be found here. */
static bool check_folder(struct interp *interp, const char *path, size_t length, const char *name, int column)
{
	struct labels *folders = &sinumerik_of(interp)->calls.folders;
	char key[SINUMERIK_NAME + SINUMERIK_TEXT + 2];

	snprintf(key, sizeof(key), "%s %.*s", name, (int)length, path);
	spell_folder(key + strlen(name) + 1);
	if (length == 0 || labels_find(folders, key))
		return true;
	if (labels_find(folders, name))
		return fault(&interp->at, column,
			     "%s may be another program than the %s of another folder that was called before: give "
			     "them different names",
			     path, name);
	labels_add(folders, name, 0);
	labels_add(folders, key, 0);
	return true;
}

bool sinumerik_program_name(struct interp *interp, const char *path, int column, char name[SINUMERIK_NAME + 1],
			    char *type)
{
	static const char *const types[] = {"_MPF", "_SPF", ".MPF", ".SPF"};
	const char *base = path;
	size_t length, folder;

	for (const char *at = path; *at; at++)
		base = *at == '/' || *at == '\\' || *at == ':' ? at + 1 : base;
	folder = (size_t)(base - path);
	if (!strncmp(base, "_N_", 3))
		base += 3;
	*type = '\0';
	length = strlen(base);
	for (size_t i = 0; i < sizeof(types) / sizeof(types[0]) && length > 4; i++) {
		bool same = true;

		for (size_t k = 0; k < 4; k++)
			same = same && ascii_upper(base[length - 4 + k]) == types[i][k];
		if (same) {
			length -= 4;
			*type = types[i][1];
			break;
		}
	}
	if (length == 0 || length > SINUMERIK_NAME)
		return fault(&interp->at, column, "\"%s\" names no subprogram", path);
	for (size_t i = 0; i < length; i++)
		name[i] = ascii_upper(base[i]);
	name[length] = '\0';
	return check_folder(interp, path, folder, name, column);
}

/*
 * Controls store names in upper case; files on other computers have either case. Each folder comes before the next
 * one. In one folder a control looks for an SPF first (NC programming, "Search path for subprogram call"), but it may
 * keep the main programs in one of its folders and the subprograms in another one, and then the MPF comes first.
 */
static bool find_file(struct interp *interp, const char *name, char type, int column, struct position *entry)
{
	static const char *const ends[] = {".SPF", ".spf", ".MPF", ".mpf", "_SPF", "_MPF", ""};
	const struct read_options *options = &interp->config->read;
	struct sources *sources = &interp->program.sources;
	struct position other = *entry;
	char file[SINUMERIK_NAME + 16];

	if (!sources_check_room(sources, &interp->at, column))
		return false;
	for (size_t i = 0; i < 14 * sources_folder_count(options); i++) {
		const char *end = ends[i / 2 % 7];

		if (i % 14 == 0 && entry->source)
			break;
		if (type && end[0] && type != ascii_upper(end[1]))
			continue;
		snprintf(file, sizeof(file), "%s%s", name, end);
		for (char *at = file; *at && i % 2 && at < file + strlen(name); at++)
			*at = ascii_lower(*at);
		other.source = sources_open(sources, options, i / 14, file);
		if (other.source && entry->source && other.source != entry->source)
			return line_search_refuse(&interp->at, column, name, entry, &other);
		if (other.source)
			*entry = other;
	}
	return sources_check_root(sources, options, &interp->at, column);
}

static bool fault_missing(struct interp *interp, const char *name, int column)
{
	return fault(
	    &interp->at, column,
	    "%s is neither a word that is known nor a subprogram: no file %s.SPF (or .spf, .MPF, .mpf, in upper or "
	    "lower case) lies beside the program or in a folder of --include; if %s is the builder's and moves no "
	    "axis, set <macro program=\"%s\" action=\"none\"/> in the machine file's <controller>",
	    name, name, name, sinumerik_builder_number(name) > 0 ? name + 1 : name);
}

/* A program of this name in the main program's file, or in the current one, beside one that was found before. */
static bool find_head(struct interp *interp, struct source *source, const char *name, char type, int column,
		      struct position *entry)
{
	struct position head;
	bool found;

	if (!sinumerik_seek_program(interp, source, name, type, column, &head, &found))
		return false;
	if (!found || entry->source == source)
		return true;
	if (entry->source)
		return line_search_refuse(&interp->at, column, name, &head, entry);
	*entry = head;
	return true;
}

/* Each program is searched once for each calling file: the whole file of the main program is read. */
bool sinumerik_program_find(struct interp *interp, const char *name, char type, int column, struct position *entry)
{
	struct source *main = interp->program.sources.items[0], *caller = interp->program.source;
	struct labels *programs = &sinumerik_of(interp)->calls.programs;
	char key[SINUMERIK_NAME + 32];
	struct label *known;

	snprintf(key, sizeof(key), "%c%s %p", type ? type : '%', name, (void *)caller);
	known = labels_find(programs, key);
	if (known) {
		*entry = known->at;
		return true;
	}
	*entry = (struct position){.line = 1};
	if (!find_file(interp, name, type, column, entry) || !find_head(interp, main, name, type, column, entry) ||
	    (caller != main && !find_head(interp, caller, name, type, column, entry)))
		return false;
	if (!entry->source)
		return fault_missing(interp, name, column);
	known = labels_add(programs, key, 0);
	if (known)
		known->at = *entry;
	return true;
}
