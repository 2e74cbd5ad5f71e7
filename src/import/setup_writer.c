#include "import/setup_writer.h"

#include <math.h>

#include "base/axes.h"
#include "base/units.h"
#include "base/xml_text.h"
#include "import/machine_writer.h"

/* Rounded to a precision that a reader of the file can check, and so that the lengths of sections still add up. */
static double shown(double value)
{
	return nearbyint(value * 1e9) / 1e9;
}

static void add_number(struct strbuf *out, const char *attribute, double value)
{
	strbuf_addf(out, " %s=\"%.12g\"", attribute, shown(value));
}

static void write_section(struct strbuf *out, const struct section_description *section)
{
	strbuf_addf(out, "<section");
	add_number(out, "length", section->length);
	add_number(out, "diameter", section->diameter);
	if (fabs(section->diameter_end.value - section->diameter) > 1e-9)
		add_number(out, "diameter_end", section->diameter_end.value);
	strbuf_addf(out, "/>");
}

static void write_piece(struct strbuf *out, const char *name, const struct piece_description *piece)
{
	static const char *const tips[] = {
		[TIP_FLAT] = "flat", [TIP_BALL] = "ball", [TIP_CONE] = "cone", [TIP_BULL] = "bull"};

	if (!piece->at)
		return;
	strbuf_addf(out, "    <%s", name);
	if (piece->has_tip && piece->tip != TIP_FLAT)
		xml_text_attribute(out, "tip", tips[piece->tip]);
	if (piece->angle.given)
		add_number(out, "angle", degrees(piece->angle.value));
	if (piece->corner.given)
		add_number(out, "corner", piece->corner.value);
	if (piece->flute_length.given)
		add_number(out, "flute_length", piece->flute_length.value);
	strbuf_addf(out, ">\n");
	for (size_t i = 0; i < piece->section_count; i++) {
		strbuf_addf(out, "      ");
		write_section(out, &piece->sections[i]);
		strbuf_addf(out, "\n");
	}
	strbuf_addf(out, "    </%s>\n", name);
}

static void write_edges(struct strbuf *out, const struct setup_description *tools, long number)
{
	for (size_t i = 0; i < tools->edge_count; i++) {
		const struct edge_description *edge = &tools->edges[i];

		if (edge->tool != number)
			continue;
		if (edge->no_radius) {
			strbuf_addf(out, "    <!-- TODO D%ld has the length %.12g mm and no radius. -->\n",
				    edge->number, shown(edge->length));
			continue;
		}
		strbuf_addf(out, "    <edge number=\"%ld\"", edge->number);
		add_number(out, "length", edge->length);
		if (edge->diameter.given)
			add_number(out, "diameter", edge->diameter.value);
		strbuf_addf(out, "/>\n");
	}
}

static void write_tool(struct strbuf *out, const struct setup_description *tools, const struct tool_description *tool)
{
	static const char *const names[TOOL_PIECES] = {
		[PIECE_HOLDER] = "holder", [PIECE_SHANK] = "shank", [PIECE_CUTTER] = "cutter"};

	strbuf_addf(out, "  <tool number=\"%ld\"", tool->number);
	if (tool->name)
		xml_text_attribute(out, "name", tool->name);
	add_number(out, "length", tool->length);
	if (tool->length_offset.given)
		add_number(out, "length_offset", tool->length_offset.value);
	if (tool->radius_offset.given)
		add_number(out, "radius_offset", tool->radius_offset.value);
	if (tool->kind == TOOL_PROBES)
		xml_text_attribute(out, "kind", "probe");
	if (tool->hand != HAND_UNKNOWN)
		xml_text_attribute(out, "hand", tool->hand == HAND_LEFT ? "left" : "right");
	strbuf_addf(out, ">\n");
	for (int i = 0; i < TOOL_PIECES; i++)
		write_piece(out, names[i], &tool->pieces[i]);
	write_edges(out, tools, tool->number);
	strbuf_addf(out, "  </tool>\n");
}

/* A length or an angle, in the units of a setup file. */
static void add_axis_value(struct strbuf *out, int slot, double value)
{
	const char letter[] = {AXIS_LETTERS[slot], '\0'};

	add_number(out, letter, slot_is_rotary(slot) ? degrees(value) : value);
}

/* Values that a setup cannot use without an answer of the user are written as a comment. */
static void write_offset(struct strbuf *out, const struct length_offset_description *offset)
{
	bool doubtful = offset->d_of_control && offset->radius.given && fabs(offset->radius.value) > 0;

	if (offset->of_tool) {
		strbuf_addf(
		    out, "  <!-- TODO Describe tool %ld: its length_offset is %.12g and its diameter %.12g mm. -->\n",
		    offset->number, shown(offset->length.value), shown(2 * offset->radius.value));
		return;
	}
	if (doubtful)
		strbuf_addf(out, "  <!-- TODO D%ld is %.12g mm: is that a radius or a diameter? -->\n", offset->number,
			    shown(offset->radius.value));
	if (!offset->length.given && (doubtful || !offset->radius.given))
		return;
	strbuf_addf(out, "  <offset number=\"%ld\"", offset->number);
	if (offset->length.given)
		add_number(out, "length", offset->length.value);
	if (offset->radius.given && !doubtful)
		add_number(out, "radius", offset->radius.value);
	strbuf_addf(out, "/>\n");
}

/* A tool of which a control's table does not give the shape. */
static void write_values(struct strbuf *out, const struct tool_values_description *values)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "TODO Describe tool %ld", values->number);
	if (values->key || values->name)
		strbuf_addf(&text, " (%s)", values->key ? values->key : values->name);
	strbuf_addf(&text, ": its length is %.12g and its radius %.12g mm.", shown(values->length),
		    shown(values->radius));
	strbuf_addf(out, "  ");
	xml_text_comment(out, strbuf_text(&text));
	strbuf_release(&text);
}

static void write_work_offsets(struct strbuf *out, const struct work_offset_description *offsets, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		strbuf_addf(out, "  <work_offset");
		xml_text_attribute(out, "name", offsets[i].name);
		for (int slot = 0; slot < SLOT_COUNT; slot++)
			if (offsets[i].value[slot].given)
				add_axis_value(out, slot, offsets[i].value[slot].value);
		strbuf_addf(out, "/>\n");
	}
}

static void write_bodies(struct strbuf *out, const struct machine_description *bodies)
{
	for (size_t i = 0; i < bodies->body_count; i++) {
		const struct body_description *body = &bodies->bodies[i];

		strbuf_addf(out, "  <%s", body_roles[body->role]);
		xml_text_attribute(out, "name", body->name);
		xml_text_attribute(out, "mesh", body->mesh_path);
		machine_writer_frame(out, &body->frame, false);
		strbuf_addf(out, "/>\n");
	}
}

void setup_writer_xml(struct strbuf *out, const struct setup_description *tools, const struct import_setup *job,
		      const char *origin)
{
	strbuf_addf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
	xml_text_comment(out, origin);
	strbuf_addf(out, "<setup version=\"1\" units=\"mm\">\n");
	if (job)
		machine_writer_todo(out, &job->bodies);
	else
		strbuf_addf(out, "  <!-- TODO The work offsets, fixtures and the part of the job. -->\n");
	write_work_offsets(out, tools->offsets, tools->offset_count);
	for (size_t i = 0; i < tools->length_count; i++)
		write_offset(out, &tools->lengths[i]);
	for (size_t i = 0; i < tools->value_count; i++)
		write_values(out, &tools->values[i]);
	if (job) {
		write_work_offsets(out, job->offsets, job->offset_count);
		write_bodies(out, &job->bodies.description);
	}
	for (size_t i = 0; i < tools->tool_count; i++)
		write_tool(out, tools, &tools->tools[i]);
	strbuf_addf(out, "</setup>\n");
}
