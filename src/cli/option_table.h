/* option_table.h - the one table of options: what each is called, takes, sets, and where it means something. */
#ifndef FIVECHECK_CLI_OPTION_TABLE_H
#define FIVECHECK_CLI_OPTION_TABLE_H

#include <stddef.h>

#include "cli/options.h"

enum option_kind {
	VALUE_FLAG,	/* bool, set to true */
	VALUE_TEXT,	/* const char * */
	VALUE_LIST,	/* struct text_list, one more */
	VALUE_NUMBER,	/* double from least to greatest */
	VALUE_COUNT,	/* int from least to greatest */
	VALUE_CHOICE,	/* int: which of the choices */
	VALUE_FORMAT,	/* struct format_choice[], one of them: a name, or NAME=FILE */
	VALUE_SHARE,	/* two int, K of K/N and N */
	VALUE_KINDS,	/* unsigned, a bit for each kind of finding */
	VALUE_AMOUNTS,	/* four double from least to greatest, separated by commas */
	VALUE_MODE	/* the run's mode becomes `mode` */
};

struct option_row {
	int key;	/* its letter, or a number above 255 that is its own */
	const char *name;
	const char *argument;	/* as --help calls it; NULL: it takes none */
	unsigned modes;	/* a bit for each run_mode in which it means something */
	enum option_kind kind;
	size_t field;	/* offset in struct options */
	double least, greatest;
	const char *unit;
	const char *const *choices;	/* ends in NULL */
	enum run_mode mode;
	const char *help;	/* a newline breaks it */
};

enum { OPTION_COUNT = 37 };

extern const struct option_row option_table[OPTION_COUNT];

#endif
