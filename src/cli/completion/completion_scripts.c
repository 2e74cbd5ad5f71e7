#include "cli/completion/completion_scripts.h"

#include <stddef.h>
#include <string.h>

#include "cli/option_table.h"

/* The kind of an option's argument. */
enum completion_value { COMPLETE_NOTHING, COMPLETE_WORDS, COMPLETE_FILE, COMPLETE_FOLDER, COMPLETE_OTHER };

/* Options of one subcommand, or of a check. */
struct completion_scope {
	const struct command *command;	/* NULL: a check */
	const struct option_row *options;
	size_t count;
};

static struct completion_scope scope_of(const struct command *command)
{
	return (struct completion_scope){command, command->options, command->option_count};
}

static const struct completion_scope check_scope = {NULL, option_table, OPTION_COUNT};

static void add_word(struct strbuf *words, const char *word)
{
	strbuf_addf(words, "%s%s", words->length ? " " : "", word);
}

/* The kind of the option's argument; its words are appended, separated by blanks. */
static enum completion_value completion_value(struct strbuf *words, const struct option_row *row)
{
	if (!row->argument)
		return COMPLETE_NOTHING;
	for (int i = 0; row->choices && row->choices[i]; i++)
		add_word(words, row->choices[i]);
	if (row->other_choice)
		add_word(words, row->other_choice);
	if (words->length)
		return COMPLETE_WORDS;
	if (!strncmp(row->argument, "DIR", 3))
		return COMPLETE_FOLDER;
	return !strncmp(row->argument, "FILE", 4) ? COMPLETE_FILE : COMPLETE_OTHER;
}

static void add_choices(struct strbuf *out, const char *const *choices, const char *between)
{
	for (int i = 0; choices[i]; i++)
		strbuf_addf(out, "%s%s", i ? between : "", choices[i]);
}

/* The help in one line, within single quotes; the characters of `special` get a backslash. */
static void add_help(struct strbuf *out, const struct option_row *row, const char *special, const char *quote)
{
	for (const char *help = row->help; *help; help++) {
		if (*help == '%' && help[1] == 's' && help++)
			add_choices(out, row->choices, ", ");
		else if (*help == '\'')
			strbuf_addf(out, "%s", quote);
		else
			strbuf_addf(out, "%s%c", strchr(special, *help) ? "\\" : "", *help);
	}
}

/* "init|completion" and the like. */
static void add_commands(struct strbuf *out, const struct command *commands, const char *between)
{
	for (int i = 0; commands[i].name; i++)
		strbuf_addf(out, "%s%s", i ? between : "", commands[i].name);
}

static void bash_options(struct strbuf *out, const struct completion_scope *scope)
{
	strbuf_addf(out, "\t%s:-*) words='", scope->command ? scope->command->name : "");
	for (size_t i = 0; i < scope->count; i++) {
		const struct option_row *row = &scope->options[i];

		if (row->key <= 255)
			strbuf_addf(out, "-%c ", row->key);
		strbuf_addf(out, "--%s%s", row->name, i + 1 < scope->count ? " " : "");
	}
	strbuf_addf(out, "' ;;\n");
}

static void bash_value(struct strbuf *out, const char *command, const struct option_row *row)
{
	static const char *const actions[] = {
		[COMPLETE_FILE] = "kind=-f", [COMPLETE_FOLDER] = "kind=-d", [COMPLETE_OTHER] = "kind="};
	struct strbuf words = {0};
	enum completion_value value = completion_value(&words, row);

	if (value != COMPLETE_NOTHING) {
		strbuf_addf(out, "\t%s:--%s", command, row->name);
		if (row->key <= 255)
			strbuf_addf(out, " | %s:-%c", command, row->key);
		if (value == COMPLETE_WORDS)
			strbuf_addf(out, ") kind= words='%s' ;;\n", strbuf_text(&words));
		else
			strbuf_addf(out, ") %s ;;\n", actions[value]);
	}
	strbuf_release(&words);
}

static void bash_values(struct strbuf *out, const struct completion_scope *scope)
{
	for (size_t i = 0; i < scope->count; i++)
		bash_value(out, scope->command ? scope->command->name : "", &scope->options[i]);
}

void completion_scripts_bash(struct strbuf *out, const struct command *commands)
{
	strbuf_addf(out,
		    "# Completions of fivecheck for bash, as 'fivecheck completion bash' writes them.\n"
		    "_fivecheck()\n{\n"
		    "\tlocal cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command= words= kind=-f "
		    "IFS=$' \\t\\n'\n"
		    "\t# bash takes --option=value apart at the =.\n"
		    "\tif [[ $cur == = ]]; then\n\t\tcur=\n"
		    "\telif [[ $prev == = && $COMP_CWORD -gt 1 ]]; then\n\t\tprev=${COMP_WORDS[COMP_CWORD - 2]}\n\tfi\n"
		    "\tif ((COMP_CWORD > 1)); then\n\t\tcase ${COMP_WORDS[1]} in\n\t\t");
	add_commands(out, commands, " | ");
	strbuf_addf(out, ") command=${COMP_WORDS[1]} ;;\n\t\tesac\n\tfi\n"
			 "\t# What the option before it takes; else an option; else an operand.\n"
			 "\tcase $command:$prev in\n");
	bash_values(out, &check_scope);
	for (const struct command *c = commands; c->name; c++) {
		struct completion_scope scope = scope_of(c);

		bash_values(out, &scope);
	}
	strbuf_addf(out, "\t*) case $command:$cur in\n");
	bash_options(out, &check_scope);
	for (const struct command *c = commands; c->name; c++) {
		struct completion_scope scope = scope_of(c);

		bash_options(out, &scope);
	}
	for (const struct command *c = commands; c->name; c++) {
		if (!c->choices)
			continue;
		strbuf_addf(out, "\t%s:*) kind= words='", c->name);
		add_choices(out, c->choices, " ");
		strbuf_addf(out, "' ;;\n");
	}
	strbuf_addf(out, "\t:*) ((COMP_CWORD > 1)) || words='");
	add_commands(out, commands, " ");
	strbuf_addf(out, "' ;;\n\tesac ;;\n\tesac\n"
			 "\tCOMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
			 "\tif [[ $kind && $cur != -* ]]; then\n"
			 "\t\tlocal IFS=$'\\n'\n"
			 "\t\tcompopt -o filenames 2>/dev/null\n"
			 "\t\tCOMPREPLY+=($(compgen \"$kind\" -- \"$cur\"))\n"
			 "\tfi\n}\ncomplete -F _fivecheck fivecheck\n");
}

static void zsh_option(struct strbuf *out, const struct option_row *row)
{
	static const char *const actions[] = {
		[COMPLETE_FILE] = "_files", [COMPLETE_FOLDER] = "_files -/", [COMPLETE_OTHER] = " "};
	struct strbuf words = {0};
	enum completion_value value = completion_value(&words, row);

	strbuf_addf(out, " \\\n\t\t'*'");
	if (row->key <= 255)
		strbuf_addf(out, "{-%c%s,--%s%s}", row->key, row->argument ? "+" : "", row->name,
			    row->argument ? "=" : "");
	else
		strbuf_addf(out, "--%s%s", row->name, row->argument ? "=" : "");
	strbuf_addf(out, "'[");
	add_help(out, row, "[]:\\", "'\\''");
	strbuf_addf(out, "]");
	if (value != COMPLETE_NOTHING) {
		strbuf_addf(out, ":");
		strbuf_addf(out, "%s", row->argument);
	}
	if (value == COMPLETE_WORDS)
		strbuf_addf(out, ":(%s)", strbuf_text(&words));
	else if (value != COMPLETE_NOTHING)
		strbuf_addf(out, ":%s", actions[value]);
	strbuf_addf(out, "'");
	strbuf_release(&words);
}

static void zsh_scope(struct strbuf *out, const struct completion_scope *scope)
{
	const char *const *choices = scope->command ? scope->command->choices : NULL;

	strbuf_addf(out, "\t%s)\n\t\t_arguments -s", scope->command ? scope->command->name : "*");
	for (size_t i = 0; i < scope->count; i++)
		zsh_option(out, &scope->options[i]);
	if (choices) {
		strbuf_addf(out, " \\\n\t\t'1:%s:(", scope->command->operands);
		add_choices(out, choices, " ");
		strbuf_addf(out, ")' ;;\n");
	} else {
		strbuf_addf(out, " \\\n\t\t'*:file:_files' ;;\n");
	}
}

void completion_scripts_zsh(struct strbuf *out, const struct command *commands)
{
	strbuf_addf(out, "#compdef fivecheck\n"
			 "# Completions of fivecheck for zsh, as 'fivecheck completion zsh' writes them.\n"
			 "_fivecheck()\n{\n\tlocal -a commands\n\tlocal command=\n\tcommands=(");
	for (const struct command *c = commands; c->name; c++)
		strbuf_addf(out, " '%s:%s'", c->name, c->summary);
	strbuf_addf(out, " )\n\tif (( CURRENT == 2 )); then\n\t\t_describe -t commands command commands\n"
			 "\telif [[ $words[2] == (");
	add_commands(out, commands, "|");
	strbuf_addf(
	    out, ") ]]; then\n\t\tcommand=$words[2]\n\t\tshift words\n\t\t(( CURRENT-- ))\n\tfi\n\tcase $command in\n");
	for (const struct command *c = commands; c->name; c++) {
		struct completion_scope scope = scope_of(c);

		zsh_scope(out, &scope);
	}
	zsh_scope(out, &check_scope);
	strbuf_addf(out, "\tesac\n}\n_fivecheck \"$@\"\n");
}

static void fish_option(struct strbuf *out, const struct command *commands, const struct completion_scope *scope,
			const struct option_row *row)
{
	static const char *const actions[] = {
		[COMPLETE_NOTHING] = "",
		[COMPLETE_FILE] = " -r -F",
		[COMPLETE_FOLDER] = " -x -a '(__fish_complete_directories)'",
		[COMPLETE_OTHER] = " -x",
	};
	struct strbuf words = {0};
	enum completion_value value = completion_value(&words, row);

	strbuf_addf(out, "complete -c fivecheck -n '%s__fish_seen_subcommand_from ", scope->command ? "" : "not ");
	if (scope->command)
		strbuf_addf(out, "%s", scope->command->name);
	else
		add_commands(out, commands, " ");
	strbuf_addf(out, "' -l %s", row->name);
	if (row->key <= 255)
		strbuf_addf(out, " -s %c", row->key);
	if (value == COMPLETE_WORDS)
		strbuf_addf(out, " -x -a '%s'", strbuf_text(&words));
	else
		strbuf_addf(out, "%s", actions[value]);
	strbuf_addf(out, " -d '");
	add_help(out, row, "\\", "\\'");
	strbuf_addf(out, "'\n");
	strbuf_release(&words);
}

static void fish_options(struct strbuf *out, const struct command *commands, const struct completion_scope *scope)
{
	for (size_t i = 0; i < scope->count; i++)
		fish_option(out, commands, scope, &scope->options[i]);
}

void completion_scripts_fish(struct strbuf *out, const struct command *commands)
{
	strbuf_addf(out, "# Completions of fivecheck for fish, as 'fivecheck completion fish' writes them.\n");
	fish_options(out, commands, &check_scope);
	for (const struct command *c = commands; c->name; c++) {
		struct completion_scope scope = scope_of(c);

		fish_options(out, commands, &scope);
		strbuf_addf(out, "complete -c fivecheck -n __fish_use_subcommand -a %s -d '%s'\n", c->name, c->summary);
		if (!c->choices)
			continue;
		strbuf_addf(out, "complete -c fivecheck -n '__fish_seen_subcommand_from %s' -f -a '", c->name);
		add_choices(out, c->choices, " ");
		strbuf_addf(out, "'\n");
	}
}
