#include "motion/motion.h"

#include "gcode/dialect/dialects.h"
#include "gcode/interp.h"
#include "motion/canon_to_spans.h"
#include "motion/motion_kinematics.h"

/* The properties of machine, setup and options that the interpreter needs. All pointers are borrowed. */
static struct gcode_config config_of(const struct machine *machine, const struct setup *setup,
				     const struct motion_options *options)
{
	struct gcode_config config = {.dialect = dialect_of_row(machine->controller.dialect),
				      .controller = machine->controller,
				      .home = machine_home(machine),
				      .read = options->read,
				      .names = options->names};

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		config.has_axis[axis->slot] = true;
		config.wrap[axis->slot] = axis->wrap;
		config.half_turn[axis->slot] = axis->half_turn;
	}
	if (setup) {
		config.has_setup = true;
		config.initial_tool = setup->initial_tool;
		config.work_offsets = setup->offsets;
		config.work_offset_count = setup->offset_count;
		config.tools = setup->tools;
		config.tool_count = setup->tool_count;
		config.edges = setup->edges;
		config.edge_count = setup->edge_count;
		config.lengths = setup->lengths;
		config.length_count = setup->length_count;
		config.radii = setup->radii;
		config.radius_count = setup->radius_count;
		if (setup->variables) {
			config.controller.variables = setup->variables;
			config.controller.variable_count = setup->variable_count;
		}
	}
	if (options->change) {
		config.work_change = options->change->work;
		config.length_change = options->change->length;
	}
	return config;
}

bool motion_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		struct motion_summary *summary)
{
	const struct gcode_config config = config_of(machine, setup, options);
	struct canon_to_spans converter;
	const struct canon_sink canon = {&converter, canon_to_spans_event};
	struct kinematics kinematics;
	struct interp *interp;
	bool ok;

	canon_to_spans_init(&converter, machine, setup, options->flatness, sink, diag, name, summary);
	converter.tells_modes = options->modes;
	converter.tells_steps = !options->counts_steps;
	kinematics = motion_kinematics(&converter);
	interp = interp_new(&config, &kinematics, &canon, diag);
	ok = interp_run(interp, in, name);
	summary->lines = interp_lines(interp);
	interp_free(interp);
	return ok;
}
