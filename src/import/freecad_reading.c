#include "import/freecad_reading.h"

#include <math.h>
#include <stdarg.h>

#include "base/ascii.h"
#include "base/strbuf.h"

struct srcloc freecad_place(const struct freecad_reading *r)
{
	return (struct srcloc){.file = r->path};
}

bool freecad_fault(const struct freecad_reading *r, const char *format, ...)
{
	struct strbuf text = {0};
	va_list args;

	va_start(args, format);
	strbuf_addv(&text, format, args);
	va_end(args);
	diag_error(r->diag, freecad_place(r), "%s", strbuf_text(&text));
	strbuf_release(&text);
	return false;
}

void freecad_warn(struct freecad_reading *r, const char *format, ...)
{
	struct strbuf text = {0};
	va_list args;

	va_start(args, format);
	strbuf_addv(&text, format, args);
	va_end(args);
	diag_warning(r->diag, freecad_place(r), "%s", strbuf_text(&text));
	text.text[0] = ascii_upper(text.text[0]);
	import_machine_todo(r->machine, "%s.", strbuf_text(&text));
	strbuf_release(&text);
}

bool freecad_read_vector(const json_t *array, vec3 *vector)
{
	double parts[3];

	if (json_array_size(array) != 3)
		return false;
	for (size_t i = 0; i < 3; i++) {
		const json_t *part = json_array_get(array, i);

		if (!json_is_number(part) || !isfinite(json_number_value(part)))
			return false;
		parts[i] = json_number_value(part);
	}
	*vector = (vec3){parts[0], parts[1], parts[2]};
	return true;
}

bool freecad_is_none(vec3 v)
{
	return vec3_norm(v) <= FREECAD_SHORTEST;
}
