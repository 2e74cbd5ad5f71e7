/* realpath is one of the X/Open extensions of POSIX. */
#define _XOPEN_SOURCE 700

#include "base/ascii.h"
#include "import/vericut_project.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/strbuf.h"
#include "import/file_kind.h"
#include "import/mesh_file.h"
#include "import/vericut_build.h"
#include "import/vericut_components.h"
#include "import/vericut_machine.h"
#include "import/vericut_model.h"
#include "import/vericut_offsets.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

/* More setups or programs than a project has. */
enum { SETUPS_MAX = 100, PROGRAMS_MAX = 1000 };

struct reading {
	struct import_project *project;
	struct vericut_build first;	/* of the first setup, which the machine is made with */
	const struct import_options *options;
	struct xml_reader xml;
	struct arena arena;
	struct diag *diag;
};

/* A warning at the element, and a note for the setup file. */
static void warn(struct reading *r, struct import_setup *setup, const xmlNode *node, const char *format, ...)
	__attribute__((format(printf, 4, 5)));

static void warn(struct reading *r, struct import_setup *setup, const xmlNode *node, const char *format, ...)
{
	struct strbuf text = {0};
	va_list args;

	va_start(args, format);
	strbuf_addv(&text, format, args);
	va_end(args);
	diag_warning(r->diag, (struct srcloc){.file = r->xml.path, .line = xml_line(&r->xml, node)}, "%s",
		     strbuf_text(&text));
	import_machine_todo(&setup->bodies, "%s", strbuf_text(&text));
	strbuf_release(&text);
}

/* --------------------------------------------------------------------- files */

/* The file for a path from another computer, in the arena; NULL: it is missing. */
static const char *find_file(const struct reading *r, struct arena *arena, const char *written)
{
	struct strbuf path = {0};
	const char *found = NULL;

	if (mesh_file_find(&path, r->options->meshes, r->xml.path, written))
		found = arena_strdup(arena, strbuf_text(&path));
	strbuf_release(&path);
	return found;
}

/* All setups must refer to the same machine. False: reported. */
static bool find_machine(struct reading *r, const char **path)
{
	const char *first = NULL;
	enum file_kind kind;

	for (const xmlNode *setup = foreign_child(xml_root(&r->xml), "Setup"); setup;
	     setup = foreign_next(setup, "Setup")) {
		const xmlNode *file = foreign_child(foreign_child(setup, "Machine"), "File");
		const char *written = foreign_text(&r->arena, file);

		if (*written && first && !ascii_same(first, written)) {
			xml_error(&r->xml, file, NULL,
				  "the setups of this project are on several machines: save each as a project of its "
				  "own");
			return false;
		}
		first = *written ? written : first;
	}
	if (!first) {
		xml_error(&r->xml, xml_root(&r->xml), NULL, "no <Setup> of this project names a machine");
		return false;
	}
	*path = find_file(r, &r->arena, first);
	if (*path && !file_kind_of(&kind, *path, r->diag))
		return false;
	if (*path && kind != FILE_VERICUT_MACHINE) {
		xml_error(&r->xml, xml_root(&r->xml), NULL,
			  "'%s' is not a VERICUT machine: its root must be <VcMachine>", xml_quote(first).text);
		return false;
	}
	if (!*path)
		xml_error(&r->xml, xml_root(&r->xml), NULL,
			  "the machine '%s' is missing: put it beside the project, or name its folder with --meshes",
			  xml_quote(first).text);
	return *path != NULL;
}

static void find_library(struct reading *r, struct import_setup *setup, const xmlNode *node)
{
	const xmlNode *library = foreign_child(foreign_child(node, "ToolMan"), "Library");
	const char *written = foreign_text(&r->arena, library);

	if (*written)
		setup->library = find_file(r, &setup->bodies.description.arena, written);
	if (!setup->library)
		warn(r, setup, library ? library : node,
		     "The tool library '%s' is missing: add the tools of the job.", xml_quote(written).text);
}

static void add_program(struct reading *r, struct import_setup *setup, const xmlNode *file)
{
	struct arena *arena = &setup->bodies.description.arena;
	const char *written = foreign_text(&r->arena, file), *found;
	char *whole;

	if (!*written || setup->program_count == PROGRAMS_MAX)
		return;
	found = find_file(r, &r->arena, written);
	whole = found ? realpath(found, NULL) : NULL;
	/* A job with a missing program must not pass without it. */
	setup->programs[setup->program_count++] = arena_strdup(arena, whole ? whole : written);
	if (!whole)
		warn(r, setup, file, "The program '%s' is missing: correct its name in jobs.xml.",
		     xml_quote(written).text);
	free(whole);
}

/* Every <File> in an element of <NCPrograms> that is not switched off. */
static void find_programs(struct reading *r, struct import_setup *setup, const xmlNode *node)
{
	const xmlNode *programs = foreign_child(node, "NCPrograms");

	setup->programs = arena_alloc(&setup->bodies.description.arena, PROGRAMS_MAX * sizeof(*setup->programs));
	for (const xmlNode *at = foreign_child(programs, NULL); at; at = foreign_next(at, NULL)) {
		if (foreign_is(at, "File"))
			add_program(r, setup, at);
		if (foreign_attribute_is(at, "Use", "off") || foreign_attribute_is(at, "Flag", "off"))
			continue;
		for (const xmlNode *file = foreign_child(at, "File"); file; file = foreign_next(file, "File"))
			add_program(r, setup, file);
	}
}

/* -------------------------------------------------------------------- bodies */

/* False: the component does not belong to a setup. */
static bool role_of(const struct vericut_component *component, enum body_role *role)
{
	static const struct {
		const char *type;
		enum body_role role;
	} roles[] = {{"fixture", ROLE_FIXTURE}, {"stock", ROLE_STOCK}, {"design", ROLE_PART}};

	for (size_t i = 0; i < sizeof(roles) / sizeof(*roles); i++) {
		*role = roles[i].role;
		if (ascii_same(component->type, roles[i].type))
			return true;
	}
	return false;
}

/* The body of the stock; -1: there is none yet. */
static int find_stock(const struct import_setup *setup)
{
	for (size_t i = 0; i < setup->bodies.description.body_count; i++)
		if (setup->bodies.description.bodies[i].role == ROLE_STOCK)
			return (int)i;
	return -1;
}

/* Are the boxes around both meshes apart? Touching boxes are not. */
static bool are_apart(const struct mesh *a, const struct mesh *b)
{
	vec3 a_least, a_most, b_least, b_most;

	mesh_bounds(a, &a_least, &a_most);
	mesh_bounds(b, &b_least, &b_most);
	return a_most.x < b_least.x || b_most.x < a_least.x || a_most.y < b_least.y || b_most.y < a_least.y ||
	       a_most.z < b_least.z || b_most.z < a_least.z;
}

/*
 * Adds another model to the mesh of the stock: a setup has one stock. Its solids must be apart, because the union of
 * touching solids is not a closed mesh. False: they are not.
 */
static bool join_stock(struct import_setup *setup, int stock, struct vericut_model *model)
{
	struct mesh *mesh = &setup->bodies.meshes[stock];
	const xform inverse = xform_inverse(&setup->bodies.description.bodies[stock].frame);
	const xform place = xform_mul(&inverse, &model->frame);

	for (size_t i = 0; i < model->mesh.count; i++)
		for (int k = 0; k < 3; k++) {
			float *corner = model->mesh.triangles[i].v[k];
			const vec3 moved = xform_apply(&place, mesh_corner(&model->mesh.triangles[i], k));

			corner[0] = (float)moved.x;
			corner[1] = (float)moved.y;
			corner[2] = (float)moved.z;
		}
	if (!mesh->count || !model->mesh.count || !are_apart(mesh, &model->mesh))
		return false;
	mesh->triangles = mem_realloc(mesh->triangles, mesh->count + model->mesh.count, sizeof(*mesh->triangles));
	memcpy(mesh->triangles + mesh->count, model->mesh.triangles, model->mesh.count * sizeof(*mesh->triangles));
	mesh->count += model->mesh.count;
	return true;
}

static bool read_body(struct reading *r, struct import_setup *setup, const struct vericut_component *component,
		      const xmlNode *node)
{
	struct vericut_model model;
	enum body_role role;
	int stock;

	if (!role_of(component, &role)) {
		xml_error(&r->xml, component->node, "Type",
			  "'%s' of the setup is of the type %s, which cannot be converted; only axes, fixture, stock "
			  "and design can",
			  xml_quote(component->name).text, xml_quote(component->type).text);
		return false;
	}
	stock = role == ROLE_STOCK ? find_stock(setup) : -1;
	if (!vericut_model_read(&model, &r->xml, node, component, r->options, &setup->bodies.description.arena))
		return false;
	setup->bodies.left_out += model.left_out;
	if (!model.left_out && stock >= 0) {
		bool joined = join_stock(setup, stock, &model);

		mesh_release(&model.mesh);
		if (!joined)
			xml_error(&r->xml, node, NULL,
				  "the stock has several models that are not apart: save it as one STL");
		return joined;
	}
	if (!model.left_out)
		import_machine_add_body(&setup->bodies, model.name, component->name, 0, &model.frame, &model.mesh)
			->role = role;
	return true;
}

static bool read_bodies(struct reading *r, struct import_setup *setup, const struct vericut_components *components)
{
	for (size_t i = 0; i < components->count; i++) {
		const struct vericut_component *component = components->order[i];

		for (const xmlNode *at = foreign_child(component->node, NULL); at; at = foreign_next(at, NULL))
			if (vericut_part_is_model(at) && !read_body(r, setup, component, at))
				return false;
	}
	return true;
}

/* -------------------------------------------------------------------- setups */

static bool is_plain(char letter)
{
	return ascii_is_alphanumeric(letter) || strchr("._-", letter);
}

/* The name becomes part of file names, and of the name of a job. */
static void name_setup(struct reading *r, struct import_setup *setup, const xmlNode *node)
{
	const size_t count = r->project->setup_count;
	const char *wanted = foreign_attribute(node, "Name");
	bool good = wanted && *wanted && *wanted != '.' && strlen(wanted) < 60;
	struct strbuf name = {0};

	for (const char *at = wanted; good && *at; at++)
		good = is_plain(*at);
	for (size_t i = 0; good && i < count; i++)
		good = !ascii_same(r->project->setups[i].name, wanted);
	if (good)
		strbuf_addf(&name, "%s", wanted);
	else
		strbuf_addf(&name, "setup.%zu", count + 1);
	setup->name = arena_strdup(&setup->bodies.description.arena, strbuf_text(&name));
	strbuf_clear(&name);
	strbuf_addf(&name, "stl-%s", setup->name);
	setup->bodies.folder = arena_strdup(&setup->bodies.description.arena, strbuf_text(&name));
	strbuf_release(&name);
}

/* The clearances of the collision list between machine and setup are not imported: note their values. */
static void note_collisions(struct reading *r, struct import_setup *setup, const xmlNode *node)
{
	const xmlNode *list = foreign_child(foreign_child(node, "Machine"), "Collision");
	double most = 0;

	for (const xmlNode *at = foreign_child(list, "Between"); at; at = foreign_next(at, "Between")) {
		const char *text = foreign_attribute(at, "Tol");
		const double value = text ? strtod(text, NULL) : 0;

		most = value > most ? value : most;
	}
	if (most > 0)
		warn(r, setup, list,
		     "The collision list of the setup keeps up to %.10g mm, which is not converted: all pairs that can "
		     "meet are checked; give the distance with the option clearance.",
		     r->xml.unit * most);
}

/* Notes which of several places carries the work, and which parts of the first setup are in machine.xml. */
static void note_build(struct reading *r, struct import_setup *setup, const xmlNode *node,
		       const struct vericut_build *build)
{
	if (build->other_mount)
		warn(r, setup, foreign_child(node, "Build"),
		     "Stock and design have no models in this setup: the work is assumed to be on '%s', not on '%s'. "
		     "If that is wrong, give one of them its model in the project, and import it again.",
		     xml_quote(build->mount).text, xml_quote(build->other_mount).text);
	for (size_t i = 0; setup == r->project->setups && i < build->count; i++) {
		const struct vericut_part *part = &build->parts[i];

		if (!part->mounted && (vericut_part_is_axis(part) || vericut_part_has_model(part)))
			diag_note(r->diag,
				  (struct srcloc){.file = r->xml.path, .line = xml_line(&r->xml, part->node)},
				  "'%s' of the setup is in machine.xml, because it moves or is beside the work",
				  xml_quote(part->name).text);
	}
}

/* A stock without a model is usually the one that the setup before leaves. It would be missing without notice. */
static void warn_of_stock(struct reading *r, struct import_setup *setup, const struct vericut_build *build)
{
	for (size_t i = 0; i < build->count; i++) {
		const struct vericut_part *part = &build->parts[i];

		if (!ascii_same(part->type, "stock") || vericut_part_has_model(part) || find_stock(setup) >= 0)
			continue;
		warn(r, setup, part->node,
		     "'%s' has no model in this setup: without <stock> contacts with material are not found. Add the "
		     "stock; the option stock-out writes the one that the setup before leaves.",
		     xml_quote(part->name).text);
		return;
	}
}

/* Reads the bodies that the setup mounts. The first setup is that of r->first. */
static bool read_build(struct reading *r, struct import_setup *setup, const xmlNode *node,
		       struct vericut_components *components)
{
	struct arena *arena = &setup->bodies.description.arena;
	struct vericut_build build = r->first;

	if (setup != r->project->setups &&
	    (!vericut_build_read(&build, &r->xml, node, arena) || !vericut_build_same(&build, &r->first)))
		return false;
	note_build(r, setup, node, &build);
	if (!vericut_components_mounted(components, &build, arena) || !read_bodies(r, setup, components))
		return false;
	warn_of_stock(r, setup, &build);
	return true;
}

static bool read_setup(struct reading *r, const xmlNode *node)
{
	struct import_project *project = r->project;
	struct import_setup *setup = &project->setups[project->setup_count];
	struct vericut_components components = {0};

	*setup = (struct import_setup){.bodies = {.beside = &project->machine}};
	name_setup(r, setup, node);
	project->setup_count++;
	if (!project->machine.work_name) {
		xml_error(&r->xml, node, NULL, "the machine has no component of the type attach, so no work is on it");
		return false;
	}
	if (!read_build(r, setup, node, &components))
		return false;
	if (!vericut_offsets_read(setup, &project->machine, &components, &r->xml, node))
		return false;
	find_library(r, setup, node);
	find_programs(r, setup, node);
	note_collisions(r, setup, node);
	/* They point into the tree of the file. */
	for (size_t i = 0; i < setup->bodies.description.body_count; i++)
		setup->bodies.description.bodies[i].at = NULL;
	return true;
}

static bool read_project(struct reading *r)
{
	const xmlNode *root = xml_root(&r->xml);
	const char *machine;
	size_t count = 0;

	r->xml.unit = vericut_unit(&r->xml, root);
	for (const xmlNode *node = foreign_child(root, "Setup"); node; node = foreign_next(node, "Setup"))
		count++;
	if (count > SETUPS_MAX) {
		xml_error(&r->xml, root, NULL, "the project has %zu setups; 1 to %d can be read", count, SETUPS_MAX);
		return false;
	}
	if (!(r->xml.unit > 0) || !find_machine(r, &machine) ||
	    !vericut_build_read(&r->first, &r->xml, foreign_child(root, "Setup"), &r->arena) ||
	    !vericut_machine_read(&r->project->machine, machine, &r->first, r->options, r->diag))
		return false;
	r->project->setups = mem_zalloc(count, sizeof(*r->project->setups));
	for (const xmlNode *node = foreign_child(root, "Setup"); node; node = foreign_next(node, "Setup"))
		if (!read_setup(r, node))
			return false;
	return true;
}

bool vericut_project_read(struct import_project *project, const char *path, const struct import_options *options,
			  struct diag *diag)
{
	static const char *const elements[] = {"VcProject", NULL};
	struct reading r = {.project = project, .options = options, .diag = diag};
	bool good;

	if (!xml_open(&r.xml, path, elements, diag))
		return false;
	good = read_project(&r) && !r.xml.errors;
	arena_release(&r.arena);
	xml_close(&r.xml);
	return good;
}
