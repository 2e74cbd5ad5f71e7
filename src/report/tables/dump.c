#include "report/tables/dump.h"

#include <math.h>

#include "report/format/format_units.h"

struct dump {
	struct output *out;
	const struct machine *machine;
	struct diag *diag;
	const char *name;
	struct strbuf row;
	bool past_limit;	/* it was reported once */
};

static bool dump_header(struct dump *dump)
{
	strbuf_addf(&dump->row, "line\tmove\ttool");
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (machine_axis(dump->machine, slot))
			strbuf_addf(&dump->row, "\t%c", AXIS_LETTERS[slot]);
	}
	strbuf_addf(&dump->row, "\ttime\tdeviation\n");
	return output_text(dump->out, &dump->row);
}

static double greatest_deviation(const struct span *span)
{
	double greatest = 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!slot_is_rotary(slot))
			greatest = fmax(greatest, span->chord_error.v[slot]);
	}
	return greatest;
}

static bool dump_step(struct dump *dump, const struct motion_step *step)
{
	/* The path of the move has no length, but the axes may be beside it. */
	if (!(step->seconds > 0))
		return true;
	strbuf_addf(&dump->row, "%ld\t%d\t%d", step->line, step->move, step->tool);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (machine_axis(dump->machine, slot))
			strbuf_addf(&dump->row, "\t%.12g", format_units_value(slot, step->span.q1.v[slot]));
	}
	strbuf_addf(&dump->row, "\t%.12g\t%.12g\n", step->time + step->seconds, greatest_deviation(&step->span));
	return output_text(dump->out, &dump->row);
}

static void dump_limit(struct dump *dump, const struct motion_limit *limit)
{
	const struct travel_excess *travel = &limit->travel;

	if (!dump->past_limit)
		diag_warning(dump->diag, (struct srcloc){limit->file, limit->line, 0},
			     "axis %c %s its travel at the limit of %.10g %s; "
			     "--parse-only --all lists every such place",
			     AXIS_LETTERS[travel->slot], travel->path_tolerance > 0 ? "may leave" : "leaves",
			     format_units_value(travel->slot, travel->bound), format_units_unit(travel->slot));
	dump->past_limit = true;
}

static bool on_event(void *context, const struct motion_event *event)
{
	if (event->kind == MOTION_STEP)
		return dump_step(context, &event->of.step);
	if (event->kind == MOTION_LIMIT)
		dump_limit(context, &event->of.limit);
	return true;
}

bool dump_path(struct output *out, const struct machine *machine, const struct setup *setup,
	       const struct motion_options *options, FILE *in, const char *name, struct diag *diag)
{
	struct dump dump = {.out = out, .machine = machine, .diag = diag, .name = name};
	const struct motion_sink sink = {&dump, on_event};
	struct motion_summary summary;
	bool good = dump_header(&dump) && motion_run(machine, setup, options, in, name, &sink, diag, &summary);

	strbuf_release(&dump.row);
	return good;
}
