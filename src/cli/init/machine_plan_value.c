#include "cli/init/machine_plan_value.h"

#include <math.h>
#include <string.h>

#include "base/utf8.h"
#include "cli/option_value.h"

#define COORDINATE_MAX 1e5
#define TEXT_MAX 200	/* the reader of machine files takes no more */

bool machine_plan_read_number(double *out, const char *text, size_t length)
{
	char digits[64];
	double value;

	if (length >= sizeof(digits))
		return false;
	memcpy(digits, text, length);
	digits[length] = '\0';
	if (!option_value_number(&value, digits) || fabs(value) > COORDINATE_MAX)
		return false;
	*out = value;
	return true;
}

bool machine_plan_read_vector(vec3 *out, const char *text)
{
	double v[3];

	for (int i = 0; i < 3; i++) {
		size_t length;

		text += strspn(text, " ");
		length = strcspn(text, ", ");
		if (!machine_plan_read_number(&v[i], text, length))
			return false;
		text += length;
		text += strspn(text, " ");
		if (i < 2 && *text == ',')
			text++;
	}
	if (*text)
		return false;
	*out = (vec3){v[0], v[1], v[2]};
	return true;
}

bool machine_plan_read_limits(struct machine_plan_axis *out, const char *text, size_t length)
{
	struct machine_plan_axis axis = *out;
	const char *colon = memchr(text, ':', length);
	size_t before = colon ? (size_t)(colon - text) : 0, after = colon ? length - before - 1 : 0;

	axis.has_limits = true;
	axis.has_min = before > 0;
	axis.has_max = after > 0;
	if (!colon) {
		if (length != 4 || strncmp(text, "none", 4) != 0)
			return false;
	} else if (!(before + after) || (before && !machine_plan_read_number(&axis.min, text, before)) ||
		   (after && !machine_plan_read_number(&axis.max, colon + 1, after)) ||
		   (before && after && axis.min >= axis.max)) {
		return false;
	}
	*out = axis;
	return true;
}

bool machine_plan_read_chain(struct machine_plan_chain *out, const char *text, bool rotary)
{
	struct machine_plan_chain chain = {.count = 0};
	bool seen[SLOT_COUNT] = {false};

	if (!strcmp(text, "none"))
		text = "";
	else if (!*text)
		return false;
	for (; *text; text++) {
		int slot = slot_of_letter(*text);

		if (*text == ',' || *text == ' ')
			continue;
		if (slot < 0 || seen[slot] || slot_is_rotary(slot) != rotary || slot > SLOT_C)
			return false;
		seen[slot] = true;
		chain.slots[chain.count++] = slot;
	}
	*out = chain;
	return true;
}

int machine_plan_read_letter(const char *text, const char **rest)
{
	int slot = slot_of_letter(text[0]);

	if (slot >= 0 && text[1] != '=')
		return -1;
	*rest = slot >= 0 ? text + 2 : text;
	return slot;
}

bool machine_plan_is_text(const char *text)
{
	const char *at = text;

	while (*at && (unsigned char)*at >= ' ' && *at != 0x7f && utf8_length(at))
		at += utf8_length(at);
	return !*at && at > text && at - text <= TEXT_MAX;
}
