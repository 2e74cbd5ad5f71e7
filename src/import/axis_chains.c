#include "import/axis_chains.h"

#include <string.h>

#include "base/ascii.h"

static const struct srcloc nowhere;

bool axis_letters_have(const char *letters, char letter)
{
	return letter && strchr(letters, letter);
}

void axis_letters_add(struct axis_letters *letters, char letter)
{
	size_t count = strlen(letters->text);

	if (count == SLOT_COUNT || axis_letters_have(letters->text, letter))
		return;
	letters->text[count] = letter;
	letters->text[count + 1] = '\0';
}

bool axis_letters_read(struct axis_letters *letters, const char *option, const char *asked, const char *axes,
		       struct diag *diag)
{
	struct axis_letters read = {""};

	for (const char *at = asked; at && *at; at++) {
		char letter = ascii_upper(*at);

		if (!axis_letters_have(axes, letter) || axis_letters_have(read.text, letter)) {
			diag_error(diag, nowhere,
				   "--%s: '%c' is not an axis of this machine, or is given twice; the axes are %s",
				   option, *at,
				   axes);
			return false;
		}
		axis_letters_add(&read, letter);
	}
	*letters = read;
	return true;
}

/* The axes that are not in `table`: linear ones, rotary ones, then those that move along the tool. */
static struct axis_letters usual_head(const char *axes, const char *table, size_t *rotary)
{
	struct axis_letters head = {""};

	*rotary = 0;
	for (int turn = 0; turn < 3; turn++)
		for (const char *at = axes; *at; at++) {
			int slot = slot_of_letter(*at);

			if (axis_letters_have(table, *at) || turn != (slot < SLOT_A ? 0 : slot_is_rotary(slot) ? 1 : 2))
				continue;
			axis_letters_add(&head, *at);
			*rotary += turn == 1;
		}
	return head;
}

static bool head_fault(struct srcloc place, const char *head, struct diag *diag)
{
	diag_error(diag, place,
		   "this file does not give the order of the rotary axes that carry the tool: name all axes that carry "
		   "it (%s), in order from the base, with --head=LETTERS", head);
	return false;
}

bool axis_letters_head(struct axis_letters *head, const char *asked, const char *axes, const char *table,
		       struct srcloc place, struct diag *diag)
{
	size_t rotary;
	const struct axis_letters usual = usual_head(axes, table, &rotary);
	struct axis_letters read;

	if (!asked && rotary > 1)
		return head_fault(place, usual.text, diag);
	if (!asked) {
		*head = usual;
		return true;
	}
	if (!axis_letters_read(&read, "head", asked, axes, diag))
		return false;
	if (strlen(read.text) != strlen(usual.text) || strspn(read.text, usual.text) != strlen(read.text)) {
		diag_error(diag, nowhere,
			   "--head must name all axes that do not carry the work (%s), and no others",
			   *usual.text ? usual.text : "none");
		return false;
	}
	*head = read;
	return true;
}

vec3 axis_chains_direction(int slot, bool carries_work)
{
	const double sign = carries_work ? -1 : 1;
	const vec3 units[3] = {{sign, 0, 0}, {0, sign, 0}, {0, 0, sign}};

	return units[slot % 3];
}

/* Adds the axes of a chain to the base. Returns the link at the end of the chain. */
static int hang(struct machine_description *d, const struct axis_description *axes, const char *letters)
{
	int link = 0;

	for (const char *at = letters; *at; at++) {
		struct axis_description *axis = &d->axes[d->axis_count++];

		*axis = axes[slot_of_letter(*at)];
		axis->parent = link;
		link = (int)d->axis_count;
	}
	return link;
}

void axis_chains_hang(struct import_machine *machine, const struct axis_description axes[SLOT_COUNT],
		      const char *table, const char *head)
{
	struct machine_description *d = &machine->description;

	d->axes = arena_alloc(&d->arena, SLOT_COUNT * sizeof(*d->axes));
	d->workholdings = arena_alloc(&d->arena, sizeof(*d->workholdings));
	d->spindles = arena_alloc(&d->arena, sizeof(*d->spindles));
	d->workholdings[d->workholding_count++] =
		(struct workholding_description){.link = hang(d, axes, table), .frame = xform_identity()};
	d->spindles[d->spindle_count++] =
		(struct spindle_description){.link = hang(d, axes, head), .direction = {0, 0, -1}};
}
