#include "import/urdf_machine.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/axes.h"
#include "base/decimal.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "import/mesh_build.h"
#include "import/mesh_file.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

/* mm */
#define METRE 1000.0

struct urdf_link {
	const xmlNode *node;
	const char *name;
	const xmlNode *joint;	/* the joint that carries it; NULL: it is the root */
	xform frame;	/* in machine coordinates with every axis at 0, mm */
	int link;	/* of the machine */
	bool placed;
};

struct reading {
	struct import_machine *machine;
	const struct import_options *options;
	struct diag *diag;
	struct xml_reader xml;
	struct urdf_link *links;	/* in the arena */
	size_t count;
};

static bool fault(struct reading *r, const xmlNode *node, const char *what)
{
	xml_error(&r->xml, node, NULL, "%s", what);
	return false;
}

/* ---------------------------------------------------------------- macros */

static bool is_macro(const xmlNode *node)
{
	return node->type == XML_ELEMENT_NODE && node->ns && node->ns->prefix &&
	       !strcmp((const char *)node->ns->prefix, "xacro");
}

/* The node after this one in the order of the file; NULL: it is the last. */
static const xmlNode *next_node(const xmlNode *node)
{
	if (node->children && node->type == XML_ELEMENT_NODE)
		return node->children;
	while (node && !node->next)
		node = node->parent;
	return node ? node->next : NULL;
}

/* A macro may add links, and condition others: without its expansion bodies would be missing unnoticed. */
static bool has_no_macros(struct reading *r)
{
	for (const xmlNode *at = xml_root(&r->xml); at; at = next_node(at))
		if (is_macro(at))
			return fault(r, at,
				     "a macro of xacro may contain links and joints: write the expanded file with "
				     "'xacro FILE > robot.urdf', and import that");
	return true;
}

/* -------------------------------------------------------------- numbers */

static bool numbers_fault(struct reading *r, const xmlNode *node, const char *name, size_t count)
{
	xml_error(&r->xml, node, name, "%s must be %s", name, count == 1 ? "a number" : "three numbers");
	return false;
}

/* Numbers separated by blanks in an attribute; without the attribute they are not changed. False: reported. */
static bool read_numbers(struct reading *r, const xmlNode *node, const char *name, size_t count, double *values)
{
	const char *text = node ? foreign_attribute(node, name) : NULL;
	double read[3];

	if (!text)
		return true;
	for (size_t i = 0; i < count; i++) {
		size_t length;

		text += strspn(text, " \t\r\n");
		length = strcspn(text, " \t\r\n");
		if (!length || !decimal_read(text, length, &read[i]) || !isfinite(read[i]))
			return numbers_fault(r, node, name, count);
		text += length;
	}
	if (text[strspn(text, " \t\r\n")])
		return numbers_fault(r, node, name, count);
	memcpy(values, read, count * sizeof(*read));
	return true;
}

/* <origin xyz="" rpy=""/>: fixed axes X, Y, Z, radians. */
static bool read_origin(struct reading *r, const xmlNode *parent, xform *frame)
{
	const xmlNode *origin = foreign_child(parent, "origin");
	const vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
	double p[3] = {0}, a[3] = {0};
	mat3 roll, pitch, yaw, both;

	if (!read_numbers(r, origin, "xyz", 3, p) || !read_numbers(r, origin, "rpy", 3, a))
		return false;
	roll = mat3_turn(x, a[0]);
	pitch = mat3_turn(y, a[1]);
	yaw = mat3_turn(z, a[2]);
	both = mat3_mul(&yaw, &pitch);
	*frame = (xform){mat3_mul(&both, &roll), {METRE * p[0], METRE * p[1], METRE * p[2]}};
	return true;
}

/* ----------------------------------------------------------------- tree */

static struct urdf_link *find_link(const struct reading *r, const char *name)
{
	for (size_t i = 0; i < r->count; i++)
		if (name && !strcmp(r->links[i].name, name))
			return &r->links[i];
	return NULL;
}

static struct urdf_link *named_link(const struct reading *r, const xmlNode *joint, const char *element)
{
	const xmlNode *at = foreign_child(joint, element);

	return at ? find_link(r, foreign_attribute(at, "link")) : NULL;
}

static bool read_links(struct reading *r)
{
	const xmlNode *root = xml_root(&r->xml);

	r->links = arena_alloc(&r->machine->description.arena, xml_count(root, "link") * sizeof(*r->links));
	for (const xmlNode *at = foreign_child(root, "link"); at; at = foreign_next(at, "link")) {
		const char *name = foreign_attribute(at, "name");

		if (!name || !*name || find_link(r, name))
			return fault(r, at,
				     name ? "two links have the same name, or one has none" : "<link> has no name");
		r->links[r->count++] = (struct urdf_link){.node = at, .name = name};
	}
	for (const xmlNode *at = foreign_child(root, "joint"); at; at = foreign_next(at, "joint")) {
		struct urdf_link *child = named_link(r, at, "child");

		if (!child || !named_link(r, at, "parent"))
			return fault(r, at, "<joint> has a parent or a child that is not a link");
		if (child->joint)
			return fault(r, at, "two joints carry the same link");
		child->joint = at;
	}
	return r->count > 0 || fault(r, root, "the robot has no <link>");
}

/* ----------------------------------------------------------------- axes */

/* The letter of an axis that is a separate word of the name; 0: there is none, or more than one. */
static char letter_of(const char *name)
{
	char found = 0;

	for (const char *at = name; *at; at++) {
		char letter = ascii_upper(*at);
		bool alone = (at == name || !ascii_is_letter(at[-1])) && !ascii_is_letter(at[1]);

		if (!alone || slot_of_letter(letter) < 0)
			continue;
		if (found)
			return 0;
		found = letter;
	}
	return found;
}

/* <limit>: radians or metres, and these per second. */
static bool read_limits(struct reading *r, const xmlNode *joint, bool endless, struct axis_description *axis)
{
	const xmlNode *limit = foreign_child(joint, "limit");
	const double scale = axis->rotary ? 1 : METRE;
	double low = 0, high = 0, rate = 0;

	axis->limit_min = -INFINITY;
	axis->limit_max = INFINITY;
	if (!read_numbers(r, limit, "lower", 1, &low) || !read_numbers(r, limit, "upper", 1, &high) ||
	    !read_numbers(r, limit, "velocity", 1, &rate))
		return false;
	axis->rate_max = 60 * (axis->rotary ? degrees(rate) : scale * rate);
	if (endless)
		return true;
	if (!limit || !(low < high))
		return fault(r, joint, "the joint needs a <limit> with lower below upper");
	axis->limit_min = scale * low;
	axis->limit_max = scale * high;
	return (low <= 0 && high >= 0) ||
	       fault(r, joint, "0 is not within the limits of the joint, so its home is not known");
}

static bool add_axis(struct reading *r, struct urdf_link *link, const struct urdf_link *parent, const char *type)
{
	struct machine_description *d = &r->machine->description;
	const char *name = foreign_attribute(link->joint, "name");
	const char letter = name ? letter_of(name) : 0;
	struct axis_description axis = {.slot = letter ? slot_of_letter(letter) : 0, .parent = parent->link};
	double v[3] = {1, 0, 0};

	axis.rotary = strcmp(type, "prismatic") != 0;
	if (!letter || axis.rotary != slot_is_rotary(axis.slot)) {
		xml_error(&r->xml, link->joint, "name",
			  "the name of the joint must have only the letter of its axis in it, such as joint_%s: %s",
			  axis.rotary ? "a" : "x",
			  axis.rotary ? "A, B or C, because it rotates" : "X, Y, Z, U, V or W, because it slides");
		return false;
	}
	for (size_t i = 0; i < d->axis_count; i++)
		if (d->axes[i].slot == axis.slot)
			return fault(r, link->joint, "two joints have the letter of the same axis");
	if (foreign_child(link->joint, "mimic"))
		return fault(r, link->joint, "a joint that mimics another one is not supported");
	if (!read_numbers(r, foreign_child(link->joint, "axis"), "xyz", 3, v) ||
	    !read_limits(r, link->joint, !strcmp(type, "continuous"), &axis))
		return false;
	axis.direction = mat3_apply(&link->frame.rotation, (vec3){v[0], v[1], v[2]});
	if (!(vec3_norm(axis.direction) > 1e-6))
		return fault(r, link->joint, "<axis> has no direction");
	axis.has_location = axis.rotary;
	axis.location = link->frame.translation;
	axis.title = name;
	d->axes[d->axis_count++] = axis;
	link->link = (int)d->axis_count;
	return true;
}

/* Places a link whose parent is placed. */
static bool place(struct reading *r, struct urdf_link *link, const struct urdf_link *parent)
{
	const char *type = foreign_attribute(link->joint, "type");
	xform origin;

	if (!read_origin(r, link->joint, &origin))
		return false;
	link->frame = xform_mul(&parent->frame, &origin);
	link->link = parent->link;
	link->placed = true;
	if (type && !strcmp(type, "fixed"))
		return true;
	if (!type || (strcmp(type, "prismatic") && strcmp(type, "revolute") && strcmp(type, "continuous")))
		return fault(r, link->joint, "the type of a joint must be fixed, prismatic, revolute or continuous");
	return add_axis(r, link, parent, type);
}

/* Places parents before children; a cycle of links is never reached. */
static bool place_all(struct reading *r)
{
	size_t placed = 0, before;

	r->machine->description.axes =
		arena_alloc(&r->machine->description.arena, SLOT_COUNT * sizeof(struct axis_description));
	for (size_t i = 0; i < r->count; i++) {
		if (r->links[i].joint)
			continue;
		if (placed)
			return fault(r, r->links[i].node,
				     "two links have no joint that carries them: a machine has one base");
		r->links[i].placed = true;
		r->links[i].frame = xform_identity();
		placed++;
	}
	do {
		before = placed;
		for (size_t i = 0; i < r->count; i++) {
			struct urdf_link *link = &r->links[i];
			const struct urdf_link *parent = link->placed ? NULL : named_link(r, link->joint, "parent");

			if (!parent || !parent->placed)
				continue;
			if (!place(r, link, parent))
				return false;
			placed++;
		}
	} while (placed > before);
	return placed == r->count || fault(r, xml_root(&r->xml), "links carry each other in a circle");
}

/* --------------------------------------------------------------- bodies */

/* The text after "package://" or "file://"; otherwise all of it. The name of a package may be that of a folder. */
static const char *path_of(const char *written)
{
	static const char package[] = "package://", file[] = "file://";

	if (!strncmp(written, file, sizeof(file) - 1))
		return written + sizeof(file) - 1;
	return strncmp(written, package, sizeof(package) - 1) ? written : written + sizeof(package) - 1;
}

static bool read_mesh(struct reading *r, const xmlNode *shape, struct mesh *mesh, bool *left_out)
{
	const char *written = foreign_attribute(shape, "filename");
	const struct srcloc at = {.file = r->xml.path, .line = xml_line(&r->xml, shape)};
	double scale[3] = {1, 1, 1};
	struct strbuf path = {0};
	bool good;

	if (!written || !read_numbers(r, shape, "scale", 3, scale))
		return written ? false : fault(r, shape, "<mesh> has no filename");
	if (fabs(scale[0] - scale[1]) > 1e-12 || fabs(scale[0] - scale[2]) > 1e-12 || !(scale[0] > 0))
		return fault(r, shape, "the scale of a mesh must be the same in all directions, and greater than 0");
	good = mesh_file_find(&path, r->options->meshes, r->xml.path, path_of(written));
	*left_out = !good && r->options->skip_missing;
	r->machine->left_out += *left_out;
	if (good)
		mesh_sources_add(r->options->sources, path_of(written), strbuf_text(&path), at, r->diag);
	if (*left_out)
		diag_warning(r->diag, at, "'%s' is missing: the body is left out", xml_quote(written).text);
	else if (!good)
		xml_error(&r->xml, shape, NULL,
			  "'%s' is missing: put the file beside this one, name its folder with --meshes, or leave the "
			  "body out with --skip-missing",
			  xml_quote(written).text);
	good = good && mesh_file_read(mesh, strbuf_text(&path), METRE * scale[0], r->diag);
	strbuf_release(&path);
	return good;
}

static bool read_box(struct reading *r, const xmlNode *shape, struct mesh *mesh)
{
	struct mesh_build build = {.scale = METRE};
	double size[3] = {0};

	if (!read_numbers(r, shape, "size", 3, size))
		return false;
	if (!(size[0] > 0 && size[1] > 0 && size[2] > 0) ||
	    !mesh_build_block(&build, (vec3){size[0], size[1], size[2]}))
		return fault(r, shape, "the size of a box must be greater than 0 and below 5 km");
	mesh_build_finish(&build, mesh);
	return true;
}

static bool read_cylinder(struct reading *r, const xmlNode *shape, struct mesh *mesh, double *length)
{
	struct mesh_build build = {.scale = 1};
	double radius = 0;

	*length = 0;
	if (!read_numbers(r, shape, "radius", 1, &radius) || !read_numbers(r, shape, "length", 1, length))
		return false;
	if (!(radius > 0 && *length > 0) ||
	    !mesh_build_frustum(&build, METRE * radius, METRE * radius, METRE * *length))
		return fault(r, shape, "radius and length of a cylinder must be greater than 0 and below 5 km");
	mesh_build_finish(&build, mesh);
	return true;
}

/* Boxes and cylinders of URDF have their middle at the origin, those of mesh_build do not. */
static void center(xform *frame, double x, double y, double z)
{
	frame->translation = xform_apply(frame, (vec3){-METRE * x / 2, -METRE * y / 2, -METRE * z / 2});
}

static bool add_shape(struct reading *r, const struct urdf_link *link, const xmlNode *group)
{
	const xmlNode *geometry = foreign_child(group, "geometry"),
		      *shape = geometry ? foreign_child(geometry, NULL) : NULL;
	struct mesh mesh = {0};
	double size[3] = {0}, length;
	bool good, left_out = false;
	xform frame;

	if (!shape)
		return fault(r, group, "<geometry> has no shape");
	if (!read_origin(r, group, &frame))
		return false;
	frame = xform_mul(&link->frame, &frame);
	if (foreign_is(shape, "mesh")) {
		good = read_mesh(r, shape, &mesh, &left_out);
	} else if (foreign_is(shape, "box")) {
		good = read_box(r, shape, &mesh) && read_numbers(r, shape, "size", 3, size);
		center(&frame, size[0], size[1], size[2]);
	} else if (foreign_is(shape, "cylinder")) {
		good = read_cylinder(r, shape, &mesh, &length);
		center(&frame, 0, 0, length);
	} else {
		return fault(r, shape, "only mesh, box and cylinder can be converted: save the shape as STL");
	}
	if (good)
		import_machine_add_body(r->machine, link->name, "link", link->link, &frame, &mesh);
	return good || left_out;
}

static bool add_bodies(struct reading *r, const struct urdf_link *link)
{
	const char *kind = foreign_child(link->node, "collision") ? "collision" : "visual";
	bool good = true;

	for (const xmlNode *at = foreign_child(link->node, kind); at; at = foreign_next(at, kind))
		good = add_shape(r, link, at) && good;
	return good;
}

/* --------------------------------------------------------------- mounts */

static const struct urdf_link *first_named(const struct reading *r, const char *const *names)
{
	for (; *names; names++)
		for (size_t i = 0; i < r->count; i++)
			if (ascii_same(r->links[i].name, *names))
				return &r->links[i];
	return NULL;
}

static void add_mounts(struct reading *r)
{
	static const char *const tools[] = {"tool0", "tool", "spindle", NULL};
	static const char *const works[] = {"workholding", "attach", "work", "fixture", "part", NULL};
	struct machine_description *d = &r->machine->description;
	const struct urdf_link *tool = first_named(r, tools), *work = first_named(r, works);
	const struct srcloc at = {.file = r->xml.path};

	d->spindles = arena_alloc(&d->arena, sizeof(*d->spindles));
	d->workholdings = arena_alloc(&d->arena, sizeof(*d->workholdings));
	if (tool) {
		d->spindles[d->spindle_count++] = (struct spindle_description){
			.link = tool->link, .location = tool->frame.translation, .direction = tool->frame.rotation.z};
		import_machine_todo(
		    r->machine,
		    "Tools are assumed to point along +Z of the link '%.60s': compare the direction of the spindle.",
		    tool->name);
	} else {
		diag_warning(r->diag, at,
			     "no link is named spindle, tool or tool0: no tool can be mounted; add <spindle>");
		import_machine_todo(
		    r->machine,
		    "Add <spindle location=\"\" direction=\"\"/>: no link was named spindle, tool or tool0.");
	}
	if (work) {
		d->workholdings[d->workholding_count++] =
			(struct workholding_description){.link = work->link, .frame = work->frame};
	} else {
		diag_warning(r->diag, at,
			     "no link is named work, workholding, attach, fixture or part: no work can be mounted; add "
			     "<workholding>");
		import_machine_todo(
		    r->machine,
		    "Add <workholding location=\"\"/>: no link was named work, workholding, attach, fixture or part.");
	}
}

static bool read_machine(struct reading *r)
{
	struct machine_description *d = &r->machine->description;
	const char *name = foreign_attribute(xml_root(&r->xml), "name");

	d->name = name && *name ? arena_strdup(&d->arena, name) : NULL;
	if (!has_no_macros(r) || !read_links(r) || !place_all(r))
		return false;
	if (!d->axis_count)
		return fault(r, xml_root(&r->xml), "the robot has no joint that moves");
	for (size_t i = 0; i < r->count; i++)
		if (!add_bodies(r, &r->links[i]))
			return false;
	add_mounts(r);
	/* The texts of the file are released with it. */
	for (size_t i = 0; i < d->axis_count; i++)
		d->axes[i].title = arena_strdup(&d->arena, d->axes[i].title);
	return true;
}

bool urdf_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
		       struct diag *diag)
{
	static const char *const elements[] = {"robot", NULL};
	struct reading r = {.machine = machine, .options = options, .diag = diag};
	bool good;

	if (!xml_open_foreign(&r.xml, path, elements, diag))
		return false;
	good = read_machine(&r) && !r.xml.errors;
	xml_close(&r.xml);
	return good;
}
