#include "cli/argv_parser.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static const struct srcloc nowhere;

/* getopt's two forms of the table; owned. */
struct getopt_tables {
	char *letters;
	struct option *names;
};

static void tables_init(struct getopt_tables *tables, const struct argv_parser *words)
{
	char *letter = mem_zalloc(3 + 2 * words->count, 1);

	tables->letters = letter;
	tables->names = mem_zalloc(words->count + 1, sizeof(*tables->names));
	/* Operands come in turn, whatever POSIXLY_CORRECT says; a missing argument is told apart. */
	*letter++ = '-';
	*letter++ = ':';
	for (size_t i = 0; i < words->count; i++) {
		const struct option_row *row = &words->table[i];

		tables->names[i].name = row->name;
		tables->names[i].has_arg = row->argument ? required_argument : no_argument;
		tables->names[i].val = row->key;
		if (row->key > 255)
			continue;
		*letter++ = (char)row->key;
		if (row->argument)
			*letter++ = ':';
	}
}

static const struct option_row *row_of(const struct argv_parser *words, int key)
{
	for (size_t i = 0; i < words->count; i++) {
		if (words->table[i].key == key)
			return &words->table[i];
	}
	return NULL;
}

/* What getopt_long could not make sense of. */
static bool refuse(const struct argv_parser *words, int result, char **argv, struct diag *diag)
{
	const struct option_row *row = row_of(words, optopt);
	const char *word = argv[optind - 1];

	if (result == ':')
		diag_error(diag, nowhere, "--%s needs its argument: %s", row->name, row->argument);
	else if (row && !row->argument && strchr(word, '='))
		diag_error(diag, nowhere, "--%s takes no argument", row->name);
	else if (optopt)
		diag_error(diag, nowhere, "unknown option -%c", optopt);
	else
		diag_error(diag, nowhere, "unknown or ambiguous option %s", word);
	return false;
}

static bool parse(const struct argv_parser *words, const struct getopt_tables *tables, int argc, char **argv,
		  struct diag *diag)
{
	int result;

	opterr = 0;
	while ((result = getopt_long(argc, argv, tables->letters, tables->names, NULL)) != -1) {
		enum argv_result next = ARGV_NEXT;

		if (result == '?' || result == ':')
			return refuse(words, result, argv, diag);
		if (result == 1)
			words->operand(words->context, optarg);
		else
			next = words->option(words->context, row_of(words, result), optarg);
		if (next != ARGV_NEXT)
			return next == ARGV_LAST;
	}
	while (optind < argc)
		words->operand(words->context, argv[optind++]);
	return true;
}

bool argv_parser_run(const struct argv_parser *words, int argc, char **argv, struct diag *diag)
{
	struct getopt_tables tables;
	bool good;

	tables_init(&tables, words);
	good = parse(words, &tables, argc, argv, diag);
	free(tables.letters);
	free(tables.names);
	return good;
}

void argv_parser_help(struct strbuf *out, const struct option_row *table, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		const struct option_row *row = &table[i];
		struct strbuf name = {0};

		if (row->key > 255)
			strbuf_addf(&name, "      --%s", row->name);
		else
			strbuf_addf(&name, "  -%c, --%s", row->key, row->name);
		if (row->argument)
			strbuf_addf(&name, "=%s", row->argument);
		strbuf_addf(out, "%-30s", name.text);
		if (name.length > 29)
			strbuf_addf(out, "\n%30s", "");
		for (const char *c = row->help; *c; c++)
			strbuf_addf(out, *c == '\n' ? "\n%31s" : "%.1s", *c == '\n' ? " " : c);
		strbuf_addf(out, "\n");
		strbuf_release(&name);
	}
}
