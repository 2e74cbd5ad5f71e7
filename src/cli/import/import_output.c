#include "cli/import/import_output.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "import/jobs_writer.h"
#include "import/machine_writer.h"
#include "import/setup_writer.h"
#include "report/output.h"

static const struct srcloc nowhere;

bool import_output_is_new(const char *path, struct diag *diag)
{
	struct stat status;

	if (stat(path, &status) != 0)
		return true;
	diag_error(diag, nowhere, "%s already exists and may have been edited: remove it, or name another folder with "
				  "--output",
		   path);
	return false;
}

static bool make_folder(const char *path, struct diag *diag)
{
	if (mkdir(path, 0777) == 0 || errno == EEXIST)
		return true;
	diag_error(diag, (struct srcloc){.file = path}, "cannot make the folder: %s", strerror(errno));
	return false;
}

/* Writes the text to a file of the folder and empties it. */
static bool write_file(const char *folder, const char *name, struct strbuf *text, struct diag *diag)
{
	struct strbuf path = {0};
	struct output out;
	bool good;

	strbuf_addf(&path, "%s/%s", folder, name);
	good = output_open(&out, strbuf_text(&path), diag);
	if (good) {
		output_text(&out, text);
		good = output_commit(&out, diag);
	}
	strbuf_release(&path);
	return good;
}

static bool write_meshes(const struct import_machine *machine, const char *folder, struct diag *diag)
{
	struct strbuf bytes = {0};
	bool good = true;

	for (size_t i = 0; good && i < machine->description.body_count; i++) {
		strbuf_clear(&bytes);
		machine_writer_stl(&bytes, &machine->meshes[i]);
		good = write_file(folder, machine->description.bodies[i].mesh_path, &bytes, diag);
	}
	strbuf_release(&bytes);
	return good;
}

static void add_origin(struct strbuf *out, const char *source)
{
	const char *slash = strrchr(source, '/');

	strbuf_addf(out, "Made by fivecheck import from %s.", slash ? slash + 1 : source);
}

bool import_output_write_meshes(const struct import_machine *machine, const char *folder, struct diag *diag)
{
	struct strbuf meshes = {0};
	bool good;

	strbuf_addf(&meshes, "%s/%s", folder, machine->folder ? machine->folder : "stl");
	good = make_folder(folder, diag) && make_folder(strbuf_text(&meshes), diag) &&
	       write_meshes(machine, folder, diag);
	strbuf_release(&meshes);
	return good;
}

bool import_output_write(const struct import_machine *machine, const char *folder, const char *source,
			 struct diag *diag)
{
	struct strbuf text = {0}, origin = {0};
	bool good = import_output_write_meshes(machine, folder, diag);

	add_origin(&origin, source);
	machine_writer_xml(&text, machine, strbuf_text(&origin));
	good = good && write_file(folder, "machine.xml", &text, diag);
	strbuf_release(&text);
	strbuf_release(&origin);
	return good;
}

bool import_output_write_tools(const struct tool_library *tools, const char *folder, const char *source,
			       struct diag *diag)
{
	struct strbuf text = {0}, origin = {0};
	bool good;

	add_origin(&origin, source);
	setup_writer_xml(&text, &tools->setup, NULL, strbuf_text(&origin));
	good = make_folder(folder, diag) && write_file(folder, "setup.xml", &text, diag);
	strbuf_release(&text);
	strbuf_release(&origin);
	return good;
}

bool import_output_write_setup(const struct import_project *project, size_t setup, const struct tool_library *tools,
			       const char *folder, const char *source, struct diag *diag)
{
	const struct import_setup *job = &project->setups[setup];
	struct strbuf text = {0}, origin = {0}, name = {0};
	bool good;

	add_origin(&origin, source);
	jobs_writer_setup_name(&name, project, setup);
	setup_writer_xml(&text, &tools->setup, job, strbuf_text(&origin));
	good = (!job->bodies.description.body_count || import_output_write_meshes(&job->bodies, folder, diag)) &&
	       write_file(folder, strbuf_text(&name), &text, diag);
	strbuf_release(&text);
	strbuf_release(&origin);
	strbuf_release(&name);
	return good;
}

bool import_output_write_jobs(const struct import_project *project, const char *folder, const char *source,
			      struct diag *diag)
{
	struct strbuf text = {0}, origin = {0};
	bool good;

	add_origin(&origin, source);
	good = !jobs_writer_xml(&text, project, strbuf_text(&origin)) || write_file(folder, "jobs.xml", &text, diag);
	strbuf_release(&text);
	strbuf_release(&origin);
	return good;
}
