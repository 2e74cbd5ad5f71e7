#include "import/hal_values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "base/file_bytes.h"
#include "base/mem.h"

enum { WORDS_MAX = 20 };

struct hal_command {
	struct srcloc at;
	const char *words[WORDS_MAX];	/* without arrows; further ones are left out */
	size_t count;
};

void hal_values_release(struct hal_values *hal)
{
	free(hal->commands);
	arena_release(&hal->arena);
	*hal = (struct hal_values){0};
}

static bool is_arrow(const char *word)
{
	return !strcmp(word, "=>") || !strcmp(word, "<=") || !strcmp(word, "<=>");
}

static void add_command(struct hal_values *hal, const char *text, size_t length, struct srcloc at)
{
	char *copy = arena_alloc(&hal->arena, length + 1), *rest = NULL;
	struct hal_command command = {.at = at};

	memcpy(copy, text, length);
	copy[strcspn(copy, "#")] = '\0';
	for (char *word = strtok_r(copy, " \t\r", &rest); word && command.count < WORDS_MAX;
	     word = strtok_r(NULL, " \t\r", &rest))
		if (!is_arrow(word))
			command.words[command.count++] = word;
	if (!command.count)
		return;
	hal->commands = mem_grow(hal->commands, &hal->capacity, hal->count + 1, sizeof(command));
	hal->commands[hal->count++] = command;
}

static bool read_hal_file(struct hal_values *hal, const char *path)
{
	struct srcloc at = {.file = path};
	struct file_bytes file;

	if (!file_bytes_read(&file, path, hal->diag))
		return false;
	for (const char *line = file.bytes; *line;) {
		size_t length = strcspn(line, "\n");

		at.line++;
		add_command(hal, line, length, at);
		line += length;
		line += *line == '\n';
	}
	file_bytes_release(&file);
	return true;
}

static bool read_entry(struct hal_values *hal, const struct ini_entry *entry)
{
	size_t length = strcspn(entry->value, " \t");
	const char *name = entry->value;
	char *copy;

	if (!strncmp(name, "LIB:", 4))
		return true;
	if (length > 4 && !strncmp(name + length - 4, ".tcl", 4)) {
		hal->scripts = true;
		return true;
	}
	copy = arena_alloc(&hal->arena, length + 1);
	memcpy(copy, name, length);
	return read_hal_file(hal, ini_file_beside(&hal->arena, entry->at.file, copy));
}

bool hal_values_read(struct hal_values *hal, const struct ini_file *ini, struct diag *diag)
{
	const struct ini_entry *entry = NULL;

	*hal = (struct hal_values){.ini = ini, .diag = diag};
	while ((entry = ini_file_next(ini, entry, "HAL", "HALFILE")))
		if (!read_entry(hal, entry))
			return false;
	while ((entry = ini_file_next(ini, entry, "HAL", "HALCMD")))
		add_command(hal, entry->value, strlen(entry->value), entry->at);
	return true;
}

static bool read_number(const char *text, size_t length, bool bit, double *value)
{
	const bool yes = bit && length == 4 && ascii_same_start(text, "true", 4),
		   no = bit && length == 5 && ascii_same_start(text, "false", 5);

	if (yes || no)
		*value = yes;
	return yes || no || (length && decimal_read(text, length, value) && isfinite(*value));
}

/* A number, or [SECTION]KEY or [SECTION](KEY) of the ini file. */
static enum hal_found read_value(const struct hal_values *hal, const struct hal_command *command, bool bit,
				 double *value)
{
	const char *text = command->count > 2 ? command->words[2] : "", *close = strchr(text, ']');
	double number;

	if (*text == '[' && close) {
		struct arena arena = {0};
		char *section = arena_copy(&arena, text + 1, (size_t)(close - text)),
		     *key = arena_strdup(&arena, close + 1);
		const char *found;

		section[close - text - 1] = '\0';
		key += *key == '(';
		key[strcspn(key, ")")] = '\0';
		found = ini_file_text(hal->ini, section, key);
		text = found ? found : "";
		arena_release(&arena);
	}
	if (read_number(text, strcspn(text, " \t"), bit, &number)) {
		*value = number;
		return HAL_SET;
	}
	diag_error(hal->diag, command->at, "the value of %s must be a number, or [SECTION]KEY of the ini file",
		   command->words[1]);
	return HAL_FAULT;
}

static bool connects(const struct hal_command *command, const char *pin)
{
	for (size_t i = 2; i < command->count; i++)
		if (!strcmp(command->words[0], "net") && !strcmp(command->words[i], pin))
			return true;
	return false;
}

/* The last command with this name for this pin or signal, or NULL. */
static const struct hal_command *last(const struct hal_values *hal, const char *name, const char *what)
{
	for (size_t i = hal->count; i > 0; i--)
		if (!strcmp(hal->commands[i - 1].words[0], name) && hal->commands[i - 1].count > 1 &&
		    !strcmp(hal->commands[i - 1].words[1], what))
			return &hal->commands[i - 1];
	return NULL;
}

enum hal_found hal_values_find(const struct hal_values *hal, const char *pin, bool bit, double *value)
{
	const struct hal_command *set = last(hal, "setp", pin);

	for (size_t i = 0; i < hal->count; i++) {
		if (!connects(&hal->commands[i], pin))
			continue;
		set = last(hal, "sets", hal->commands[i].words[1]);
		return set ? read_value(hal, set, bit, value) : HAL_SIGNAL;
	}
	return set ? read_value(hal, set, bit, value) : HAL_DEFAULT;
}
