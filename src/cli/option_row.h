/* option_row.h - one row of a table of options: its name, its argument, and what it sets. */
#ifndef FIVECHECK_CLI_OPTION_ROW_H
#define FIVECHECK_CLI_OPTION_ROW_H

#include <stddef.h>

enum option_kind {
	VALUE_FLAG,	/* bool, set to true */
	VALUE_TEXT,	/* const char *, not empty */
	VALUE_LETTERS,	/* const char *; may be empty */
	VALUE_OUTPUT,	/* const char *: the name of a file, not empty; - becomes NULL, standard output */
	VALUE_LIST,	/* struct text_list, to which it is added */
	VALUE_NUMBER,	/* double from least to greatest */
	VALUE_COUNT,	/* int from least to greatest */
	VALUE_CHOICE,	/* int: the index of the choice */
	VALUE_FORMAT,	/* struct format_choice[], indexed by the choice: NAME or NAME=FILE */
	VALUE_SHARD,	/* two int: K and N of K/N */
	VALUE_KINDS,	/* unsigned: a bit for each choice named */
	VALUE_AMOUNTS,	/* four double from least to greatest, separated by commas */
	VALUE_MODE	/* sets the mode of the run; an argument: const char *, `choices` are suggestions */
};

struct option_row {
	int key;	/* its letter, or a number above 255 that no other row has */
	const char *name;
	const char *argument;	/* its name in --help; NULL: none */
	unsigned modes;	/* a bit for each mode of the run in which it is allowed */
	enum option_kind kind;
	size_t field;	/* offset of the member that it sets */
	double least, greatest;
	const char *unit;
	const char *const *choices;	/* ends in NULL */
	const char *other_choice;	/* one more, which completions offer; NULL: none */
	int mode;
	const char *help;	/* %s is replaced by the choices, "a, b or c" */
};

#endif
