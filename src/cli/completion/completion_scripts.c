#include "cli/completion/completion_scripts.h"

#include <string.h>

#include "check/finding.h"
#include "report/report.h"

struct completion_scope completion_scope(int i)
{
	const struct command *command = i ? &command_table[i - 1] : NULL;

	if (!command)
		return (struct completion_scope){NULL, option_table, OPTION_COUNT};
	return (struct completion_scope){command, command->options, command->option_count};
}

static void add_word(struct strbuf *words, const char *word)
{
	strbuf_addf(words, "%s%s", words->length ? " " : "", word);
}

enum completion_value completion_value(struct strbuf *words, const struct option_row *row)
{
	if (!row->argument)
		return COMPLETE_NOTHING;
	for (int i = 0; row->choices && row->choices[i]; i++)
		add_word(words, row->choices[i]);
	for (int i = 0; row->kind == VALUE_FORMAT && i < FORMAT_CHOICES; i++)
		add_word(words, report_writers[i]->name);
	for (int i = FINDING_COLLISION; row->kind == VALUE_KINDS && i <= FINDING_START_OVERLAP; i++)
		add_word(words, finding_kind_name((enum finding_kind)i));
	if (words->length)
		return COMPLETE_WORDS;
	if (!strncmp(row->argument, "DIR", 3))
		return COMPLETE_FOLDER;
	return !strncmp(row->argument, "FILE", 4) ? COMPLETE_FILE : COMPLETE_OTHER;
}

/* The help in one line, within single quotes; the characters of `special` get a backslash. */
static void add_help(struct strbuf *out, const char *help, const char *special, const char *quote)
{
	for (; *help; help++) {
		if (*help == '\'')
			strbuf_addf(out, "%s", quote);
		else if (*help == '\n')
			strbuf_addf(out, " ");
		else
			strbuf_addf(out, "%s%c", strchr(special, *help) ? "\\" : "", *help);
	}
}

static void add_choices(struct strbuf *out, const char *const *choices)
{
	for (int i = 0; choices[i]; i++)
		strbuf_addf(out, "%s%s", i ? " " : "", choices[i]);
}

/* "init|completion" and the like. */
static void add_commands(struct strbuf *out, const char *between)
{
	for (int i = 0; i < COMMAND_COUNT; i++)
		strbuf_addf(out, "%s%s", i ? between : "", command_table[i].name);
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

void completion_scripts_bash(struct strbuf *out)
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
	add_commands(out, " | ");
	strbuf_addf(out, ") command=${COMP_WORDS[1]} ;;\n\t\tesac\n\tfi\n"
			 "\t# What the option before it takes; else an option; else an operand.\n"
			 "\tcase $command:$prev in\n");
	for (int i = 0; i <= COMMAND_COUNT; i++) {
		struct completion_scope scope = completion_scope(i);

		for (size_t k = 0; k < scope.count; k++)
			bash_value(out, i ? scope.command->name : "", &scope.options[k]);
	}
	strbuf_addf(out, "\t*) case $command:$cur in\n");
	for (int i = 0; i <= COMMAND_COUNT; i++) {
		struct completion_scope scope = completion_scope(i);

		bash_options(out, &scope);
	}
	for (int i = 0; i < COMMAND_COUNT; i++) {
		if (!command_table[i].choices)
			continue;
		strbuf_addf(out, "\t%s:*) kind= words='", command_table[i].name);
		add_choices(out, command_table[i].choices);
		strbuf_addf(out, "' ;;\n");
	}
	strbuf_addf(out, "\t:*) ((COMP_CWORD > 1)) || words='");
	add_commands(out, " ");
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
	add_help(out, row->help, "[]:\\", "'\\''");
	strbuf_addf(out, "]");
	if (value != COMPLETE_NOTHING) {
		strbuf_addf(out, ":");
		add_help(out, row->argument, "[]:\\", "'\\''");
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
		add_choices(out, choices);
		strbuf_addf(out, ")' ;;\n");
	} else {
		strbuf_addf(out, " \\\n\t\t'*:file:_files' ;;\n");
	}
}

void completion_scripts_zsh(struct strbuf *out)
{
	strbuf_addf(out, "#compdef fivecheck\n"
			 "# Completions of fivecheck for zsh, as 'fivecheck completion zsh' writes them.\n"
			 "_fivecheck()\n{\n\tlocal -a commands\n\tlocal command=\n\tcommands=(");
	for (int i = 0; i < COMMAND_COUNT; i++)
		strbuf_addf(out, " '%s:%s'", command_table[i].name, command_table[i].summary);
	strbuf_addf(out, " )\n\tif (( CURRENT == 2 )); then\n\t\t_describe -t commands command commands\n"
			 "\telif [[ $words[2] == (");
	add_commands(out, "|");
	strbuf_addf(
	    out, ") ]]; then\n\t\tcommand=$words[2]\n\t\tshift words\n\t\t(( CURRENT-- ))\n\tfi\n\tcase $command in\n");
	for (int i = 1; i <= COMMAND_COUNT + 1; i++) {
		struct completion_scope scope = completion_scope(i <= COMMAND_COUNT ? i : 0);

		zsh_scope(out, &scope);
	}
	strbuf_addf(out, "\tesac\n}\n_fivecheck \"$@\"\n");
}

static void fish_option(struct strbuf *out, const struct completion_scope *scope, const struct option_row *row)
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
		add_commands(out, " ");
	strbuf_addf(out, "' -l %s", row->name);
	if (row->key <= 255)
		strbuf_addf(out, " -s %c", row->key);
	if (value == COMPLETE_WORDS)
		strbuf_addf(out, " -x -a '%s'", strbuf_text(&words));
	else
		strbuf_addf(out, "%s", actions[value]);
	strbuf_addf(out, " -d '");
	add_help(out, row->help, "\\", "\\'");
	strbuf_addf(out, "'\n");
	strbuf_release(&words);
}

void completion_scripts_fish(struct strbuf *out)
{
	strbuf_addf(out, "# Completions of fivecheck for fish, as 'fivecheck completion fish' writes them.\n");
	for (int i = 0; i <= COMMAND_COUNT; i++) {
		struct completion_scope scope = completion_scope(i);

		for (size_t k = 0; k < scope.count; k++)
			fish_option(out, &scope, &scope.options[k]);
		if (!scope.command)
			continue;
		strbuf_addf(out, "complete -c fivecheck -n __fish_use_subcommand -a %s -d '%s'\n", scope.command->name,
			    scope.command->summary);
		if (!scope.command->choices)
			continue;
		strbuf_addf(out, "complete -c fivecheck -n '__fish_seen_subcommand_from %s' -f -a '",
			    scope.command->name);
		add_choices(out, scope.command->choices);
		strbuf_addf(out, "'\n");
	}
}
