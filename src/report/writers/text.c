#include "report/writers/text.h"

#include <math.h>

#include "base/xml_text.h"
#include "report/format/format_units.h"
#include "report/sensitivity_report.h"
#include "report/writers/writers.h"

static void add_body(struct strbuf *out, const char *body, const char *link)
{
	format_units_add_plain(out, body);
	strbuf_addf(out, " (%s)", link);
}

static void add_bodies(struct strbuf *out, const struct pair_finding *pair, const char *verb)
{
	add_body(out, pair->a, pair->link_a);
	strbuf_addf(out, " %s ", verb);
	add_body(out, pair->b, pair->link_b);
}

/* The motion of the cutter while it is too deep in the part. */
static const char *how_it_moves(const struct finding *f)
{
	switch (f->of.pair.step_class) {
	case STEP_RAPID:
		return "at rapid";
	case STEP_FEED_TURNING:
		return "while it cuts";
	case STEP_FEED_REVERSED:
		return "while its spindle turns against its hand";
	case STEP_PROBE_TRAVEL:
		return "at a feed that does not measure";
	case STEP_FEED_STANDING:
		return f->kind == FINDING_GOUGE ? "while it works" : "while its spindle stands";
	default:
		return "before the block moves";
	}
}

static void add_entry(struct strbuf *out, const struct finding *f)
{
	const struct pair_finding *pair = &f->of.pair;

	add_body(out, pair->b_is_cutter ? pair->b : pair->a, pair->b_is_cutter ? pair->link_b : pair->link_a);
	strbuf_addf(out, " enters ");
	add_body(out, pair->b_is_cutter ? pair->a : pair->b, pair->b_is_cutter ? pair->link_a : pair->link_b);
	strbuf_addf(out, " more than %.10g mm deep %s", pair->depth, how_it_moves(f));
}

static void add_travel(struct strbuf *out, const struct travel_excess *limit)
{
	strbuf_addf(out, "axis %c %s its travel at the limit of %.10g %s", AXIS_LETTERS[limit->slot],
		    limit->path_tolerance > 0 ? "may leave" : "leaves", format_units_value(limit->slot, limit->bound),
		    format_units_unit(limit->slot));
}

void text_message(struct strbuf *out, const struct finding *f)
{
	switch (f->kind) {
	case FINDING_COLLISION:
		add_bodies(out, &f->of.pair, "meets");
		break;
	case FINDING_CLEARANCE:
		add_bodies(out, &f->of.pair, "comes too close to");
		break;
	case FINDING_START_OVERLAP:
		add_bodies(out, &f->of.pair, "overlaps");
		strbuf_addf(out, " before the block moves");
		break;
	case FINDING_RAPID_CONTACT:
	case FINDING_GOUGE:
		add_entry(out, f);
		break;
	case FINDING_LIMIT:
		add_travel(out, &f->of.limit);
		break;
	}
}

static void add_value(struct strbuf *out, int slot, double value)
{
	strbuf_addf(out, "%.6g %s", format_units_value(slot, value), format_units_unit(slot));
}

/* "X 200 mm; the axis goes up to 150 mm past the limit" */
static void add_target(struct strbuf *out, const struct travel_excess *limit)
{
	strbuf_addf(out, "%c ", AXIS_LETTERS[limit->slot]);
	add_value(out, limit->slot, limit->target);
	strbuf_addf(out, "; the axis %s up to ", limit->path_tolerance > 0 ? "may go" : "goes");
	add_value(out, limit->slot, limit->excess);
	strbuf_addf(out, " past the limit");
}

/* "inside the limit as programmed; the axis may be up to 1.5 mm beside that path" */
static void add_way(struct strbuf *out, const struct travel_excess *limit)
{
	strbuf_addf(out, "inside the limit as programmed; the axis may be up to ");
	add_value(out, limit->slot, limit->path_tolerance);
	strbuf_addf(out, " beside that path");
}

/* "G54 X 50 mm, G52 or G92 adds 10 mm, tool length 60 mm" */
static void add_origin(struct strbuf *out, const struct travel_excess *limit)
{
	if (!limit->work_offset) {
		strbuf_addf(out, "none: machine coordinates");
		return;
	}
	strbuf_addf(out, "%s %c ", limit->work_offset, AXIS_LETTERS[limit->slot]);
	add_value(out, limit->slot, limit->work);
	if (fabs(limit->shift) > 0) {
		strbuf_addf(out, ", G52 or G92 adds ");
		add_value(out, limit->slot, limit->shift);
	}
	if (limit->length_acts && fabs(limit->length) > 0)
		strbuf_addf(out, ", tool length %.6g mm", limit->length);
	else if (limit->length_acts)
		strbuf_addf(out, ", no tool length");
}

/* For a finding with the stock: is it certain for every stock that may remain? */
static const char *certainty(const struct pair_finding *pair)
{
	return pair->certain ? "certain: they meet in this block where no cutter has been"
			  : "possible: all that they meet may have been cut, within the tolerances";
}

void text_sentence(struct strbuf *out, const struct finding *f)
{
	const struct travel_excess *limit = &f->of.limit;

	text_message(out, f);
	if (f->kind != FINDING_LIMIT) {
		if (f->of.pair.with_stock)
			strbuf_addf(out, "; %s", certainty(&f->of.pair));
		return;
	}
	strbuf_addf(out, "; commanded: ");
	add_target(out, limit);
	if (limit->path_tolerance > 0) {
		strbuf_addf(out, "; ");
		add_way(out, limit);
	}
	strbuf_addf(out, "; offset in force: ");
	add_origin(out, limit);
}

static void add_limit(struct strbuf *out, const struct travel_excess *limit)
{
	strbuf_addf(out, "    target   ");
	add_target(out, limit);
	if (limit->path_tolerance > 0) {
		strbuf_addf(out, "\n    path     ");
		add_way(out, limit);
	}
	strbuf_addf(out, "\n    offset   ");
	add_origin(out, limit);
	strbuf_addf(out, "\n");
}

static void add_place(struct strbuf *out, const struct finding *f)
{
	strbuf_addf(out, "    at       ");
	format_units_add(out, 100 * f->fraction);
	strbuf_addf(out, " %% of the block");
	if (f->moves > 1)
		strbuf_addf(out, ", in its move %d of %d", f->move, f->moves);
	strbuf_addf(out, "\n    time     ");
	format_units_add_duration(out, f->time);
	strbuf_addf(out, "\n");
}

static void add_contact(struct strbuf *out, const struct finding *f)
{
	const struct pair_finding *pair = &f->of.pair;
	const double point[3] = {pair->point.x, pair->point.y, pair->point.z};

	strbuf_addf(out, f->kind == FINDING_CLEARANCE ? "    near    " : "    contact ");
	for (int i = 0; i < 3; i++) {
		strbuf_addf(out, " %c ", "XYZ"[i]);
		format_units_add(out, point[i]);
	}
	strbuf_addf(out, " mm in machine coordinates\n");
	if (pair->required > 0) {
		strbuf_addf(out, "    distance ");
		format_units_add(out, pair->clearance);
		strbuf_addf(out, " mm, required: more than %.10g mm\n", pair->required);
	}
	if (pair->with_stock)
		strbuf_addf(out, "    stock    %s\n", certainty(pair));
	if (pair->path_displacement > 0) {
		strbuf_addf(out, "    path     ");
		format_units_add(out, pair->clearance);
		strbuf_addf(out, " mm apart as programmed; the path tolerance can take ");
		format_units_add(out, pair->path_displacement);
		strbuf_addf(out, " mm of that\n");
	}
}

/* "called   from part.nc:12", a line for each call */
static void add_callers(struct strbuf *out, const struct finding *f)
{
	for (size_t i = 0; i < f->caller_count; i++) {
		strbuf_addf(out, "    called   from ");
		strbuf_add_visible(out, f->callers[i].file);
		strbuf_addf(out, ":%ld\n", f->callers[i].line);
	}
}

/* "part.nc:118:1: error: collision: "; a finding that does not fail the run is a warning. */
static void add_head(struct strbuf *out, const struct finding *f, struct finding_style style)
{
	bool fails = style.status == FINDING_FAILS;

	strbuf_add_visible(out, f->file);
	strbuf_addf(out, ":%ld:%d: ", f->line, f->column);
	if (style.colour)
		strbuf_addf(out, fails ? "\033[1;31m" : "\033[1;35m");
	strbuf_addf(out, fails ? "error:" : "warning:");
	strbuf_addf(out, "%s %s: ", style.colour ? "\033[0m" : "", finding_kind_name(f->kind));
}

void text_headline(struct strbuf *out, const struct finding *f, struct finding_style style)
{
	static const char *const marks[] = {
		[FINDING_FAILS] = "",
		[FINDING_WAIVED] = ", waived",
		[FINDING_LEFT_OUT] = "",
	};

	add_head(out, f, style);
	text_message(out, f);
	strbuf_addf(out, " [%s%s]", finding_kind_name(f->kind), marks[style.status]);
}

void text_finding(struct strbuf *out, const struct machine *machine, const struct finding *f,
		  struct finding_style style)
{
	text_headline(out, f, style);
	strbuf_addf(out, "\n    block    ");
	format_units_add_plain(out, f->text ? f->text : "");
	strbuf_addf(out, "\n");
	add_callers(out, f);
	add_place(out, f);
	strbuf_addf(out, "    axes     ");
	format_units_add_axes(out, machine, &f->axes);
	strbuf_addf(out, "\n");
	if (f->kind == FINDING_LIMIT)
		add_limit(out, &f->of.limit);
	else
		add_contact(out, f);
	if (style.waiver) {
		strbuf_addf(out, "    waived   ");
		waiver_match_add_reason(out, style.waiver);
		strbuf_addf(out, "\n");
	} else if (f->kind == FINDING_START_OVERLAP) {
		strbuf_addf(out, "    to waive <pair");
		xml_text_attribute(out, "a", f->of.pair.a);
		xml_text_attribute(out, "b", f->of.pair.b);
		strbuf_addf(out, " check=\"never\" reason=\"\"/>\n");
	}
}

void text_verdict(struct strbuf *out, const struct verdict *verdict)
{
	struct strbuf caution = {0};

	strbuf_add_visible(out, verdict->file);
	strbuf_addf(out, ": ");
	verdict_add_sentence(out, verdict);
	strbuf_addf(out, "\n");
	for (int i = 0; i < VERDICT_CAUTIONS; i++) {
		if (verdict_add_caution(&caution, verdict, i))
			strbuf_addf(out, "    %s\n", caution.text);
		strbuf_clear(&caution);
	}
	strbuf_release(&caution);
}

/* Appends the smallest proven clearance of each required pair; `proven` is as check_run fills it. */
static void add_proven(struct strbuf *out, const struct scene *scene, const double *proven)
{
	strbuf_addf(out, "    smallest proven clearance, each more than (mm):\n");
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];

		if (pair->status != PAIR_CHECKED && isinf(proven[i]))
			continue;
		strbuf_addf(out, "    ");
		if (isinf(proven[i]))
			strbuf_addf(out, "%12s", "not met");
		else
			/* Rounded down, so that the printed number is proved, too. */
			strbuf_addf(out, "%12.4f", floor(proven[i] * 1e4) / 1e4);
		strbuf_addf(out, "  %s - %s\n", scene->bodies[pair->a].body->name, scene->bodies[pair->b].body->name);
	}
}

static void add_nothing(struct strbuf *out, const struct report_run *run)
{
	(void)out;
	(void)run;
}

static void add_finding(struct strbuf *out, const struct report_run *run, const struct finding *finding,
			struct finding_style style)
{
	text_finding(out, run->scene->machine, finding, style);
}

static void add_program(struct strbuf *out, const struct report_run *run, const struct report_program *program)
{
	/* Without this line the list of verdicts would look complete. */
	if (!program->verdict) {
		strbuf_add_visible(out, program->name);
		strbuf_addf(out, ": incomplete: %s\n", program->unread);
		return;
	}
	text_verdict(out, program->verdict);
	if (program->proven && program->verdict->result == CHECK_CLEAR)
		add_proven(out, run->scene, program->proven);
	if (program->sensitivity_count)
		sensitivity_report_text(out, program->sensitivity, program->sensitivity_count,
				 program->verdict->result == CHECK_CLEAR);
}

static void add_end(struct strbuf *out, const struct report_run *run, const struct report_end *end,
		    const struct strbuf *items)
{
	(void)items;
	/* Statistics of an incomplete check would be meaningless. */
	if (run->quiet || end->status > 1)
		return;
	if (run->stats)
		stats_add(out, end->sums, run->scene, run->options->method);
	else
		stats_add_line(out, end->sums, run->options->method);
}

/* Findings as they are found, a verdict after each program's, statistics at the end. */
const struct report_writer text_writer = {
	.name = "text", .begin = add_nothing, .finding = add_finding, .program = add_program, .end = add_end,
};
