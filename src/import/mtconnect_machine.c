#include "import/mtconnect_machine.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/axes.h"
#include "base/strbuf.h"
#include "import/axis_chains.h"
#include "import/mtconnect_motion.h"
#include "import/mtconnect_travel.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

struct mtconnect_axis {
	const xmlNode *node, *motion;	/* motion NULL: it has none */
	struct axis_description axis;
};

struct reading {
	struct import_machine *machine;
	const struct import_options *options;
	struct diag *diag;
	struct xml_reader xml;
	const xmlNode *device;
	struct mtconnect_axis axes[SLOT_COUNT];
	struct axis_letters letters, still;	/* of all axes; of those without a Motion */
	const xmlNode *spindle;	/* the Motion of the spindle, or NULL */
	size_t spindles;	/* with a Motion */
};

static bool fault(struct reading *r, const xmlNode *node, const char *what)
{
	xml_error(&r->xml, node, NULL, "%s", what);
	return false;
}

static struct srcloc place(const struct reading *r, const xmlNode *node)
{
	return (struct srcloc){.file = r->xml.path, .line = xmlGetLineNo(node)};
}

/* --------------------------------------------------------------- components */

static bool has_item(const xmlNode *component, const char *type)
{
	const xmlNode *list = foreign_child(component, "DataItems");

	for (const xmlNode *at = foreign_child(list, "DataItem"); at; at = foreign_next(at, "DataItem"))
		if (foreign_attribute_is(at, "type", type))
			return true;
	return false;
}

/* A control names its spindles S; they have a speed and no angle. */
static bool is_spindle(const xmlNode *component)
{
	const char *native = foreign_attribute(component, "nativeName"), *name = foreign_attribute(component, "name");
	const char *called = native && *native ? native : name ? name : "";

	if (!foreign_is(component, "Rotary"))
		return false;
	if (ascii_upper(*called) == 'S')
		return true;
	return !has_item(component, "ANGLE") &&
	       (has_item(component, "ROTARY_VELOCITY") || has_item(component, "SPINDLE_SPEED"));
}

/* The letter of X, X1 and the like; 0: the name is not one of an axis. */
static char letter_of(const char *name)
{
	char letter;

	if (!name || !*name)
		return 0;
	letter = ascii_upper(*name);
	return slot_of_letter(letter) < 0 || name[1 + strspn(name + 1, "0123456789")] ? '\0' : letter;
}

static bool add_component(struct reading *r, const xmlNode *node, struct axis_letters *found)
{
	const bool rotary = foreign_is(node, "Rotary");
	char letter = letter_of(foreign_attribute(node, "nativeName"));
	struct mtconnect_axis *axis;

	letter = letter ? letter : letter_of(foreign_attribute(node, "name"));
	if (!letter || slot_is_rotary(slot_of_letter(letter)) != rotary)
		return fault(r, node, rotary ? "neither nativeName nor name of this Rotary is A, B or C" :
					       "neither nativeName nor name of this Linear is X, Y, Z, U, V or W");
	if (axis_letters_have(found->text, letter)) {
		xml_error(&r->xml, node, NULL,
			  "two axes of this device have the letter %c: remove those from the file that do not belong "
			  "to the tool and the work of one program", letter);
		return false;
	}
	axis_letters_add(found, letter);
	axis = &r->axes[slot_of_letter(letter)];
	*axis = (struct mtconnect_axis){
		.node = node,
		.motion = mtconnect_motion(node),
		.axis = {.slot = slot_of_letter(letter), .rotary = rotary},
	};
	if (!axis->motion)
		axis_letters_add(&r->still, letter);
	return mtconnect_travel(&r->xml, r->device, node, &axis->axis);
}

static bool read_components(struct reading *r)
{
	struct axis_letters found = {""};

	for (const xmlNode *at = r->device; at; at = mtconnect_next(r->device, at)) {
		if (is_spindle(at)) {
			const xmlNode *motion = mtconnect_motion(at);

			r->spindle = motion ? motion : r->spindle;
			r->spindles += motion != NULL;
		} else if ((foreign_is(at, "Linear") || foreign_is(at, "Rotary")) && !add_component(r, at, &found)) {
			return false;
		}
	}
	for (const char *at = "XYZABCUVW"; *at; at++)
		if (axis_letters_have(found.text, *at))
			axis_letters_add(&r->letters, *at);
	return *r->letters.text || fault(r, r->device, "the device has no Linear or Rotary component that is an axis");
}

/* ------------------------------------------------------------------- chains */

/* The letter of the axis that carries the Motion; 0: the base carries it. False: reported. */
static bool carrier(struct reading *r, const xmlNode *motion, char *letter)
{
	*letter = 0;
	for (int depth = 0; depth < 2 * SLOT_COUNT; depth++) {
		if (!mtconnect_parent(&r->xml, r->device, motion, &motion))
			return false;
		if (!motion)
			return true;
		for (const char *at = r->letters.text; *at; at++)
			if (r->axes[slot_of_letter(*at)].motion == motion) {
				*letter = *at;
				return true;
			}
		if (!foreign_attribute_is(motion, "type", "FIXED"))
			return fault(r, motion, "a Motion that is not an axis of the control carries an axis");
	}
	return fault(r, r->device, "the parents of the Motion elements form a circle");
}

static void reverse(struct axis_letters *letters)
{
	size_t count = strlen(letters->text);

	for (size_t i = 0; i < count / 2; i++) {
		char swap = letters->text[i];

		letters->text[i] = letters->text[count - 1 - i];
		letters->text[count - 1 - i] = swap;
	}
}

/* The axes from the base to the one that carries the Motion. */
static bool climb(struct reading *r, const xmlNode *motion, struct axis_letters *letters)
{
	char letter;

	*letters = (struct axis_letters){""};
	for (;;) {
		if (!carrier(r, motion, &letter))
			return false;
		if (!letter)
			break;
		if (axis_letters_have(letters->text, letter))
			return fault(r, motion, "the parents of the Motion elements form a circle");
		axis_letters_add(letters, letter);
		motion = r->axes[slot_of_letter(letter)].motion;
	}
	reverse(letters);
	return true;
}

/* The axes that do not carry the tool must be a single chain: it carries the work. */
static bool find_work(struct reading *r, const char *head, struct axis_letters *table)
{
	struct axis_letters chain;
	size_t rest = strlen(r->letters.text) - strlen(head);

	*table = (struct axis_letters){""};
	for (const char *at = r->letters.text; *at; at++) {
		if (axis_letters_have(head, *at))
			continue;
		if (!climb(r, r->axes[slot_of_letter(*at)].motion, &chain))
			return false;
		if (strpbrk(chain.text, *head ? head : " "))
			return fault(r, r->axes[slot_of_letter(*at)].motion,
				     "an axis that carries the spindle also carries this one, which does not carry the "
				     "spindle: this is not supported");
		axis_letters_add(&chain, *at);
		if (strlen(chain.text) == rest)
			*table = chain;
	}
	return strlen(table->text) == rest ||
	       fault(r, r->device,
		     "the axes that do not carry the spindle are not a single chain: name the axes that carry the "
		     "work, in order from the base, with --table=LETTERS");
}

/* An axis that carries another by its Motion must precede it in the same chain. */
static bool judge_asked(struct reading *r, const char *letters)
{
	for (const char *at = letters; *at; at++) {
		const xmlNode *motion = r->axes[slot_of_letter(*at)].motion;
		const char *before;
		char letter = 0;

		if (motion && !carrier(r, motion, &letter))
			return false;
		before = letter ? strchr(letters, letter) : letters;
		if (before && before <= at)
			continue;
		xml_error(&r->xml, motion, NULL,
			  "this Motion says that the axis %c carries %c, which --table and --head must not contradict",
			  letter, *at);
		return false;
	}
	return true;
}

static bool find_asked(struct reading *r, struct axis_letters *table, struct axis_letters *head)
{
	if (r->options->table)
		return axis_letters_read(table, "table", r->options->table, r->letters.text, r->diag) &&
		       axis_letters_head(head, r->options->head, r->letters.text, table->text, place(r, r->device),
					 r->diag) &&
		       judge_asked(r, table->text) && judge_asked(r, head->text);
	xml_error(&r->xml, r->device, NULL,
		  "this file does not say which axes carry the work and which the tool (%s%s): name those that carry "
		  "the work, in order from the base, with --table=LETTERS, or --table= for none; it has %s",
		  *r->still.text ? "there is no Motion of " : "one spindle needs a Motion",
		  *r->still.text ? r->still.text : "", r->letters.text);
	return false;
}

static bool find_chains(struct reading *r, struct axis_letters *table, struct axis_letters *head)
{
	if (r->options->table || *r->still.text || r->spindles != 1)
		return find_asked(r, table, head);
	return climb(r, r->spindle, head) && find_work(r, head->text, table);
}

/* ------------------------------------------------------------------ machine */

/* A table that moves along +X moves the tool along -X of the work, against the coordinate of the control (ISO 841). */
static bool judge_direction(struct reading *r, const struct mtconnect_axis *axis, bool carries_work)
{
	const struct axis_description *a = &axis->axis;

	if (a->rotary || a->slot > SLOT_Z ||
	    vec3_dot(a->direction, axis_chains_direction(a->slot, carries_work)) > 0)
		return true;
	xml_error(&r->xml, axis->motion, NULL,
		  "the Axis of this Motion moves the %s along %g %g %g, so the tool moves against +%c of the work, the "
		  "positive direction of a control; reverse it if the file is wrong",
		  carries_work ? "work" : "tool", a->direction.x, a->direction.y, a->direction.z,
		  AXIS_LETTERS[a->slot]);
	return false;
}

static bool take_motion(struct reading *r, struct mtconnect_axis *axis, bool carries_work)
{
	struct axis_description *a = &axis->axis;

	if (!foreign_attribute_is(axis->motion, "type", a->rotary ? "REVOLUTE" : "PRISMATIC") &&
	    !(a->rotary && foreign_attribute_is(axis->motion, "type", "CONTINUOUS")))
		return fault(r, axis->motion, a->rotary ? "the Motion of a Rotary must be REVOLUTE or CONTINUOUS" :
							  "the Motion of a Linear must be PRISMATIC");
	if (foreign_attribute(axis->motion, "actuation") && !foreign_attribute_is(axis->motion, "actuation", "DIRECT"))
		return fault(r, axis->motion, "a Motion whose actuation is not DIRECT is not supported");
	return mtconnect_line(&r->xml, r->device, axis->motion, &a->direction, &a->location) &&
	       judge_direction(r, axis, carries_work);
}

/* Does the Motion define its place? */
static bool has_place(const xmlNode *motion)
{
	return motion && (foreign_child(motion, "Origin") || foreign_child(motion, "OriginDataSet") ||
			  foreign_child(motion, "Transformation"));
}

static bool finish_axis(struct reading *r, char letter, bool carries_work)
{
	struct mtconnect_axis *axis = &r->axes[slot_of_letter(letter)];
	struct axis_description *a = &axis->axis;

	a->has_location = a->rotary;
	if (!a->rotary && (isinf(a->limit_min) || isinf(a->limit_max))) {
		diag_warning(r->diag, place(r, axis->node), "the travel of the axis %c is not in this file", letter);
		import_machine_todo(r->machine, "Add limit_min and limit_max of the axis %c.", letter);
	}
	if (axis->motion && !take_motion(r, axis, carries_work))
		return false;
	if (!axis->motion)
		a->direction = axis_chains_direction(a->slot, carries_work);
	if (a->rotary && !has_place(axis->motion)) {
		diag_warning(r->diag, place(r, axis->node),
			     "this file does not say where the axis %c is: correct its location", letter);
		import_machine_todo(r->machine,
				    "Where is the axis %c? The imported file does not say it; 0 0 0 is a guess.",
				    letter);
	}
	return true;
}

/* Coordinates of two systems cannot be compared here. */
static bool judge_systems(struct reading *r)
{
	const char *first = NULL;

	for (const char *at = r->letters.text; *at; at++) {
		const xmlNode *motion = r->axes[slot_of_letter(*at)].motion;
		const char *system = motion ? foreign_attribute(motion, "coordinateSystemIdRef") : NULL;

		if (motion && first && strcmp(first, system ? system : "") != 0)
			return fault(r, motion, "the Motion elements of this device are in different coordinate "
						"systems, which is not supported");
		first = motion ? (system ? system : "") : first;
	}
	return true;
}

static void name_models(struct reading *r)
{
	for (const xmlNode *at = r->device; at; at = mtconnect_next(r->device, at)) {
		const char *href = foreign_is(at, "SolidModel") ? foreign_attribute(at, "href") : NULL;

		if (href)
			import_machine_todo(r->machine,
					    "The file has a solid model: %.80s. Convert it to STL, and add its parts "
					    "as bodies.", href);
	}
	import_machine_todo(r->machine, "No bodies were converted: add <body> elements, drawn with every axis at 0.");
	import_machine_todo(r->machine,
			    "The gauge point of the spindle and the mount of the work are at 0 0 0: correct both.");
}

static bool build(struct reading *r)
{
	struct machine_description *d = &r->machine->description;
	struct axis_description axes[SLOT_COUNT];
	struct axis_letters table, head;
	vec3 direction;

	if (!read_components(r) || !find_chains(r, &table, &head) || !judge_systems(r))
		return false;
	for (const char *at = r->letters.text; *at; at++)
		if (!finish_axis(r, *at, axis_letters_have(table.text, *at)))
			return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		axes[slot] = r->axes[slot].axis;
	axis_chains_hang(r->machine, axes, table.text, head.text);
	if (r->spindle && r->spindles == 1) {
		if (!mtconnect_line(&r->xml, r->device, r->spindle, &direction, NULL))
			return false;
		/* Z counts from the work to the spindle; the tool points in the opposite direction (ISO 841). */
		d->spindles[0].direction = vec3_scale(-1, direction);
		import_machine_todo(r->machine,
				    "Tools are assumed to point against the Axis of the spindle's Motion: compare it "
				    "with the machine.");
	}
	name_models(r);
	return true;
}

/* An agent describes itself as a device without axes. */
static bool has_axes(const xmlNode *device)
{
	for (const xmlNode *part = device; part; part = mtconnect_next(device, part))
		if (foreign_is(part, "Linear") || foreign_is(part, "Rotary"))
			return true;
	return false;
}

static const char *name_of_device(const xmlNode *device)
{
	static const char *const names[] = {"name", "uuid", "id"};

	for (size_t i = 0; i < sizeof(names) / sizeof(*names); i++)
		if (foreign_attribute(device, names[i]) && *foreign_attribute(device, names[i]))
			return foreign_attribute(device, names[i]);
	return "";
}

/* Is it the device that the user selected? Without a selection every device is. */
static bool is_asked_for(const struct reading *r, const xmlNode *device)
{
	static const char *const names[] = {"name", "uuid", "id"};

	for (size_t i = 0; r->options->device && i < sizeof(names) / sizeof(*names); i++) {
		const char *text = foreign_attribute(device, names[i]);

		if (text && !strcmp(text, r->options->device))
			return true;
	}
	return !r->options->device;
}

/* The only device with axes, or the selected one. False, reported with the names of the devices. */
static bool find_device(struct reading *r)
{
	const xmlNode *devices = foreign_child(xml_root(&r->xml), "Devices");
	struct strbuf names = {0};
	size_t count = 0;

	for (const xmlNode *at = foreign_child(devices, "Device"); at; at = foreign_next(at, "Device")) {
		if (!has_axes(at))
			continue;
		if (names.length < 300)
			strbuf_addf(&names, "%s'%s'", names.length ? ", " : "", xml_quote(name_of_device(at)).text);
		if (is_asked_for(r, at)) {
			r->device = at;
			count++;
		}
	}
	if (!names.length)
		fault(r, xml_root(&r->xml), "no Device of this document has a Linear or Rotary component");
	else if (count != 1)
		xml_error(&r->xml, xml_root(&r->xml), NULL, "%s: choose one with --device=NAME: %s",
			  count ? "this document has several machines" : "no machine of this document has that name",
			  strbuf_text(&names));
	strbuf_release(&names);
	return count == 1;
}

bool mtconnect_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
			    struct diag *diag)
{
	static const char *const elements[] = {"MTConnectDevices", NULL};
	struct reading r = {.machine = machine, .options = options, .diag = diag};
	const char *name;
	bool good;

	if (!xml_open_foreign(&r.xml, path, elements, diag))
		return false;
	good = find_device(&r) && build(&r) && !r.xml.errors;
	name = r.device ? foreign_attribute(r.device, "name") : NULL;
	if (name && *name)
		machine->description.name = arena_strdup(&machine->description.arena, name);
	xml_close(&r.xml);
	return good;
}
