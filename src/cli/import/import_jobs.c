#include "cli/import/import_jobs.h"

#include "check/model.h"
#include "cli/import/import_output.h"
#include "import/jobs_writer.h"
#include "machine/job_list.h"
#include "report/format/format_units.h"

static const struct srcloc nowhere;

bool import_jobs_are_new(const struct import_project *project, const char *folder, struct diag *diag)
{
	struct strbuf path = {0};
	bool good;

	strbuf_addf(&path, "%s/jobs.xml", folder);
	good = import_output_is_new(strbuf_text(&path), diag);
	for (size_t i = 0; good && i < project->setup_count; i++) {
		strbuf_clear(&path);
		strbuf_addf(&path, "%s/", folder);
		jobs_writer_setup_name(&path, project, i);
		good = import_output_is_new(strbuf_text(&path), diag);
	}
	strbuf_release(&path);
	return good;
}

static void note_setup(const char *path, const struct import_setup *setup, size_t tools, struct diag *diag)
{
	const size_t bodies = setup->bodies.description.body_count;

	diag_note(diag, nowhere,
		  "wrote %s with %zu %s, %zu work %s and %zu %s, for %zu %s in jobs.xml; next: verify its TODO "
		  "lines",
		  path, tools, format_units_noun(tools, "tool", "tools"), setup->offset_count,
		  format_units_noun(setup->offset_count, "offset", "offsets"), bodies,
		  format_units_noun(bodies, "body", "bodies"), setup->program_count,
		  format_units_noun(setup->program_count, "program", "programs"));
}

/* Loads a written setup, to prove that the checker can read it. */
static bool load_setup(const struct import_project *project, size_t index, const char *folder, struct diag *diag)
{
	const struct import_setup *setup = &project->setups[index];
	struct strbuf machine = {0}, path = {0};
	struct model *model;

	strbuf_addf(&machine, "%s/machine.xml", folder);
	strbuf_addf(&path, "%s/", folder);
	jobs_writer_setup_name(&path, project, index);
	model = model_load(strbuf_text(&machine), strbuf_text(&path), NULL, diag);
	if (model)
		note_setup(strbuf_text(&path), setup, model->setup->tool_count, diag);
	strbuf_release(&machine);
	strbuf_release(&path);
	model_free(model);
	return model != NULL;
}

static bool write_setup(const struct import_project *project, size_t index, const char *folder, const char *source,
			const struct library_options *options, struct diag *diag)
{
	const char *library = project->setups[index].library;
	struct tool_library tools = {0};
	bool good = (!library || library_file_read(&tools, library, options, diag)) &&
		    import_output_write_setup(project, index, &tools, folder, source, diag) &&
		    load_setup(project, index, folder, diag);

	tool_library_release(&tools);
	return good;
}

bool import_jobs_write(const struct import_project *project, const char *folder, const char *source,
		       const struct library_options *options, struct diag *diag)
{
	for (size_t i = 0; i < project->setup_count; i++)
		if (!write_setup(project, i, folder, source, options, diag))
			return false;
	return import_output_write_jobs(project, folder, source, diag);
}
