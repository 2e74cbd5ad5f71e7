#include "cli/import/import_command.h"

#include "base/units.h"
#include "cli/import/import_jobs.h"
#include "cli/import/import_output.h"
#include "cli/subcommand.h"
#include "control/dialects.h"
#include "import/emc_machine.h"
#include "import/file_kind.h"
#include "import/freecad_machine.h"
#include "import/mesh_file.h"
#include "import/mesh_helper.h"
#include "import/mtconnect_machine.h"
#include "import/ply_check.h"
#include "import/urdf_machine.h"
#include "import/vericut_machine.h"
#include "import/vericut_project.h"
#include "import/zip_check.h"
#include "machine/library/library_file.h"
#include "machine/machine.h"
#include "report/format/format_units.h"
#include "report/html/axis_page.h"
#include "scene/scene.h"

static const struct srcloc nowhere;

enum {
	KEY_MESHES = 256,
	KEY_SKIP_MISSING,
	KEY_NUMBER_TOOLS,
	KEY_DIALECT,
	KEY_UNITS,
	KEY_TABLE,
	KEY_HEAD,
	KEY_DEVICE,
	KEY_PICTURES
};

enum unit { UNIT_UNKNOWN = -1, UNIT_MM, UNIT_INCH };

static const char *const unit_names[] = {"mm", "inch", NULL};

struct request {
	struct import_options options;
	const char *output;
	bool number_tools, pictures;
	int unit;	/* an enum unit, the index of unit_names */
	int dialect;	/* row of control/dialects.h; -1: not given */
	const char *file;
	struct diag *diag;
};

#define FIELD(member) .field = offsetof(struct request, member)

const struct option_row import_options[IMPORT_OPTION_COUNT] = {
	{'o', "output", "FOLDER", .kind = VALUE_TEXT, FIELD(output),
	 .help = "write machine.xml and its meshes, or setup.xml, into "
		 "FOLDER, which is made if it does not exist; required"},
	{KEY_MESHES, "meshes", "FOLDER", .kind = VALUE_TEXT, FIELD(options.meshes),
	 .help = "search meshes below FOLDER first, then beside FILE"},
	{KEY_SKIP_MISSING, "skip-missing", NULL, .kind = VALUE_FLAG, FIELD(options.skip_missing),
	 .help = "leave out bodies whose meshes are missing"},
	{KEY_PICTURES, "pictures", NULL, .kind = VALUE_FLAG, FIELD(pictures),
	 .help = "also write axes.html into FOLDER: pictures of what each axis does"},
	{KEY_NUMBER_TOOLS, "number-tools", NULL, .kind = VALUE_FLAG, FIELD(number_tools),
	 .help = "number the tools that have no number, in their order"},
	{KEY_TABLE, "table", "LETTERS", .kind = VALUE_LETTERS, FIELD(options.table),
	 .help = "the axes that carry the work, in order from the base, if the file does not say it"},
	{KEY_HEAD, "head", "LETTERS", .kind = VALUE_LETTERS, FIELD(options.head),
	 .help = "the axes that carry the tool, in order from the base"},
	{KEY_DEVICE, "device", "NAME", .kind = VALUE_TEXT, FIELD(options.device),
	 .help = "which machine to take from an MTConnect document with several"},
	{KEY_UNITS, "units", "UNIT", .kind = VALUE_CHOICE, FIELD(unit), .choices = unit_names,
	 .help = "the unit of lengths in a file that does not give one: %s"},
	{KEY_DIALECT, "dialect", "NAME", .kind = VALUE_CHOICE, FIELD(dialect), .choices = dialect_names,
	 .help = "the dialect of the control: %s"},
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

static const struct subcommand subcommand = {
	.name = "import",
	.usage = "Usage: fivecheck import [OPTIONS] --output=FOLDER FILE\n"
		 "Converts files of other programs.\n"
		 "To a machine file and meshes: a VERICUT 7 machine (.mch), the ini file of a\n"
		 "control, a FreeCAD machine (.fcm), an MTConnect device or URDF. To these, setups\n"
		 "and a job file: a VERICUT 7 project (.VcProject). To a setup: a tool library of\n"
		 "VERICUT (.tls) or Fusion 360 (.json), a tool catalogue (DIN 4000, ISO 13399), a\n"
		 "tool table (CSV, tool.tbl, TOOL.T, $TC_DP) or an offset listing (G10). To STL:\n"
		 "another mesh.\n"
		 "import reports what it could not convert, and what you have to verify.\n",
	.examples = "fivecheck import --output=dmu50 DMU50.mch\n"
		    "fivecheck --check-machine dmu50/machine.xml\n",
	.options = import_options,
	.option_count = IMPORT_OPTION_COUNT,
};

/* Loads the written machine, to prove that the checker can read it. */
static bool load_machine(const struct request *request, const char *path)
{
	struct machine *machine = machine_load(path, request->diag);

	if (!machine)
		return false;
	diag_note(request->diag, nowhere,
		  "wrote %s with %zu %s and %zu %s; next: verify it, run 'fivecheck --check-machine %s', "
		  "and compare what that prints for each axis with the machine",
		  path, machine->axis_count, format_units_noun(machine->axis_count, "axis", "axes"),
		  machine->body_count, format_units_noun(machine->body_count, "body", "bodies"), path);
	machine_free(machine);
	return true;
}

/* Writes a page that shows the written machine. */
static bool draw(const struct request *request, const char *path, const char *page)
{
	struct machine *machine = machine_load(path, request->diag);
	struct scene *scene = machine ? scene_new(machine, NULL, 0, 1, request->diag) : NULL;
	bool good = scene && axis_page_write(page, scene, request->diag);

	if (good)
		diag_note(request->diag, nowhere,
			  "wrote %s: open it in a browser and compare each picture with the machine", page);
	scene_free(scene);
	machine_free(machine);
	return good;
}

static bool read_machine(const struct request *request, enum file_kind kind, struct import_machine *machine)
{
	switch (kind) {
	case FILE_EMC_MACHINE:
		return emc_machine_read(machine, request->file, &request->options, request->diag);
	case FILE_FREECAD:
		return freecad_machine_read(machine, request->file, &request->options, request->diag);
	case FILE_MTCONNECT:
		return mtconnect_machine_read(machine, request->file, &request->options, request->diag);
	case FILE_URDF:
		return urdf_machine_read(machine, request->file, &request->options, request->diag);
	case FILE_VERICUT_MACHINE:
	case FILE_VERICUT_PROJECT:
	case FILE_MESH:
	case FILE_TOOLS:
		break;
	}
	return vericut_machine_read(machine, request->file, NULL, &request->options, request->diag);
}

/* Writes the machine, and its pictures if requested. False: reported. */
static bool write_machine(const struct request *request, struct import_machine *machine)
{
	struct strbuf path = {0}, page = {0};
	bool good;

	strbuf_addf(&path, "%s/machine.xml", request->output);
	strbuf_addf(&page, "%s/axes.html", request->output);
	if (request->dialect >= 0) {
		machine->dialect_known = true;
		machine->description.controller.told.dialect = request->dialect;
	}
	good = import_output_write(machine, request->output, request->file, request->diag) &&
	       load_machine(request, strbuf_text(&path)) &&
	       (!request->pictures || draw(request, strbuf_text(&path), strbuf_text(&page)));
	strbuf_release(&path);
	strbuf_release(&page);
	return good;
}

/* Are the files of the machine new? False: reported. */
static bool machine_is_new(const struct request *request)
{
	struct strbuf path = {0}, page = {0};
	bool good;

	strbuf_addf(&path, "%s/machine.xml", request->output);
	strbuf_addf(&page, "%s/axes.html", request->output);
	good = import_output_is_new(strbuf_text(&path), request->diag) &&
	       (!request->pictures || import_output_is_new(strbuf_text(&page), request->diag));
	strbuf_release(&path);
	strbuf_release(&page);
	return good;
}

static bool import_machine(const struct request *request, enum file_kind kind)
{
	struct import_machine machine = {0};
	bool good = machine_is_new(request) && read_machine(request, kind, &machine) &&
		    write_machine(request, &machine);

	import_machine_release(&machine);
	return good;
}

static struct library_options library_options(const struct request *request)
{
	return (struct library_options){.unit = request->unit == UNIT_INCH ? MM_PER_INCH : 1,
					.number_all = request->number_tools,
					.shapes = true};
}

static bool import_project(const struct request *request)
{
	const struct library_options options = library_options(request);
	struct import_project project = {0};
	bool good = machine_is_new(request) &&
		    vericut_project_read(&project, request->file, &request->options, request->diag) &&
		    import_jobs_are_new(&project, request->output, request->diag) &&
		    write_machine(request, &project.machine) &&
		    import_jobs_write(&project, request->output, request->file, &options, request->diag);

	import_project_release(&project);
	return good;
}

static bool read_tools(const struct request *request, struct tool_library *tools)
{
	const struct library_options options = library_options(request);
	const struct setup_description *setup = &tools->setup;

	if (!library_file_read(tools, request->file, &options, request->diag))
		return false;
	if (setup->tool_count || setup->length_count || setup->offset_count || setup->value_count)
		return true;
	diag_error(request->diag, (struct srcloc){.file = request->file}, "no tool of the library can be converted");
	return false;
}

static void warn_unit(const struct request *request)
{
	if (request->unit == UNIT_UNKNOWN)
		diag_warning(request->diag, (struct srcloc){.file = request->file},
			     "this file does not give its unit: its lengths count as mm; with --units=inch they count "
			     "as inches");
}

static void note_tools(const char *path, const struct tool_library *tools, struct diag *diag)
{
	const size_t count = tools->setup.tool_count, offsets = tools->setup.length_count + tools->setup.offset_count;

	diag_note(diag, nowhere,
		  "wrote %s with %zu %s and %zu %s, and left %zu %s out; next: add the rest of the job: work offsets, "
		  "fixtures, the part",
		  path, count, format_units_noun(count, "tool", "tools"), offsets,
		  format_units_noun(offsets, "offset", "offsets"), tools->left_out,
		  format_units_noun(tools->left_out, "tool", "tools"));
}

static bool import_tools(const struct request *request)
{
	struct tool_library tools = {0};
	struct strbuf path = {0};
	bool good;

	strbuf_addf(&path, "%s/setup.xml", request->output);
	good = import_output_is_new(strbuf_text(&path), request->diag) && read_tools(request, &tools);
	if (good && tools.unit_is_assumed)
		warn_unit(request);
	good = good && import_output_write_tools(&tools, request->output, request->file, request->diag);
	if (good)
		note_tools(strbuf_text(&path), &tools, request->diag);
	tool_library_release(&tools);
	strbuf_release(&path);
	return good;
}

/* Reads every part of the file as a body, without a machine. False: reported. */
static bool read_parts(const struct request *request, struct import_machine *machine)
{
	const enum mesh_format format = mesh_file_format(request->file);
	const double unit = format == MESH_GLTF ? 1000 : request->unit == UNIT_INCH ? MM_PER_INCH : 1;
	const xform frame = xform_identity();
	struct mesh_parts parts = {0};
	bool good;

	if (format == MESH_3MF && request->unit == UNIT_UNKNOWN) {
		diag_error(request->diag, (struct srcloc){.file = request->file},
			   "fivecheck cannot read the unit from this kind of file: give --units=mm or --units=inch");
		return false;
	}
	good = (format != MESH_PLY || ply_check(request->file, request->diag)) &&
	       (format != MESH_3MF || zip_check(request->file, request->diag)) &&
	       mesh_helper_read(&parts, request->file, unit, format == MESH_GLTF, request->diag);
	if (good && (format == MESH_OBJ || format == MESH_PLY))
		warn_unit(request);
	for (size_t i = 0; good && i < parts.count; i++) {
		struct mesh mesh = {0};

		mesh_build_finish(&parts.items[i].build, &mesh);
		import_machine_add_body(machine, parts.items[i].name, "mesh", 0, &frame, &mesh);
	}
	mesh_parts_release(&parts);
	return good;
}

static bool import_meshes(const struct request *request)
{
	struct import_machine machine = {0};
	struct strbuf path = {0};
	bool good;

	strbuf_addf(&path, "%s/stl", request->output);
	good = import_output_is_new(strbuf_text(&path), request->diag) && read_parts(request, &machine) &&
	       import_output_write_meshes(&machine, request->output, request->diag);
	for (size_t i = 0; good && i < machine.description.body_count; i++)
		diag_note(request->diag, nowhere, "wrote %s/%s with %zu triangles, in mm", request->output,
			  machine.description.bodies[i].mesh_path, machine.meshes[i].count);
	import_machine_release(&machine);
	strbuf_release(&path);
	return good;
}

static bool import_file(const struct request *request)
{
	enum file_kind kind;

	if (!file_kind_of(&kind, request->file, request->diag))
		return false;
	if (kind == FILE_MESH)
		return import_meshes(request);
	if (kind == FILE_VERICUT_PROJECT)
		return import_project(request);
	return kind == FILE_TOOLS ? import_tools(request) : import_machine(request, kind);
}

/* False: reported. */
static bool check_request(const struct request *request, const struct operands *files)
{
	if (files->count != 1)
		diag_error(request->diag, nowhere, "import needs one file");
	else if (!request->output)
		diag_error(request->diag, nowhere, "import needs a folder to write to: --output=FOLDER");
	else
		return true;
	return false;
}

enum run_status import_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct mesh_sources sources = {0};
	struct request request = {
		.options.sources = &sources, .unit = UNIT_UNKNOWN, .dialect = -1, .diag = &ui->diag};
	struct operands files = {0};
	enum run_status status;

	(void)all;
	if (subcommand_read(&subcommand, &request, &files, argc, argv, &ui->diag, &status)) {
		if (check_request(&request, &files)) {
			request.file = files.items[0];
			status = import_file(&request) ? RUN_CLEAR : RUN_INCOMPLETE;
		} else {
			status = subcommand_refuse(&subcommand, &ui->diag);
		}
	}
	mesh_sources_release(&sources);
	operands_release(&files);
	return status;
}
