#include "machine/xml/place_xml.h"

#include <string.h>

#include "base/units.h"

/* Letters apart by blanks or nothing: "Z X Y", "ZXY". */
static void read_order(struct xml_reader *xml, const xmlNode *node, const char *text, struct control_place *place)
{
	bool seen[SLOT_COUNT] = {false};

	for (; *text; text++) {
		int slot = slot_of_letter(*text);

		if (*text == ' ')
			continue;
		if (slot < 0 || !place->has[slot]) {
			xml_error(xml, node, "order of <%s>: it gives no position for '%c'", (const char *)node->name,
				  *text > ' ' && *text < 127 ? *text : '?');
			return;
		}
		if (seen[slot]) {
			xml_error(xml, node, "order of <%s> names %c twice", (const char *)node->name, *text);
			return;
		}
		seen[slot] = true;
		place->order[place->order_count++] = slot;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		if (place->has[slot] && !seen[slot])
			xml_error(xml, node, "order of <%s> leaves out %c", (const char *)node->name,
				  AXIS_LETTERS[slot]);
}

/* Z first, so that the tool leaves the work, and then one axis after another. */
static void default_order(struct control_place *place)
{
	if (place->has[SLOT_Z])
		place->order[place->order_count++] = SLOT_Z;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		if (place->has[slot] && slot != SLOT_Z)
			place->order[place->order_count++] = slot;
}

static void read_value(struct xml_reader *xml, const xmlNode *node, const struct machine *machine, int slot,
		       struct control_place *place)
{
	const char letter[] = {AXIS_LETTERS[slot], '\0'};
	const struct axis *axis = machine_axis(machine, slot);
	double tolerance = slot_is_rotary(slot) ? radians(LIMIT_TOLERANCE) : LIMIT_TOLERANCE;
	double value;

	if (!xml_attribute(node, letter))
		return;
	if (!axis) {
		xml_error(xml, node, "<%s> has a position for %s, but the machine has no axis %s",
			  (const char *)node->name, letter, letter);
		return;
	}
	value = slot_is_rotary(slot) ? xml_angle(xml, node, letter, 0) : xml_length(xml, node, letter, 0);
	if (value < axis->limit_min - tolerance || value > axis->limit_max + tolerance)
		xml_error(xml, node, "%s=\"%s\" of <%s> lies outside the limits of axis %s", letter,
			  xml_quote(xml_attribute(node, letter)).text, (const char *)node->name, letter);
	place->has[slot] = true;
	place->value.v[slot] = value;
}

static void read_place(struct xml_reader *xml, const xmlNode *node, const struct machine *machine, bool ordered,
		       struct control_place *place)
{
	const char *order = xml_attribute(node, "order");

	bool any = false;

	if (place->given) {
		xml_error(xml, node, "<%s> is given twice", (const char *)node->name);
		return;
	}
	place->given = true;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		read_value(xml, node, machine, slot, place);
		any = any || place->has[slot];
	}
	/* A tool may be changed where the spindle stands. */
	if (!any && (!ordered || order))
		xml_error(xml, node, "<%s> gives no position", (const char *)node->name);
	else if (order)
		read_order(xml, node, order, place);
	else if (ordered)
		default_order(place);
}

void places_read(struct xml_reader *xml, const xmlNode *controller, struct machine *machine)
{
	struct controller *out = &machine->controller;

	for (const xmlNode *node = xml_first(controller); node; node = xml_next(node)) {
		if (xml_is(node, "tool_change")) {
			read_place(xml, node, machine, true, &out->tool_change);
		} else if (xml_is(node, "reference")) {
			int number = xml_integer(xml, node, "number", 1, 1, REFERENCES_MAX);

			read_place(xml, node, machine, false, &out->references[number - 1]);
		}
	}
}
