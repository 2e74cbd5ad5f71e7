#include "cli/program_reports.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "cli/path_checks.h"
#include "cli/report_paths.h"
#include "report/format/format_units.h"
#include "report/format/uri.h"
#include "report/glb/glb.h"
#include "report/html/html_report.h"
#include "report/html/index_page.h"
#include "report/html/report_data.h"
#include "report/html/shown_body.h"
#include "report/output.h"
#include "report/picture/picture.h"
#include "report/verdict.h"

/* Meshes get this share of a report's size. */
#define MESH_SHARE 0.75

/* The stock, if there is one, gets this share of them; a triangle of cubes needs at most this number of bytes. */
#define STOCK_SHARE 0.25
#define STOCK_TRIANGLE_BYTES 3

static bool is_taken(const struct program_reports *reports, size_t before, const char *name)
{
	for (size_t i = 0; i < before; i++) {
		if (!strcmp(reports->programs[i].name, name))
			return true;
	}
	return false;
}

/* Gives the program a name that no earlier one has. */
static void choose_name(struct program_reports *reports, size_t index)
{
	struct strbuf name = {0};
	int turn = 0;

	do {
		strbuf_clear(&name);
		report_paths_add_stem(&name, reports->options->programs[index]);
		if (turn++)
			strbuf_addf(&name, "-%d", turn);
	} while (is_taken(reports, index, strbuf_text(&name)));
	reports->programs[index].name = mem_strndup(strbuf_text(&name), name.length);
	strbuf_release(&name);
}

/* No file of a program may be an input or another output. False: reported. */
static bool check_derived_paths(const struct program_reports *reports, const char *option, const char *path,
			  struct diag *diag)
{
	const struct options *options = reports->options;
	bool good = true;

	for (size_t i = 0; path && i < options->program_count && good; i++) {
		struct strbuf name = {0};

		report_paths_add(&name, path, reports->programs[i].name);
		if (options->program_count > 1)
			good = path_checks_derived(options, option, strbuf_text(&name), reports->files,
						   reports->file_count, diag);
		good = good && report_paths_may_replace(option, strbuf_text(&name), diag);
		strbuf_release(&name);
	}
	return good;
}

/* Builds the trees of tool pieces that the check does not need. */
static void build_all(struct scene *scene)
{
	for (size_t i = 0; i < scene->body_count; i++)
		scene_body_bvh(scene, (int)i);
}

static size_t mesh_bytes(const struct options *options)
{
	return (size_t)(MESH_SHARE * 1e6 * options->report_size);
}

static void pack_meshes(struct program_reports *reports, struct diag *diag)
{
	const struct options *options = reports->options;

	scene_pack_init(&reports->pack, reports->scene, mesh_bytes(options) - reports->stock_bytes);
	if (reports->pack.left_out)
		diag_note(diag, (struct srcloc){0},
			  "the %s of %zu %s left out of the report, which may have %g MB (--report-size)",
			  format_units_noun(reports->pack.left_out, "mesh", "meshes"), reports->pack.left_out,
			  format_units_noun(reports->pack.left_out, "body is", "bodies are"), options->report_size);
}

/* A user who waits for the verdict of one program must not wait for the meshes; several programs share them. */
static bool packs_late(const struct options *options)
{
	return options->program_count == 1;
}

bool program_reports_init(struct program_reports *reports, const struct options *options, struct scene *scene,
			  const struct report_file *files, size_t file_count, struct diag *diag)
{
	*reports = (struct program_reports){.options = options, .scene = scene, .file_count = file_count};
	if (!report_paths_can_write(options->report, diag) || !report_paths_can_write(options->glb, diag) ||
	    !report_paths_can_write(options->picture, diag))
		return false;
	build_all(scene);
	reports->stock_bytes = scene_stock(scene) < 0 ? 0 : (size_t)(STOCK_SHARE * (double)mesh_bytes(options));
	if (options->report && !packs_late(options))
		pack_meshes(reports, diag);
	reports->files = mem_alloc((file_count + 1) * sizeof(*files));
	memcpy(reports->files, files, file_count * sizeof(*files));
	reports->programs = mem_zalloc(options->program_count + 1, sizeof(*reports->programs));
	for (size_t i = 0; i < options->program_count; i++) {
		if (options->program_count > 1)
			choose_name(reports, i);
		else
			reports->programs[i].name = mem_strndup("", 0);
	}
	if (check_derived_paths(reports, "report", options->report, diag) &&
	    check_derived_paths(reports, "glb", options->glb, diag) &&
	    check_derived_paths(reports, "picture", options->picture, diag))
		return true;
	program_reports_release(reports);
	return false;
}

size_t program_reports_stock_triangles(const struct program_reports *reports)
{
	return reports->stock_bytes / STOCK_TRIANGLE_BYTES;
}

void program_reports_release(struct program_reports *reports)
{
	for (size_t i = 0; reports->programs && i < reports->options->program_count; i++) {
		free(reports->programs[i].name);
		free(reports->programs[i].sentence);
	}
	free(reports->programs);
	free(reports->files);
	scene_pack_release(&reports->pack);
	*reports = (struct program_reports){0};
}

/* The files with which this program was checked: without other programs, and with its subprograms. */
static struct report_file *files_of(const struct program_reports *reports, const struct recorder *recorder,
				    const char *program, size_t *count)
{
	struct report_file *files = mem_alloc((reports->file_count + recorder->files.count + 1) * sizeof(*files));

	*count = 0;
	for (size_t i = 0; i < reports->file_count; i++) {
		const struct report_file *file = &reports->files[i];

		if (strcmp(file->kind, "program") != 0 || !strcmp(file->path, program))
			files[(*count)++] = *file;
	}
	for (size_t i = 1; i < recorder->files.count; i++) {
		struct report_file *file = &files[(*count)++];

		*file = (struct report_file){.kind = "subprogram", .path = recorder->files.items[i].name};
		if (!digest_file(file->digest, file->path, NULL))
			file->digest[0] = '\0';
	}
	return files;
}

static void keep_for_index(struct reported_program *it, const struct report_program *program, bool written)
{
	struct strbuf text = {0};

	if (program->verdict)
		verdict_add_sentence(&text, program->verdict);
	it->word = verdict_word(program->verdict);
	it->sentence = mem_strndup(strbuf_text(&text), text.length);
	it->written = written;
	strbuf_release(&text);
}

/* The content of a program's pictures: its first finding, else the place where bodies were nearest, else its start. */
static struct stage stage_of(const struct program_reports *reports, struct recorder *recorder)
{
	const struct scene *scene = reports->scene;
	const struct recorded_finding *first = recorded_findings_first(&recorder->findings);
	struct stage stage = {
	    .scene = scene,
	    .axes = machine_home(scene->machine),
	    .tool = scene->setup ? scene->setup->initial_tool : 0,
	    .a = -1,
	    .b = -1,
	    .stock = recorder->stock.cut ? &recorder->stock.mesh : NULL,
	};

	if (first) {
		stage.axes = first->axes;
		stage.tool = first->tool;
		stage.a = first->a;
		stage.b = first->b;
		stage.moved = first->link;
		stage.has_point = first->a >= 0;
		stage.alarming = true;
		stage.point = first->point;
		stage.triangles = first->has_triangles ? first->triangles : NULL;
	} else if (recorder_is_near(recorder)) {
		stage.axes = recorder->nearest.end.axes;
		stage.tool = recorder->nearest.end.tool;
		stage.a = shown_body(scene, scene->pairs[recorder->nearest.pair].a);
		stage.b = shown_body(scene, scene->pairs[recorder->nearest.pair].b);
		stage.has_point = recorder_nearest_point(recorder, &stage.point);
	}
	return stage;
}

/* One line below the picture. The clearances are bounds: the nearest block is known only within their accuracy. */
static void add_title(struct strbuf *out, const struct program_reports *reports, const struct recorder *recorder,
		      const struct report_program *program)
{
	const struct recorded_finding *first = recorded_findings_first(&recorder->findings);

	if (first) {
		strbuf_addf(out, "%s:%ld: %s", first->file, first->line, first->message);
		return;
	}
	strbuf_addf(out, "%s: %s", program->name, verdict_word(program->verdict));
	if (recorder_is_near(recorder)) {
		const struct scene_pair *pair = &reports->scene->pairs[recorder->nearest.pair];
		const char *file = recorder->files.items[recorder->nearest.file].name;

		strbuf_addf(out, "; smallest clearance %s, in line %ld", recorder->sampled ? "measured" : "proved",
			    recorder->nearest.end.line);
		if (strcmp(file, program->name) != 0)
			strbuf_addf(out, " of %s", file);
		strbuf_addf(out, ": %s and %s, at least %.3f mm apart", reports->scene->bodies[pair->a].body->name,
			    reports->scene->bodies[pair->b].body->name, recorder_shown(recorder->nearest.clearance));
		if (recorder->sampled)
			strbuf_addf(out, "; all blocks: at least %.3f mm",
				    recorder_shown(recorder_bound(recorder)));
	}
}

static bool write_text(const char *path, struct strbuf *text, struct diag *diag)
{
	struct output out;

	if (!output_open(&out, path, diag))
		return false;
	output_text(&out, text);
	return output_commit(&out, diag);
}

/* --picture. False: reported. */
static bool write_picture(const struct stage *stage, const char *title, const char *path, struct diag *diag)
{
	const size_t length = strlen(path);
	struct strbuf text = {0};
	bool good;

	if (length > 4 && !strcmp(path + length - 4, ".png"))
		picture_add_png(&text, stage);
	else
		picture_add_svg(&text, stage, title, true);
	good = write_text(path, &text, diag);
	strbuf_release(&text);
	return good;
}

/* --report, with a picture and the files that were read in addition to the known ones. False: reported. */
static bool write_html(const struct program_reports *reports, const struct html_contents *known,
		       const struct stage *stage, const char *title, const char *path, struct diag *diag)
{
	struct strbuf picture = {0};
	struct stock_pack stock;
	struct html_contents report = *known;
	struct report_file *files = files_of(reports, known->recorder, known->program->name, &report.file_count);
	bool good;

	picture_add_svg(&picture, stage, title, false);
	picture_add_caption(&picture, stage, title);
	report.picture = &picture;
	report.files = files;
	stock_pack_init(&stock, known->recorder, reports->stock_bytes);
	report.stock = &stock;
	good = html_report_write(&report, path, diag);
	stock_pack_release(&stock);
	strbuf_release(&picture);
	free(files);
	return good;
}

/* --glb. False: reported. */
static bool write_glb(struct recorder *recorder, const struct stage *stage, const char *path, struct diag *diag)
{
	struct recorded_window window = recorder_window(recorder);
	struct glb_scene scene = {stage->scene, stage->tool, stage->a, stage->b, stage->stock, NULL, window.count + 1};
	struct glb_key *keys = mem_alloc((window.count + 1) * sizeof(*keys));
	struct strbuf text = {0};
	bool good;

	for (size_t i = 0; i < window.count; i++)
		keys[i] = (struct glb_key){window.rows[i].time, window.rows[i].axes};
	keys[window.count] = (struct glb_key){0, stage->axes};
	scene.keys = keys;
	/* The pose of a finding ends its window; without one, the window is the whole program. */
	if (window.count)
		scene.key_count = window.count;
	glb_add(&text, &scene);
	good = write_text(path, &text, diag);
	strbuf_release(&text);
	free(keys);
	free(window.rows);
	return good;
}

bool program_reports_write(struct program_reports *reports, size_t index, struct recorder *recorder,
			   const struct report_run *run, const struct report_program *program, struct diag *diag)
{
	const struct options *options = reports->options;
	struct reported_program *it = &reports->programs[index];
	struct html_contents report = {
		.scene = &reports->pack,
		.run = run,
		.program = program,
		.recorder = recorder,
		.budget = (size_t)(1e6 * options->report_size),
		.no_code = options->report_code == REPORT_CODE_NONE,
	};
	const struct stage stage = stage_of(reports, recorder);
	struct strbuf title = {0}, path = {0};
	bool good = true;
	int error;

	/* html_report_write reports the fault of a temporary file. */
	recorder_close(recorder, &error);
	add_title(&title, reports, recorder, program);
	if (options->report) {
		if (packs_late(options))
			pack_meshes(reports, diag);
		report_paths_add(&path, options->report, it->name);
		good = write_html(reports, &report, &stage, strbuf_text(&title), strbuf_text(&path), diag);
		keep_for_index(it, program, good);
	}
	strbuf_clear(&path);
	if (options->picture) {
		report_paths_add(&path, options->picture, it->name);
		good = write_picture(&stage, strbuf_text(&title), strbuf_text(&path), diag) && good;
	}
	strbuf_clear(&path);
	if (options->glb) {
		report_paths_add(&path, options->glb, it->name);
		good = write_glb(recorder, &stage, strbuf_text(&path), diag) && good;
	}
	strbuf_release(&title);
	strbuf_release(&path);
	return good;
}

bool program_reports_finish(struct program_reports *reports, struct diag *diag)
{
	const struct options *options = reports->options;
	struct index_page_row *rows;
	struct strbuf *links;
	bool good;

	if (options->program_count < 2 || !options->report)
		return true;
	rows = mem_zalloc(options->program_count, sizeof(*rows));
	links = mem_zalloc(options->program_count, sizeof(*links));
	for (size_t i = 0; i < options->program_count; i++) {
		const struct reported_program *it = &reports->programs[i];
		const char *slash = strrchr(options->report, '/');

		struct strbuf file = {0};

		report_paths_add(&file, slash ? slash + 1 : options->report, it->name);
		uri_add(&links[i], strbuf_text(&file));
		strbuf_release(&file);
		rows[i] = (struct index_page_row){
			.program = options->programs[i],
			.link = it->written ? strbuf_text(&links[i]) : NULL,
			.word = it->word ? it->word : "incomplete",
			.sentence = it->sentence ? it->sentence : "it was not checked",
		};
	}
	good = index_page_write(options->report, rows, options->program_count, diag);
	for (size_t i = 0; i < options->program_count; i++)
		strbuf_release(&links[i]);
	free(links);
	free(rows);
	return good;
}
