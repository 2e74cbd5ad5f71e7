#include "motion/motion.h"

#include <stdlib.h>

#include "base/mem.h"
#include "gcode/dialect/dialects.h"
#include "gcode/interp.h"
#include "motion/drive.h"

static enum gcode_wrap wrap_of(enum wrap wrap)
{
	switch (wrap) {
	case WRAP_SHORTEST:
		return GCODE_WRAP_SHORTEST;
	case WRAP_SIGN:
		return GCODE_WRAP_SIGN;
	case WRAP_NONE:
		break;
	}
	return GCODE_WRAP_NONE;
}

static enum gcode_mcode mcode_of(enum mcode_action action)
{
	switch (action) {
	case MCODE_TCP_ON:
		return GCODE_TCP_ON;
	case MCODE_TCP_OFF:
		return GCODE_TCP_OFF;
	case MCODE_IGNORE:
		break;
	}
	return GCODE_IGNORE;
}

static enum gcode_answer answer_of(enum answer answer)
{
	switch (answer) {
	case ANSWER_YES:
		return GCODE_YES;
	case ANSWER_NO:
		return GCODE_NO;
	case ANSWER_UNKNOWN:
		break;
	}
	return GCODE_UNKNOWN;
}

static struct gcode_place place_of(const struct machine_place *place)
{
	struct gcode_place made = {.given = place->given, .value = place->value, .order_count = place->order_count};

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		made.has[slot] = place->has[slot];
		made.order[slot] = place->order[slot];
	}
	return made;
}

/* The interpreter's config, and the tables that it borrows. */
struct glue {
	struct gcode_config config;
	struct gcode_mcode_meaning *mcodes;
	struct gcode_work_offset *offsets;
	struct gcode_tool *tools;
	struct gcode_length *lengths;
};

static void glue_machine(struct glue *glue, const struct machine *machine)
{
	const struct controller *controller = &machine->controller;
	struct gcode_config *config = &glue->config;

	config->dialect = dialect_of_row(controller->dialect);
	config->tcp_zero_offset = controller->tcp_zero_offset;
	config->home = machine_home(machine);
	config->unit = machine->unit;
	config->least_input = controller->least_input;
	config->length_moves = answer_of(controller->length_moves);
	for (int i = 0; i < REFERENCE_COUNT; i++)
		config->references[i] = place_of(&controller->references[i]);
	config->tool_change = place_of(&controller->tool_change);
	for (size_t i = 0; i < machine->axis_count; i++) {
		config->has_axis[machine->axes[i].slot] = true;
		config->wrap[machine->axes[i].slot] = wrap_of(machine->axes[i].wrap);
		config->half_turn[machine->axes[i].slot] = machine->axes[i].half_turn;
	}
	glue->mcodes = mem_zalloc(controller->mcode_count, sizeof(*glue->mcodes));
	for (size_t i = 0; i < controller->mcode_count; i++)
		glue->mcodes[i] = (struct gcode_mcode_meaning){controller->mcodes[i].number,
							       mcode_of(controller->mcodes[i].action)};
	config->mcodes = glue->mcodes;
	config->mcode_count = controller->mcode_count;
}

static void glue_setup(struct glue *glue, const struct setup *setup)
{
	struct gcode_config *config = &glue->config;

	config->has_setup = true;
	config->initial_tool = setup->initial_tool;
	glue->offsets = mem_zalloc(setup->offset_count, sizeof(*glue->offsets));
	for (size_t i = 0; i < setup->offset_count; i++)
		glue->offsets[i] = (struct gcode_work_offset){setup->offsets[i].name, setup->offsets[i].value};
	config->work_offsets = glue->offsets;
	config->work_offset_count = setup->offset_count;
	glue->tools = mem_zalloc(setup->tool_count, sizeof(*glue->tools));
	for (size_t i = 0; i < setup->tool_count; i++)
		glue->tools[i] = (struct gcode_tool){setup->tools[i].number, setup->tools[i].length_offset,
						     setup->tools[i].diameter};
	config->tools = glue->tools;
	config->tool_count = setup->tool_count;
	glue->lengths = mem_zalloc(setup->length_count, sizeof(*glue->lengths));
	for (size_t i = 0; i < setup->length_count; i++)
		glue->lengths[i] = (struct gcode_length){setup->lengths[i].number, setup->lengths[i].length};
	config->lengths = glue->lengths;
	config->length_count = setup->length_count;
}

static void glue_change(struct glue *glue, const struct setup_change *change)
{
	glue->config.work_change = change->work;
	for (size_t i = 0; i < glue->config.tool_count; i++)
		glue->tools[i].length_offset += change->length;
	for (size_t i = 0; i < glue->config.length_count; i++)
		glue->lengths[i].length += change->length;
}

static void glue_release(struct glue *glue)
{
	free(glue->mcodes);
	free(glue->offsets);
	free(glue->tools);
	free(glue->lengths);
}

/* The drive comes first: it is the context of the interpreter's calls. */
struct run {
	struct drive drive;
	struct interp *interp;
};

static bool end_block(void *context, const char *file, long line, const char *text, int moves)
{
	struct run *run = context;

	run->drive.summary->lines = interp_lines(run->interp);
	return drive_block(&run->drive, file, line, text, moves);
}

bool motion_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		struct motion_summary *summary)
{
	struct glue glue = {.config = {.read = options->read}};
	struct run run;
	const struct canon_sink canon = {&run, drive_move, drive_tcp, end_block, drive_orient, drive_carry};
	bool ok;

	glue_machine(&glue, machine);
	if (setup)
		glue_setup(&glue, setup);
	if (options->change)
		glue_change(&glue, options->change);
	drive_init(&run.drive, machine, setup, options, sink, diag, name, summary);
	run.interp = interp_new(&glue.config, &canon, diag);
	ok = interp_run(run.interp, in, name);
	summary->lines = interp_lines(run.interp);
	interp_free(run.interp);
	glue_release(&glue);
	return ok;
}
