#include "report/html/report_head.h"

#include <string.h>

#include "report/format/json.h"
#include "report/html/plain_html.h"
#include "report/html/report_data.h"
#include "report/sensitivity_report.h"
#include "report/writers/ndjson.h"

static json_t *verdict_json(const struct html_contents *report)
{
	const struct report_program *program = report->program;
	const struct verdict *verdict = program->verdict;
	const char *word = verdict_word(verdict);
	json_t *object = json_object();
	struct strbuf text = {0};

	if (verdict)
		verdict_add_sentence(&text, verdict);
	else
		strbuf_addf(&text, "incomplete: %s", program->unread);
	json_put(object, "word", json_string(word));
	json_put(object, "sentence", json_text(strbuf_text(&text)));
	json_put(object, "cautions", ndjson_cautions(verdict));
	json_put(object, "doubts", ndjson_doubts(verdict));
	json_put(object, "failing",
		 json_boolean(!strcmp(word, "found") || !strcmp(word, "incomplete") || program->failing_warning));
	json_put(object, "waived", json_integer(verdict ? verdict->waived : 0));
	json_put(object, "left_out", json_integer(verdict ? verdict->left_out : 0));
	strbuf_release(&text);
	return object;
}

static json_t *triangle_json(const vec3 corners[3])
{
	json_t *array = json_array();

	for (int k = 0; k < 3; k++) {
		json_push(array, json_real(corners[k].x));
		json_push(array, json_real(corners[k].y));
		json_push(array, json_real(corners[k].z));
	}
	return array;
}

static json_t *finding_json(const struct recorded_finding *finding)
{
	json_t *object = json_deep_copy(finding->object), *bodies = NULL, *triangles = NULL;

	if (finding->a >= 0 && finding->b >= 0) {
		bodies = json_array();
		json_push(bodies, json_integer(finding->a));
		json_push(bodies, json_integer(finding->b));
	}
	if (finding->has_triangles) {
		triangles = json_array();
		json_push(triangles, triangle_json(finding->triangles[0]));
		json_push(triangles, triangle_json(finding->triangles[1]));
	}
	json_put(object, "bodies", bodies ? bodies : json_null());
	json_put(object, "triangles", triangles ? triangles : json_null());
	json_put(object, "tool", json_integer(finding->tool));
	json_put(object, "block_number", json_integer(finding->block));
	json_put(object, "message", json_text(finding->message));
	return object;
}

static json_t *findings_json(const struct recorder *recorder)
{
	json_t *array = json_array();

	for (size_t i = 0; i < recorder->findings.count; i++)
		json_push(array, finding_json(&recorder->findings.items[i]));
	return array;
}

static json_t *options_json(const struct report_run *run)
{
	json_t *object = json_object();

	ndjson_put_options(object, run);
	return object;
}

static json_t *read_out_json(const struct machine *machine)
{
	json_t *array = json_array();

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const struct axis *axis = machine_axis(machine, slot);

		if (axis)
			json_push(array, json_string(axis->name));
	}
	return array;
}

json_t *report_head_json(const struct html_contents *report)
{
	const struct report_run *run = report->run;
	const struct scene_pack *scene = report->scene;
	json_t *object = json_object();

	json_put(object, "report", json_integer(REPORT_DATA_VERSION));
	json_put(object, "fivecheck", json_string(FIVECHECK_VERSION));
	json_put(object, "program", json_text(report->program->name));
	json_put(object, "verdict", verdict_json(report));
	json_put(object, "errors", ndjson_errors(report->program));
	json_put(object, "files", ndjson_files(report->files, report->file_count));
	json_put(object, "options", options_json(run));
	json_put(object, "shard", json_shard(run->shard, run->shards, run->options->shards > 0));
	json_put(object, "machine", json_deep_copy(scene->machine));
	json_put(object, "read_out", read_out_json(run->scene->machine));
	json_put(object, "bodies", json_deep_copy(scene->bodies));
	json_put(object, "accuracy", json_real(scene->accuracy));
	json_put(object, "tools", json_deep_copy(scene->tools));
	json_put(object, "offsets", json_deep_copy(scene->offsets));
	json_put(object, "pairs", json_deep_copy(scene->pairs));
	json_put(object, "findings", findings_json(report->recorder));
	json_put(object, "findings_left_out", json_integer(report->recorder->findings.left_out));
	json_put(object, "statistics", plain_html_statistics(report));
	json_put(object, "sensitivity",
		 sensitivity_report_json(report->program->sensitivity, report->program->sensitivity_count));
	return object;
}
