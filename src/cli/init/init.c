#include "cli/init/init.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/init/init_prompts.h"
#include "cli/init/machine_plan_finish.h"
#include "cli/init/machine_plan_set.h"
#include "cli/init/machine_plan_xml.h"
#include "cli/subcommand.h"
#include "machine/machine.h"
#include "report/output.h"

static const struct srcloc nowhere;

/* The default output if standard output is a terminal. */
static const char usual_file[] = "machine.xml";

struct request {
	struct init_request words;
	struct machine_plan plan;
	struct diag *diag;
};

static const struct subcommand subcommand = {
	.name = "init",
	.usage = "Usage: fivecheck init [OPTIONS] FAMILY\n"
		 "Writes a commented machine file as a start. The family says what the two rotary\n"
		 "axes turn: table-table, head-head or head-table; or nutating-table or\n"
		 "nutating-head if one of them is oblique. All points are in machine coordinates\n"
		 "with every axis at 0. On a terminal, init asks for missing values; otherwise a\n"
		 "missing value is an error.\n",
	.examples = "fivecheck init table-table --rotary=A,C --limits=X=-300:300,Y=-250:250 \\\n"
		    "    --limits=Z=-400:0,A=-120:30,C=none --location=A=0,0,120 \\\n"
		    "    --location=C=0,0,120 --spindle=0,0,520 --output=machine.xml\n",
	.options = init_options,
	.option_count = INIT_OPTION_COUNT,
};

/* Fills the plan from the words. False: reported. */
static bool take_words(struct request *request, const struct operands *operands)
{
	const struct init_request *words = &request->words;

	if (operands->count > 1) {
		diag_error(request->diag, nowhere, "init takes one family, but '%s' was given too",
			   operands->items[1]);
		return false;
	}
	if (operands->count && !machine_plan_set(&request->plan, init_options_row(PLAN_FAMILY), operands->items[0],
						 request->diag))
		return false;
	for (int key = PLAN_FAMILY + 1; key < PLAN_KEY_END; key++) {
		const struct text_list *list = &words->given[key - PLAN_FAMILY];

		for (size_t i = 0; i < list->count; i++)
			if (!machine_plan_set(&request->plan, init_options_row((enum machine_plan_key)key),
					      list->items[i], request->diag))
				return false;
	}
	return true;
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
static void tell_next_steps(const struct machine_plan *plan, const char *output, struct diag *diag)
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
	diag_note(diag, nowhere, "%s: verify the TODO lines of %s and run 'fivecheck --check-machine %s'",
		  missing.length ? "then" : "next", name, name);
	strbuf_release(&text);
	strbuf_release(&missing);
}

/* The questions go to the terminal, so the machine file goes to a file unless --output says otherwise. */
static bool ask_questions(struct request *request)
{
	if (!isatty(STDIN_FILENO))
		return init_prompts_report(&request->plan, request->diag);
	if (!init_prompts_are_missing(&request->plan))
		return true;
	if (!init_prompts_ask(&request->plan, stdin, request->diag))
		return false;
	if (!request->words.output && isatty(STDOUT_FILENO))
		request->words.output = usual_file;
	return true;
}

/* If the reader of machine files rejects an answer, this is reported at the option: the file is not written. */
static void pass_fault(void *context, const struct diag_entry *entry)
{
	if (entry->severity == DIAG_ERROR)
		diag_error(context, nowhere, "--controller: %s", entry->text);
}

static enum run_status make_file(struct request *request)
{
	struct diag faults = {.handle = pass_fault, .context = request->diag};
	struct strbuf text = {0};

	/* Check the output file before the user answers questions. */
	if (!is_new(request->words.output, request->diag) || !ask_questions(request) ||
	    !machine_plan_finish(&request->plan, request->diag))
		return subcommand_refuse(&subcommand, request->diag);
	machine_plan_xml_write(&text, &request->plan);
	if (request->plan.answer_count && !machine_check_controller(strbuf_text(&text), &faults)) {
		strbuf_release(&text);
		return subcommand_refuse(&subcommand, request->diag);
	}
	if (!write_file(request->words.output, &text, request->diag))
		return RUN_INCOMPLETE;
	tell_next_steps(&request->plan, request->words.output, request->diag);
	return RUN_CLEAR;
}

enum run_status init_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct request request = {.diag = &ui->diag};
	struct operands operands = {0};
	enum run_status status;

	(void)all;
	machine_plan_init(&request.plan);
	if (subcommand_read(&subcommand, &request.words, &operands, argc, argv, &ui->diag, &status)) {
		status = take_words(&request, &operands) ? make_file(&request) :
							   subcommand_refuse(&subcommand, &ui->diag);
	}
	for (int i = 0; i < PLAN_KEY_END - PLAN_FAMILY; i++)
		free(request.words.given[i].items);
	operands_release(&operands);
	machine_plan_release(&request.plan);
	return status;
}
