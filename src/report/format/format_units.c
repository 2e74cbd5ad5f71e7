#include "report/format/format_units.h"

#include <math.h>
#include <string.h>

#include "base/units.h"

double format_units_value(int slot, double value)
{
	return (slot_is_rotary(slot) ? degrees(value) : value) + 0.0;
}

const char *format_units_unit(int slot)
{
	return slot_is_rotary(slot) ? "deg" : "mm";
}

void format_units_add(struct strbuf *out, double value)
{
	/* A number that rounds to zero loses its sign. */
	strbuf_addf(out, "%.4f", fabs(value) < 0.00005 ? 0.0 : value);
}

void format_units_add_duration(struct strbuf *out, double seconds)
{
	/* Rounded first; otherwise 59.9996 s would be printed as 60.000 s. */
	double rounded = round(seconds * 1000) / 1000;
	double hours = floor(rounded / 3600);
	double minutes = floor((rounded - 3600 * hours) / 60);
	double rest = fmax(0, rounded - 3600 * hours - 60 * minutes);

	if (rounded < 60)
		strbuf_addf(out, "%.3f s", rounded);
	else if (rounded < 3600)
		strbuf_addf(out, "%.0f min %06.3f s", minutes, rest);
	else
		strbuf_addf(out, "%.0f h %02.0f min %06.3f s", hours, minutes, rest);
}

void format_units_add_axes(struct strbuf *out, const struct machine *machine, const axis_values *axes)
{
	const char *separator = "";

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!machine_axis(machine, slot))
			continue;
		strbuf_addf(out, "%s%c ", separator, AXIS_LETTERS[slot]);
		format_units_add(out, format_units_value(slot, axes->v[slot]));
		strbuf_addf(out, " %s", format_units_unit(slot));
		separator = ", ";
	}
}

static bool is_blank(char c)
{
	unsigned char u = (unsigned char)c;

	return u <= 0x20 || u == 0x7f;
}

void format_units_add_plain(struct strbuf *out, const char *text)
{
	size_t length = strlen(text);

	while (length && is_blank(text[length - 1]))
		length--;
	while (length && is_blank(*text)) {
		text++;
		length--;
	}
	for (size_t i = 0; i < length;) {
		const size_t controls = strbuf_control_bytes(&text[i]);

		strbuf_add(out, controls ? " " : &text[i], 1);
		i += controls ? controls : 1;
	}
}

const char *format_units_noun(size_t count, const char *one, const char *several)
{
	return count == 1 ? one : several;
}

void format_units_add_count(struct strbuf *out, size_t count, const char *noun)
{
	strbuf_addf(out, "%zu %s%s", count, noun, count == 1 ? "" : "s");
}
