#include "report/tables/pairs.h"

#include "report/format/format_units.h"

void pairs_add(struct strbuf *out, const struct scene *scene)
{
	strbuf_addf(out, "a\tb\tstatus\tclearance\treason\n");
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];

		format_units_add_plain(out, scene->bodies[pair->a].body->name);
		strbuf_addf(out, "\t");
		format_units_add_plain(out, scene->bodies[pair->b].body->name);
		strbuf_addf(out, "\t%s\t%.12g\t", pair_status_name(pair->status), pair->clearance);
		format_units_add_plain(out, pair->reason ? pair->reason : "");
		strbuf_addf(out, "\n");
	}
}
