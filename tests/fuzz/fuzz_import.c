/* Any bytes as a machine, a project or a mesh of another program; its content tells which it is. */
#include <libxml/parser.h>

#include "fuzz.h"
#include "import/emc_machine.h"
#include "import/file_kind.h"
#include "import/freecad_machine.h"
#include "import/import_project.h"
#include "import/machine_writer.h"
#include "import/mtconnect_machine.h"
#include "import/ply_check.h"
#include "import/setup_writer.h"
#include "import/urdf_machine.h"
#include "import/vericut_machine.h"
#include "import/vericut_mesh.h"
#include "import/vericut_project.h"
#include "import/zip_check.h"

/* The files that a seed names are beside it. */
static const struct import_options options = {.meshes = "tests/fuzz/seeds", .skip_missing = true};

/* What is written must be XML, whatever names the file has. */
static void demand_xml(struct strbuf *text)
{
	xmlDoc *doc = xmlReadMemory(text->text, (int)text->length, NULL, NULL, XML_PARSE_NOERROR | XML_PARSE_NOWARNING);

	if (!doc)
		abort();
	xmlFreeDoc(doc);
	strbuf_release(text);
}

static void write_machine(const struct import_machine *machine)
{
	struct strbuf text = {0};

	machine_writer_xml(&text, machine, "fuzz");
	demand_xml(&text);
}

static void write_setups(const struct import_project *project)
{
	const struct setup_description tools = {0};

	for (size_t i = 0; i < project->setup_count; i++) {
		struct strbuf text = {0};

		setup_writer_xml(&text, &tools, &project->setups[i], "fuzz");
		demand_xml(&text);
	}
}

static bool read_machine(const char *path, enum file_kind kind, struct diag *diag)
{
	struct import_machine machine = {0};
	bool good = kind == FILE_EMC_MACHINE ? emc_machine_read(&machine, path, &options, diag)
		    : kind == FILE_FREECAD   ? freecad_machine_read(&machine, path, &options, diag)
		    : kind == FILE_MTCONNECT ? mtconnect_machine_read(&machine, path, &options, diag)
		    : kind == FILE_URDF	     ? urdf_machine_read(&machine, path, &options, diag)
					     : vericut_machine_read(&machine, path, NULL, &options, diag);

	if (good)
		write_machine(&machine);
	import_machine_release(&machine);
	return good;
}

static bool read_project(const char *path, struct diag *diag)
{
	struct import_project project = {0};
	bool good = vericut_project_read(&project, path, &options, diag);

	if (good) {
		write_machine(&project.machine);
		write_setups(&project);
	}
	import_project_release(&project);
	return good;
}

/*
 * What is done with a mesh before a library reads it. Its format is told by its first bytes, because the file has no
 * ending. False: no mesh.
 */
static bool check_mesh(const char *path, const uint8_t *data, size_t size, struct diag *diag)
{
	struct mesh mesh = {0};
	bool good;

	if (size > 4 && !memcmp(data, "ply\n", 4))
		good = ply_check(path, diag);
	else if (size > 4 && !memcmp(data, "PK\003\004", 4))
		good = zip_check(path, diag);
	else if (size > 7 && !memcmp(data, "VERICUT", 7))
		good = vericut_mesh_read(&mesh, path, 1, diag);
	else
		return false;
	mesh_release(&mesh);
	if (good != (diag->errors == 0))
		abort();
	return true;
}

static bool read_file(const char *path, struct diag *diag)
{
	enum file_kind kind;

	if (!file_kind_of(&kind, path, diag))
		return false;
	if (kind == FILE_VERICUT_PROJECT)
		return read_project(path, diag);
	/* fuzz_library reads tools. */
	return kind == FILE_TOOLS || read_machine(path, kind, diag);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct diag diag = {.handle = fuzz_note};
	const char *path = fuzz_file(data, size);

	if (!check_mesh(path, data, size, &diag) && read_file(path, &diag) != (diag.errors == 0))
		abort();
	unlink(path);
	return 0;
}
