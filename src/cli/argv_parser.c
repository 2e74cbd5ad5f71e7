#include "cli/argv_parser.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/spelling.h"

static const struct srcloc nowhere;

/* The table in the two forms that getopt_long requires; owned. */
struct getopt_tables {
	char *letters;
	struct option *names;
};

static void tables_init(struct getopt_tables *tables, const struct argv_parser *parser)
{
	char *letter = mem_zalloc(3 + 2 * parser->count, 1);

	tables->letters = letter;
	tables->names = mem_zalloc(parser->count + 1, sizeof(*tables->names));
	/* '-' passes operands in order, even with POSIXLY_CORRECT; ':' reports a missing argument as ':'. */
	*letter++ = '-';
	*letter++ = ':';
	for (size_t i = 0; i < parser->count; i++) {
		const struct option_row *row = &parser->table[i];

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

static const struct option_row *row_of(const struct argv_parser *parser, int key)
{
	for (size_t i = 0; i < parser->count; i++) {
		if (parser->table[i].key == key)
			return &parser->table[i];
	}
	return NULL;
}

/* Names the option that was probably meant, or the options that match an abbreviation. */
static void refuse_name(const struct argv_parser *parser, const char *word, struct diag *diag)
{
	char *name = mem_strndup(word + 2, strcspn(word + 2, "="));
	struct strbuf candidates = {0};
	struct spelling nearest;

	spelling_init(&nearest, name);
	for (size_t i = 0; i < parser->count; i++) {
		const char *known = parser->table[i].name;

		spelling_offer(&nearest, known);
		if (!strncmp(known, name, strlen(name)))
			strbuf_addf(&candidates, "%s--%s", candidates.length ? ", " : "", known);
	}
	if (candidates.length)
		diag_error(diag, nowhere, "ambiguous option --%s: it could be %s", name, candidates.text);
	else if (nearest.best)
		diag_error(diag, nowhere, "unknown option --%s; did you mean --%s?", name, nearest.best);
	else
		diag_error(diag, nowhere, "unknown option --%s", name);
	strbuf_release(&candidates);
	free(name);
}

/* Reports why getopt_long refused a word. */
static bool refuse(const struct argv_parser *parser, int result, char **argv, struct diag *diag)
{
	const struct option_row *row = row_of(parser, optopt);
	const char *word = argv[optind - 1];

	if (result == ':')
		diag_error(diag, nowhere, "--%s needs an argument: %s", row->name, row->argument);
	else if (row && !row->argument && strchr(word, '='))
		diag_error(diag, nowhere, "--%s takes no argument", row->name);
	else if (optopt)
		diag_error(diag, nowhere, "unknown option -%c", optopt);
	else
		refuse_name(parser, word, diag);
	return false;
}

static bool parse(const struct argv_parser *parser, const struct getopt_tables *tables, int argc, char **argv,
		  struct diag *diag)
{
	int result;

	opterr = 0;
	/* An earlier command line may have been parsed: 0 makes glibc and musl start again. */
	optind = 0;
	while ((result = getopt_long(argc, argv, tables->letters, tables->names, NULL)) != -1) {
		enum argv_result next = ARGV_NEXT;

		if (result == '?' || result == ':')
			return refuse(parser, result, argv, diag);
		if (result == 1)
			parser->operand(parser->context, optarg);
		else
			next = parser->option(parser->context, row_of(parser, result), optarg);
		if (next != ARGV_NEXT)
			return next == ARGV_LAST;
	}
	while (optind < argc)
		parser->operand(parser->context, argv[optind++]);
	return true;
}

bool argv_parser_run(const struct argv_parser *parser, int argc, char **argv, struct diag *diag)
{
	struct getopt_tables tables;
	bool good;

	tables_init(&tables, parser);
	good = parse(parser, &tables, argc, argv, diag);
	free(tables.letters);
	free(tables.names);
	return good;
}

/* "a, b or c" */
static void add_choices(struct strbuf *out, const char *const *choices)
{
	for (int i = 0; choices[i]; i++)
		strbuf_addf(out, "%s%s", !i ? "" : choices[i + 1] ? ", " : " or ", choices[i]);
}

/* Columns of a terminal, of the help beside an option, and of its further lines. */
enum { COLUMNS = 80, HELP_COLUMN = 30, HELP_INDENT = 31 };

/* Adds the words from a column on, and breaks the lines. */
static void add_words(struct strbuf *out, const char *words)
{
	size_t column = HELP_COLUMN;

	for (const char *word = words; *word; word += strspn(word, " ")) {
		const size_t length = strcspn(word, " ");

		if (word > words && column + 1 + length > COLUMNS) {
			strbuf_addf(out, "\n%*s", HELP_INDENT, "");
			column = HELP_INDENT;
		} else if (word > words) {
			strbuf_add(out, " ", 1);
			column++;
		}
		strbuf_add(out, word, length);
		column += length;
		word += length;
	}
	strbuf_add(out, "\n", 1);
}

/* The help text with its choices. */
static void add_help(struct strbuf *out, const struct option_row *row)
{
	const char *choices = strstr(row->help, "%s");
	struct strbuf words = {0};

	strbuf_add(&words, row->help, choices ? (size_t)(choices - row->help) : strlen(row->help));
	if (choices) {
		add_choices(&words, row->choices);
		strbuf_addf(&words, "%s", choices + 2);
	}
	add_words(out, strbuf_text(&words));
	strbuf_release(&words);
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
		strbuf_addf(out, "%-*s", HELP_COLUMN, name.text);
		if (name.length >= HELP_COLUMN)
			strbuf_addf(out, "\n%*s", HELP_COLUMN, "");
		add_help(out, row);
		strbuf_release(&name);
	}
}
