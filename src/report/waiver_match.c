#include "report/waiver_match.h"

#include <math.h>
#include <string.h>

#include "base/utf8.h"
#include "report/format/format_units.h"

bool waiver_match_is_expired(const struct waiver_match *waiving, const struct waiver *waiver)
{
	return strcmp(waiver->expires, waiving->today) < 0;
}

/* Compares texts as printed in the reports, because people copy them from there. */
static bool is_same_text(const char *a, const char *b)
{
	struct strbuf clean[2] = {{0}}, shown[2] = {{0}};
	const char *texts[2] = {a, b};
	bool same;

	for (int i = 0; i < 2; i++) {
		utf8_add_clean(&clean[i], texts[i] ? texts[i] : "");
		format_units_add_plain(&shown[i], strbuf_text(&clean[i]));
	}
	same = !strcmp(strbuf_text(&shown[0]), strbuf_text(&shown[1]));
	for (int i = 0; i < 2; i++) {
		strbuf_release(&clean[i]);
		strbuf_release(&shown[i]);
	}
	return same;
}

static bool has_subject(const struct waiver *waiver, const struct finding *f)
{
	const struct pair_finding *pair = &f->of.pair;

	if (f->kind == FINDING_LIMIT)
		return waiver->slot == f->of.limit.slot;
	return (is_same_text(waiver->a, pair->a) && is_same_text(waiver->b, pair->b)) ||
	       (is_same_text(waiver->a, pair->b) && is_same_text(waiver->b, pair->a));
}

static bool is_there(const struct waiver *waiver, const struct machine *machine, const axis_values *axes)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double off =
		    fabs(format_units_value(slot, axes->v[slot]) - format_units_value(slot, waiver->axes.v[slot]));

		if (machine_axis(machine, slot) && !(off <= waiver->within))
			return false;
	}
	return true;
}

static bool names(const struct waiver *waiver, const struct machine *machine, const char *program,
		  const struct finding *f)
{
	return !strcmp(waiver->kind, finding_kind_name(f->kind)) && has_subject(waiver, f) &&
	       is_there(waiver, machine, &f->axes) && is_same_text(waiver->program, program) &&
	       is_same_text(waiver->block, f->text);
}

const struct waiver *waiver_match_find(const struct waiver_match *waiving, int *matched, const struct machine *machine,
				       const char *program, const struct finding *finding)
{
	const struct waiver *found = NULL;

	for (size_t i = 0; waiving->file && i < waiving->file->count; i++) {
		const struct waiver *waiver = &waiving->file->items[i];

		if (matched[i] >= waiver->times || !names(waiver, machine, program, finding))
			continue;
		if (!found || waiver_match_is_expired(waiving, found))
			found = waiver;
	}
	if (found)
		matched[found - waiving->file->items]++;
	return found;
}

void waiver_match_add_reason(struct strbuf *out, const struct waiver *waiver)
{
	strbuf_addf(out, "until %s: ", waiver->expires);
	format_units_add_plain(out, waiver->reason);
}
