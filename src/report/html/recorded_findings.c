#include "report/html/recorded_findings.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/format/format_units.h"
#include "report/html/report_data.h"
#include "report/html/shown_body.h"
#include "report/writers/ndjson.h"
#include "report/writers/text.h"

static int link_of_slot(const struct machine *machine, int slot)
{
	const struct axis *axis = machine_axis(machine, slot);

	return axis ? (int)(axis - machine->axes) + 1 : 0;
}

static void add_triangles(struct recorded_finding *finding, struct scene *scene, struct sweep *sweep)
{
	const struct scene_pair *pair = shown_pair(scene, finding->a, finding->b);
	struct nearest_triangles nearest;
	struct body_pair bodies;
	xform pose;

	/* The triangles of the blank are not those of the remaining stock. */
	if (!pair || pair->stock)
		return;
	bodies = scene_pair_bodies(scene, pair);
	sweep_nearest_triangles(sweep, &bodies, &finding->axes, 1, &nearest);
	pose = shown_body_pose(scene, pair->a, &finding->axes);
	for (int k = 0; k < 3; k++) {
		finding->triangles[0][k] = xform_apply(&pose, nearest.a.p[k]);
		finding->triangles[1][k] = xform_apply(&pose, nearest.b.p[k]);
	}
	finding->has_triangles = true;
}

static char *text_of(struct strbuf *text)
{
	char *copy = mem_strndup(strbuf_text(text), text->length);

	strbuf_release(text);
	return copy;
}

/* Adds what only a finding of two bodies has. */
static void add_bodies(struct recorded_finding *it, struct scene *scene, struct sweep *sweep,
		       const struct pair_finding *pair)
{
	it->a = shown_body_named(scene, pair->a);
	it->b = shown_body_named(scene, pair->b);
	it->point = pair->point;
	if (it->a >= 0 && it->b >= 0)
		add_triangles(it, scene, sweep);
}

void recorded_findings_add(struct recorded_findings *findings, struct scene *scene, struct sweep *sweep,
			   const struct finding *finding, struct finding_style style, long block)
{
	struct strbuf message = {0}, text = {0};
	struct recorded_finding *it;

	if (findings->count == FINDINGS_MAX) {
		findings->left_out++;
		return;
	}
	style.colour = false;
	findings->items = mem_grow(findings->items, &findings->capacity, findings->count + 1, sizeof(*findings->items));
	it = &findings->items[findings->count++];
	text_sentence(&message, finding);
	format_units_add_plain(&text, finding->text);
	*it = (struct recorded_finding){
		.object = ndjson_finding_object(scene->machine, finding, style),
		.message = text_of(&message),
		.file = mem_strndup(finding->file, strlen(finding->file)),
		.text = text_of(&text),
		.kind = finding->kind,
		.status = style.status,
		.line = finding->line,
		.block = block,
		.time = finding->time,
		.stock_time = finding->stock_time,
		.fraction = finding->fraction,
		.axes = finding->axes,
		.tool = finding->tool,
		.a = -1,
		.b = -1,
	};
	if (finding->kind == FINDING_LIMIT)
		it->link = link_of_slot(scene->machine, finding->of.limit.slot);
	else
		add_bodies(it, scene, sweep, &finding->of.pair);
}

const struct recorded_finding *recorded_findings_first(const struct recorded_findings *findings)
{
	for (size_t i = 0; i < findings->count; i++) {
		if (findings->items[i].status == FINDING_FAILS)
			return &findings->items[i];
	}
	return findings->count ? &findings->items[0] : NULL;
}

void recorded_findings_release(struct recorded_findings *findings)
{
	for (size_t i = 0; i < findings->count; i++) {
		struct recorded_finding *it = &findings->items[i];

		json_decref(it->object);
		free(it->message);
		free(it->file);
		free(it->text);
	}
	free(findings->items);
}
