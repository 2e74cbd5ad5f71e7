#include "cli/init/init.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/argv_parser.h"
#include "cli/init/init_prompts.h"
#include "cli/init/machine_plan_finish.h"
#include "cli/init/machine_plan_set.h"
#include "cli/init/machine_plan_xml.h"
#include "report/output.h"

static const struct srcloc nowhere;

/* The default output if standard output is a terminal. */
static const char usual_file[] = "machine.xml";

struct request {
	struct machine_plan plan;
	struct diag *diag;
	const char *output;	/* borrowed; NULL: standard output */
	bool help;
	bool good;	/* of the operands */
};

static void take_operand(void *context, char *word)
{
	struct request *request = context;

	if (request->plan.family < 0 && request->good) {
		request->good = machine_plan_set(&request->plan, init_options_row(PLAN_FAMILY), word, request->diag);
		return;
	}
	if (request->good)
		diag_error(request->diag, nowhere, "init takes one family, but '%s' was named as well", word);
	request->good = false;
}

static enum argv_result take_option(void *context, const struct option_row *row, const char *argument)
{
	struct request *request = context;

	if (row->key == PLAN_HELP) {
		request->help = true;
		return ARGV_LAST;
	}
	if (row->key != PLAN_OUTPUT)
		return machine_plan_set(&request->plan, row, argument, request->diag) ? ARGV_NEXT : ARGV_FAULT;
	request->output = strcmp(argument, "-") ? argument : NULL;
	return ARGV_NEXT;
}

static bool is_new(const char *path, struct diag *diag)
{
	struct stat status;

	if (!path || stat(path, &status) != 0 || !S_ISREG(status.st_mode))
		return true;
	diag_error(diag, nowhere, "%s already exists and may have been edited: remove it, or name another file with "
				  "--output", path);
	return false;
}

static bool write_file(const char *path, struct strbuf *text, struct diag *diag)
{
	struct output out;
	bool good = is_new(path, diag) && output_open(&out, path, diag);

	if (good) {
		output_text(&out, text);
		good = output_commit(&out, diag);
	}
	strbuf_release(text);
	return good;
}

/* Does the mesh exist? Its path is relative to the folder of the machine file. */
static bool has_mesh(const char *output, const char *mesh)
{
	const char *slash = output && *mesh != '/' ? strrchr(output, '/') : NULL;
	struct strbuf path = {0};
	bool there;

	strbuf_addf(&path, "%.*s%s", slash ? (int)(slash - output + 1) : 0, slash ? output : "", mesh);
	there = access(strbuf_text(&path), R_OK) == 0;
	strbuf_release(&path);
	return there;
}

/* Prints the chains of axes and the next steps. */
static void tell(const struct machine_plan *plan, const char *output, struct diag *diag)
{
	const char *name = output ? output : "MACHINE.xml";
	struct strbuf text = {0}, missing = {0};

	machine_plan_xml_chains(&text, plan);
	diag_note(diag, nowhere, "%s", strbuf_text(&text));
	for (size_t i = 0; i < plan->body_count; i++) {
		if (!has_mesh(output, plan->bodies[i].path))
			strbuf_addf(&missing, "%s%s", missing.length ? ", " : "", plan->bodies[i].path);
	}
	if (missing.length)
		diag_note(diag, nowhere,
			  "next: with every axis at 0, export these meshes from the CAD assembly, or change "
			  "their names in %s: %s",
			  name, strbuf_text(&missing));
	diag_note(diag, nowhere, "%s: look through the TODO lines of %s and run 'fivecheck --check-machine %s'",
		  missing.length ? "then" : "next", name, name);
	strbuf_release(&text);
	strbuf_release(&missing);
}

/* The questions go to the terminal, so the machine file goes to a file unless --output says otherwise. */
static bool ask(struct request *request)
{
	if (!isatty(STDIN_FILENO))
		return init_prompts_report(&request->plan, request->diag);
	if (!init_prompts_are_missing(&request->plan))
		return true;
	if (!init_prompts_ask(&request->plan, stdin, request->diag))
		return false;
	if (!request->output && isatty(STDOUT_FILENO))
		request->output = usual_file;
	return true;
}

static enum run_status make_file(struct request *request)
{
	struct strbuf text = {0};

	/* Check the output file before the user answers questions. */
	if (!is_new(request->output, request->diag) || !ask(request) ||
	    !machine_plan_finish(&request->plan, request->diag))
		return RUN_INCOMPLETE;
	machine_plan_xml_write(&text, &request->plan);
	if (!write_file(request->output, &text, request->diag))
		return RUN_INCOMPLETE;
	tell(&request->plan, request->output, request->diag);
	return RUN_CLEAR;
}

static enum run_status print_help(struct diag *diag)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "Usage: fivecheck init [OPTIONS] FAMILY\n"
			   "Writes a commented machine file to begin with. The family is table-table, head-head or\n"
			   "head-table: what the two rotary axes turn; or nutating-table or nutating-head, where one of\n"
			   "them stands oblique. Give everything in machine coordinates with every axis at 0. On a\n"
			   "terminal, init asks for what is missing; otherwise that is an error.\n\n");
	argv_parser_help(&text, init_options, INIT_OPTION_COUNT);
	strbuf_addf(&text, "\nfivecheck init table-table --rotary=A,C --limits=X=-300:300,Y=-250:250,Z=-400:0 \\\n"
			   "    --limits=A=-120:30,C=none --location=A=0,0,120 --location=C=0,0,120 \\\n"
			   "    --spindle=0,0,520 --output=machine.xml\n");
	return output_print(&text, diag) ? RUN_CLEAR : RUN_INCOMPLETE;
}

enum run_status init_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct request request = {.diag = &ui->diag, .good = true};
	struct argv_parser words = {init_options, INIT_OPTION_COUNT, take_option, take_operand, &request};
	enum run_status status = RUN_INCOMPLETE;

	(void)all;
	machine_plan_init(&request.plan);
	if (argv_parser_run(&words, argc, argv, &ui->diag) && request.good)
		status = request.help ? print_help(&ui->diag) : make_file(&request);
	if (status == RUN_INCOMPLETE)
		diag_note(&ui->diag, nowhere, "'fivecheck init --help' lists the options");
	machine_plan_release(&request.plan);
	return status;
}
