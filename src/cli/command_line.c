#include "cli/command_line.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "cli/argv_parser.h"
#include "cli/option_table.h"
#include "cli/option_value.h"
#include "cli/program_list.h"
#include "cli/stderr_ui.h"
#include "fivecheck.h"
#include "machine/job_list.h"

struct parser {
	struct options *options;
	struct diag *diag;
	size_t operands, capacity;
	char **operand;	/* owned */
	bool seen[OPTION_COUNT];
	const struct option_row *mode;	/* the option that chose the mode, or NULL */
};

static const struct srcloc nowhere;

static bool set_mode(struct parser *parser, const struct option_row *row)
{
	if (parser->mode && parser->mode != row) {
		diag_error(parser->diag, nowhere, "--%s and --%s cannot be used together", parser->mode->name,
			   row->name);
		return false;
	}
	parser->mode = row;
	parser->options->mode = row->mode;
	return true;
}

static void add_operand(void *context, char *word)
{
	struct parser *parser = context;

	parser->operand = mem_grow(parser->operand, &parser->capacity, parser->operands + 1, sizeof(*parser->operand));
	parser->operand[parser->operands++] = word;
}

static bool is_final(enum run_mode mode)
{
	return mode == RUN_HELP || mode == RUN_VERSION;
}

/* A second setup, list, shard or --fail-on would replace the first, so that less would be checked. */
static bool refuse_second(const struct parser *parser, const struct option_row *row)
{
	if (!parser->seen[row - option_table] ||
	    (row->kind != VALUE_TEXT && row->kind != VALUE_KINDS && row->kind != VALUE_SHARD &&
	     row->kind != VALUE_MODE) ||
	    !row->argument)
		return false;
	diag_error(parser->diag, nowhere, "--%s was given twice, but only one of them can be used", row->name);
	return true;
}

static enum argv_result add_option(void *context, const struct option_row *row, const char *argument)
{
	struct parser *parser = context;

	if (refuse_second(parser, row))
		return ARGV_FAULT;
	parser->seen[row - option_table] = true;
	if (row->kind == VALUE_MODE && is_final(row->mode)) {
		parser->options->mode = row->mode;
		return ARGV_LAST;
	}
	if (row->kind == VALUE_MODE && !set_mode(parser, row))
		return ARGV_FAULT;
	if ((row->kind != VALUE_MODE || argument) && !option_value_set(parser->options, row, argument, parser->diag))
		return ARGV_FAULT;
	return ARGV_NEXT;
}

static bool check_modes(const struct parser *parser)
{
	for (int i = 0; i < OPTION_COUNT; i++) {
		const struct option_row *row = &option_table[i];

		if (!parser->seen[i] || row->modes & 1U << parser->options->mode)
			continue;
		if (parser->mode)
			diag_error(parser->diag, nowhere, "--%s cannot be used with --%s", row->name,
				   parser->mode->name);
		else
			diag_error(parser->diag, nowhere, "--%s cannot be used in a check", row->name);
		return false;
	}
	return true;
}

/* A table has one format, text or json; its file is that of --output. */
static bool check_table_formats(const struct parser *parser)
{
	struct options *o = parser->options;
	struct format_choice *json = &o->formats[FORMAT_JSON], *text = &o->formats[FORMAT_TEXT];
	const char *path = json->path ? json->path : text->path;

	for (int i = 0; i < FORMAT_CHOICES; i++) {
		if (o->formats[i].wanted && i != FORMAT_TEXT && i != FORMAT_JSON) {
			diag_error(parser->diag, nowhere, "--%s has the formats text and json, not %s",
				   parser->mode->name, writer_names[i]);
			return false;
		}
	}
	if ((json->wanted && text->wanted) || (path && o->output)) {
		diag_error(parser->diag, nowhere, "--%s prints one table: give one --format and at most one file",
			   parser->mode->name);
		return false;
	}
	o->output_of_format = path != NULL;
	o->output = path ? path : o->output;
	json->path = text->path = NULL;
	return true;
}

/* Without --format the results are text. One format may have no file: it uses the file of --output. */
static bool check_formats(const struct parser *parser)
{
	struct options *o = parser->options;
	int wanted = 0, unnamed = 0;

	if (o->mode == RUN_DEPENDS)
		return true;
	if (o->mode == RUN_LIST_PAIRS || o->mode == RUN_CHECK_MACHINE)
		return check_table_formats(parser);
	if (o->formats[FORMAT_JSON].wanted) {
		diag_error(parser->diag, nowhere,
			   "--format=json is for --check-machine and --list-pairs; the results of a check "
			   "are JSON with --format=ndjson");
		return false;
	}
	o->formats[FORMAT_RECORD] = (struct format_choice){o->record != NULL, o->record};
	for (int i = 0; i < FORMAT_CHOICES; i++) {
		wanted += o->formats[i].wanted;
		unnamed += o->formats[i].wanted && !o->formats[i].path;
	}
	if (!wanted)
		o->formats[FORMAT_TEXT].wanted = true;
	else if (unnamed > 1)
		diag_error(parser->diag, nowhere,
			   "only one format can go to %s; give the others files: --format=FORMAT=FILE",
			   o->output ? "--output" : "standard output");
	else if (!unnamed && o->output)
		diag_error(parser->diag, nowhere, "every format has its own file, so nothing is written to --output");
	else
		return true;
	return !wanted;
}

static bool names_file(const struct options *o)
{
	bool named = (o->output && strcmp(o->output, "-") != 0) || o->clearance_report || o->timing;

	for (int i = 0; i < FORMAT_COUNT; i++)
		named = named || o->formats[i].path;
	return named;
}

/* "none" must be the only value; "warning" alone means all findings and warnings. */
static bool check_fail_on(const struct parser *parser)
{
	struct options *o = parser->options;

	o->fail_on_warnings = o->fail_on & 1U << FAIL_ON_WARNING;
	o->fail_on &= ~(1U << FAIL_ON_WARNING);
	if (!(o->fail_on & 1U << FAIL_ON_NONE) || (o->fail_on == 1U << FAIL_ON_NONE && !o->fail_on_warnings))
		return true;
	diag_error(parser->diag, nowhere, "--fail-on: none cannot be used together with other kinds");
	return false;
}

static bool ends_in(const char *path, const char *ending)
{
	const size_t length = strlen(path), tail = strlen(ending);

	return length > tail && !strcmp(path + length - tail, ending);
}

static bool check_combinations(const struct parser *parser)
{
	const struct options *o = parser->options;
	const char *fault = NULL;

	if (o->quiet && o->verbose)
		fault = "--quiet and --verbose cannot be used together";
	else if (o->check.step > 0 && o->check.method == CHECK_CERTIFIED)
		fault = "--step needs a sampled method: --method=interpolated or --method=conventional";
	else if (o->verbose && o->check.method != CHECK_CERTIFIED)
		fault = "--verbose prints proven clearances, but the sampled methods prove nothing";
	else if (o->verbose && !o->formats[FORMAT_TEXT].wanted)
		fault = "--verbose needs --format=text";
	else if (o->quiet && o->progress == PROGRESS_PLAIN)
		fault = "--quiet and --progress=plain cannot be used together";
	else if (o->depfile && !names_file(o))
		fault = "--depfile needs an output file: --output or --format=FORMAT=FILE";
	else if (o->depfile && !strcmp(o->depfile, "-"))
		fault = "--depfile needs the name of a file: standard output gets the report";
	else if (o->record && !strcmp(o->record, "-"))
		fault = "--record needs the name of a file: standard output gets the report";
	else if (o->pose && !strcmp(o->pose, "-"))
		fault = "--pose needs the name of a file: standard output gets the report";
	else if (o->stock_out && !strcmp(o->stock_out, "-"))
		fault = "--stock-out needs the name of a file: standard output gets the report";
	else if (o->clearance_report && o->check.method != CHECK_CERTIFIED)
		fault = "--clearance-report lists proven clearances, but the sampled methods prove nothing";
	else if (o->check.block_clearance_cap > 0 && !o->clearance_report)
		fault = "--clearance-cap needs --clearance-report";
	else if (o->report && !strcmp(o->report, "-"))
		fault = "--report needs the name of a file: standard output gets the report";
	else if (o->glb && !strcmp(o->glb, "-"))
		fault = "--glb needs the name of a file: standard output gets the report";
	else if (o->picture && !ends_in(o->picture, ".svg") && !ends_in(o->picture, ".png"))
		fault = "--picture needs the name of a file that ends in .svg or .png";
	else if (!o->report && (o->report_size > 0 || o->report_code == REPORT_CODE_NONE))
		fault = "--report-size and --report-code need --report";
	else if (options_want_sensitivity(o) && o->check.method != CHECK_CERTIFIED)
		fault = "--sensitivity is about a proof, but the sampled methods prove nothing";
	else if (options_want_sensitivity(o) && !o->formats[FORMAT_TEXT].wanted && !o->formats[FORMAT_NDJSON].wanted)
		fault = "--sensitivity needs --format=text or --format=ndjson";
	else if (options_want_sensitivity(o) && (o->waivers || o->fail_on))
		fault = "--sensitivity cannot be used together with --waivers or --fail-on, because it ignores them";
	else if ((o->clearance_report && !strcmp(o->clearance_report, "-")) || (o->timing && !strcmp(o->timing, "-")))
		fault = "--clearance-report and --timing need the name of a file: standard output gets the report";
	if (fault)
		diag_error(parser->diag, nowhere, "%s", fault);
	return !fault;
}

/* A job file contains the names of its programs. */
static bool check_jobs(const struct parser *parser)
{
	const struct options *o = parser->options;

	if (o->program_count || o->files_from)
		diag_error(parser->diag, nowhere, "%s is a job file, which names its programs: give no others",
			   o->machine);
	else if (o->mode != RUN_CHECK && o->mode != RUN_PARSE_ONLY && o->mode != RUN_DEPENDS)
		diag_error(parser->diag, nowhere, "--%s takes a machine file, but %s is a job file", parser->mode->name,
			   o->machine);
	else
		return true;
	return false;
}

static bool check_operands(const struct parser *parser)
{
	const struct options *o = parser->options;
	bool runs = o->mode == RUN_CHECK || o->mode == RUN_PARSE_ONLY || o->mode == RUN_DUMP_PATH;
	size_t inputs = 0;

	assert(runs || parser->mode);
	if (o->mode == RUN_EXPLAIN) {
		if (o->machine)
			diag_error(parser->diag, nowhere, "--explain takes no file, but %s was given", o->machine);
		return !o->machine;
	}
	for (size_t i = 0; i < o->program_count; i++)
		inputs += !strcmp(o->programs[i], "-");
	if (!o->machine)
		diag_error(parser->diag, nowhere,
			   "no machine file was given ('fivecheck init' writes one to begin with)");
	else if (!strcmp(o->machine, "-") || (o->setup && !strcmp(o->setup, "-")))
		diag_error(parser->diag, nowhere,
			   "the machine and the setup cannot be read from standard input, only a program can");
	else if (o->jobs)
		return check_jobs(parser);
	else if (runs && !o->program_count && !o->files_from)
		diag_error(parser->diag, nowhere, "no program was given (- is standard input)");
	else if (!runs && o->program_count && o->mode != RUN_DEPENDS)
		diag_error(parser->diag, nowhere, "--%s takes no program, but %s was given", parser->mode->name,
			   o->programs[0]);
	else if (o->mode == RUN_DUMP_PATH && o->program_count > 1)
		diag_error(parser->diag, nowhere, "--dump-path takes one program");
	else if (o->stock_out && o->program_count > 1)
		diag_error(parser->diag, nowhere,
			   "--stock-out takes one program: each begins with the blank of the setup");
	else if (inputs > 0 && o->record)
		diag_error(parser->diag, nowhere,
			   "--record cannot record a program from standard input: give it as a file");
	else if (inputs > 0 && o->files_from && !strcmp(o->files_from, "-"))
		diag_error(parser->diag, nowhere,
			   "standard input cannot be both a program and the list of --files-from");
	else if (inputs > 1)
		diag_error(parser->diag, nowhere, "- was given twice, but standard input can be read only once");
	else
		return true;
	return false;
}

/* An empty list would pass any gate. The list may also name standard input a second time. */
static bool check_listed(const struct parser *parser)
{
	const struct options *o = parser->options;

	if (!o->program_count)
		diag_error(parser->diag, nowhere, "the list %s names no program", o->files_from);
	return o->program_count > 0 && check_operands(parser);
}

/* --shard K/N: a part of the programs, or of the blocks of a single program. */
static bool apply_shard(const struct parser *parser)
{
	struct options *o = parser->options;

	if (!o->shards || o->program_count > 1) {
		program_list_take_shard(o);
		return true;
	}
	o->check.shard = o->shard;
	o->check.shards = o->shards;
	if (o->shards > 1 && o->waivers) {
		diag_error(
		    parser->diag, nowhere,
		    "--waivers cannot be used with --shard of one program: each shard would accept a finding that may "
		    "be accepted only once");
		return false;
	}
	if (o->shards > 1 &&
	    (o->clearance_report || o->timing || options_want_visual(o) || options_want_sensitivity(o))) {
		diag_error(parser->diag, nowhere,
			   "--%s cannot be used with --shard of one program, because it needs all blocks",
			   o->clearance_report ? "clearance-report"
			   : o->timing	       ? "timing"
			   : o->report	       ? "report"
			   : o->glb	       ? "glb"
			   : o->picture	       ? "picture"
					       : "sensitivity");
		return false;
	}
	return true;
}

bool command_line_parse(struct options *options, int argc, char **argv, struct diag *diag)
{
	struct parser parser = {.options = options, .diag = diag};
	const struct argv_parser words = {option_table, OPTION_COUNT, add_option, add_operand, &parser};
	bool good;

	*options = (struct options){.check = {.tolerance = FIVECHECK_TOLERANCE, .threads = 1}, .dialect = -1};
	good = argv_parser_run(&words, argc, argv, diag);
	options->programs = parser.operand;
	if (parser.operands) {
		options->machine = parser.operand[0];
		options->program_count = parser.operands - 1;
		options->jobs = job_list_is(options->machine);
		memmove(parser.operand, parser.operand + 1, options->program_count * sizeof(*parser.operand));
	}
	if (!good || is_final(options->mode))
		return good;
	if (!check_modes(&parser) || !check_formats(&parser) || !check_fail_on(&parser) ||
	    !check_combinations(&parser) || !check_operands(&parser))
		return false;
	if (options->files_from && (!program_list_read(options, diag) || !check_listed(&parser)))
		return false;
	if (options->output && !strcmp(options->output, "-"))
		options->output = NULL;
	if (!(options->check.step > 0))
		options->check.step = 0.01;
	if (options->mode == RUN_PARSE_ONLY)
		options->check.method = CHECK_NOTHING;
	if (!(options->check.block_clearance_cap > 0))
		options->check.block_clearance_cap = 10;
	if (!(options->report_size > 0))
		options->report_size = 5;
	options->check.least_clearances = !options->clearance_report;
	options->check.block_clearances =
	    options->clearance_report || (options_want_visual(options) && options->check.method == CHECK_CERTIFIED);
	options->check.times = options->timing;
	options->check.read.includes = options->includes.items;
	options->check.read.include_count = options->includes.count;
	options->check.read.last_duplicate_wins = options->duplicates == 1;
	return apply_shard(&parser);
}

void command_line_help(struct strbuf *out, const struct command *commands)
{
	strbuf_addf(out, "Usage: fivecheck [OPTIONS] MACHINE.xml PART.nc...\n"
			 "       fivecheck [OPTIONS] JOBS.xml\n");
	for (const struct command *command = commands; command->name; command++)
		strbuf_addf(out, "       fivecheck %-10s %-7s %s\n", command->name, command->operands,
			    command->summary);
	strbuf_addf(out,
		    "Proves that a machine does not hit itself while it runs the programs, or names\n"
		    "the first block in which it does. A program named - is standard input.\n\n");
	argv_parser_help(out, option_table, OPTION_COUNT);
	strbuf_addf(out, "\nExit status: 0 every program is clear, 1 something was found, 2 the check is\n"
			 "incomplete (usage, unreadable or unsupported input), 3 internal error.\n");
}
