#include "report/verdict.h"

#include <string.h>

#include "control/dialects.h"
#include "report/doubt_text.h"
#include "report/format/format_units.h"
#include "scene/scene.h"

static long accepted(const struct verdict *v)
{
	return v->waived + v->left_out;
}

/* "1 finding waived, 2 findings of kinds that --fail-on leaves out" */
static void add_accepted(struct strbuf *out, const struct verdict *v)
{
	const long counts[] = {v->waived, v->left_out};
	static const char *const words[] = {"waived", "of kinds that --fail-on leaves out"};
	const char *comma = "";

	for (int i = 0; i < 2; i++) {
		if (!counts[i])
			continue;
		strbuf_addf(out, "%s", comma);
		format_units_add_count(out, (size_t)counts[i], "finding");
		strbuf_addf(out, " %s", words[i]);
		comma = ", ";
	}
}

bool verdict_is_accepted(const struct verdict *v)
{
	return v->result == CHECK_FOUND && accepted(v) == v->stats->findings;
}

static void add_findings(struct strbuf *out, const struct verdict *v)
{
	size_t findings = (size_t)(v->stats->findings - accepted(v));

	if (!findings) {
		strbuf_addf(out, "nothing that fails: ");
		add_accepted(out, v);
		return;
	}
	format_units_add_count(out, findings, "finding");
	strbuf_addf(out, findings == 1 ? " in line %ld" : ", the first in line %ld", v->first_line);
	if (v->first_file && strcmp(v->first_file, v->file) != 0) {
		strbuf_addf(out, " of ");
		strbuf_add_visible(out, v->first_file);
	}
	if (accepted(v)) {
		strbuf_addf(out, ", besides ");
		add_accepted(out, v);
	}
	if (!v->options->all)
		strbuf_addf(out, "; stopped there (--all goes on)");
}

/* Was only a part of the program's blocks checked? */
static bool is_shard(const struct verdict *v)
{
	return v->options->shards > 1;
}

static void add_clear(struct strbuf *out, const struct verdict *v)
{
	const struct check_stats *stats = v->stats;
	size_t blocks = (size_t)stats->blocks_checked;

	switch (v->options->method) {
	case CHECK_CERTIFIED:
		strbuf_addf(out, is_shard(v) ? "nothing found in this shard: " : "clear: ");
		format_units_add_count(out, blocks, "block");
		strbuf_addf(out, " proved, ");
		format_units_add_count(out, stats->pairs_required, "pair");
		strbuf_addf(out, " of bodies kept apart at every instant");
		break;
	case CHECK_INTERPOLATED:
	case CHECK_CONVENTIONAL:
		strbuf_addf(out, "no contact at the samples (not a proof): ");
		format_units_add_count(out, blocks, "block");
		strbuf_addf(out, ", ");
		format_units_add_count(out, stats->pairs_required, "pair");
		strbuf_addf(out, " of bodies, a sample every %.10g s", v->options->step);
		break;
	case CHECK_NOTHING:
		strbuf_addf(out, "within the axis limits: ");
		format_units_add_count(out, blocks, "block");
		strbuf_addf(out, " interpreted; no collision was checked (--parse-only)");
		break;
	}
}

void verdict_add_sentence(struct strbuf *out, const struct verdict *v)
{
	switch (v->result) {
	case CHECK_CLEAR:
		add_clear(out, v);
		break;
	case CHECK_FOUND:
		add_findings(out, v);
		break;
	case CHECK_INCOMPLETE:
		strbuf_addf(out, "incomplete: not everything was checked, see the errors");
		if (v->stats->findings) {
			strbuf_addf(out, "; ");
			format_units_add_count(out, (size_t)v->stats->findings, "finding");
			strbuf_addf(out, " before them");
		}
		break;
	}
}

const char *verdict_word(const struct verdict *v)
{
	if (!v || v->result == CHECK_INCOMPLETE)
		return "incomplete";
	if (v->result == CHECK_FOUND)
		return verdict_is_accepted(v) ? "accepted" : "found";
	return v->options->method == CHECK_CERTIFIED && !is_shard(v) ? "clear" : "passed";
}

/* If nothing was found, the sentence itself says this. */
static bool caution_sampled(struct strbuf *out, const struct verdict *v)
{
	enum check_method method = v->options->method;

	if ((method != CHECK_INTERPOLATED && method != CHECK_CONVENTIONAL) || v->result == CHECK_CLEAR)
		return false;
	strbuf_addf(out, "a sample every %.10g s (not a proof): contact between samples may have come earlier",
		    v->options->step);
	return true;
}

static bool caution_nothing(struct strbuf *out, const struct verdict *v)
{
	if (v->stats->pairs_required)
		return false;
	strbuf_addf(out, "no pair of bodies had to be checked (--list-pairs says why)");
	return true;
}

static bool caution_setup(struct strbuf *out, const struct verdict *v)
{
	if (v->scene->setup)
		return false;
	strbuf_addf(out, "no setup was given: only the machine's own bodies were checked, no tool, fixture or part");
	return true;
}

static bool caution_excused(struct strbuf *out, const struct verdict *v)
{
	if (!v->stats->pairs_excused)
		return false;
	format_units_add_count(out, v->stats->pairs_excused, "pair");
	strbuf_addf(out, " of neighbours excused, not proved (adjacent in --list-pairs)");
	return true;
}

static bool caution_waived(struct strbuf *out, const struct verdict *v)
{
	size_t waived = scene_count_pairs(v->scene, PAIR_WAIVED);

	if (!waived)
		return false;
	format_units_add_count(out, waived, "pair");
	strbuf_addf(out, " waived by the machine file, not proved (waived in --list-pairs)");
	return true;
}

/* A cutter without a core may be in the part at rapid, or deeper than its gouge, without being detected. */
static bool caution_mesh_cutter(struct strbuf *out, const struct verdict *v)
{
	const struct scene_body *bodies = v->scene->bodies;
	const struct scene_pair *first = NULL;
	bool gouge = false;
	size_t count = 0;

	for (size_t i = 0; i < v->scene->pair_count; i++) {
		const struct scene_pair *pair = &v->scene->pairs[i];

		if (pair->status != PAIR_CUTTING || pair->steps)
			continue;
		first = first ? first : pair;
		gouge |= bodies[pair->a].body->role == ROLE_PART && bodies[pair->a].body->gouge >= 0;
		count++;
	}
	if (!count)
		return false;
	format_units_add_count(out, count, "pair");
	strbuf_addf(out, " of cutter and part not checked at rapid%s, the first ", gouge ? ", nor for gouges" : "");
	format_units_add_plain(out, bodies[first->a].body->name);
	strbuf_addf(out, " and ");
	format_units_add_plain(out, bodies[first->b].body->name);
	strbuf_addf(out, ": the cutter is a mesh; describe it by sections");
	return true;
}

/* If the inside of a body is undefined, another body may get there undetected. */
static bool caution_open(struct strbuf *out, const struct scene *scene)
{
	const bool several = scene->open_bodies > 1;

	if (!scene->open_bodies)
		return false;
	format_units_add_plain(out, scene->bodies[scene->first_open].body->name);
	if (several)
		strbuf_addf(out, " and %zu more have open meshes", scene->open_bodies - 1);
	else
		strbuf_addf(out, " has an open mesh");
	strbuf_addf(out,
		    ": contact with %s is found, but not a body that is inside or enters through a gap; close the %s "
		    "(--check-machine names the gaps), or give the %s checked=\"reason\"",
		    several ? "their surfaces" : "its surface", several ? "meshes" : "mesh",
		    several ? "bodies" : "body");
	return true;
}

static bool caution_unknown(struct strbuf *out, const struct verdict *v)
{
	const struct scene_pair *pair;

	if (!v->stats->pairs_unknown)
		return caution_open(out, v->scene);
	pair = &v->scene->pairs[v->stats->first_unknown];
	format_units_add_count(out, v->stats->pairs_unknown, "pair");
	strbuf_addf(out, " of bodies checked as surfaces only, the first ");
	format_units_add_plain(out, v->scene->bodies[pair->a].body->name);
	strbuf_addf(out, " and ");
	format_units_add_plain(out, v->scene->bodies[pair->b].body->name);
	strbuf_addf(out,
		    ": whether one is inside the other is unknown, because a mesh is not closed; close the mesh "
		    "(--check-machine names the gaps)");
	return true;
}

static bool caution_blend(struct strbuf *out, const struct verdict *v)
{
	const char *own = dialect_rows[v->scene->machine->controller.dialect].unknown_path;

	if (!v->stats->motion.blend_unbounded)
		return false;
	if (own) {
		strbuf_addf(out, "%s", own);
		return true;
	}
	strbuf_addf(out, "G64 (of the program or from power-on; or G5, G5.1, G8, G187) without a tolerance: the "
			 "control may leave the programmed path, "
			 "and only that path was checked; give P or <controller path_tolerance=\"\">");
	return true;
}

/* LinuxCNC and Heidenhain controls have only straight rapids; on others a parameter or the builder decides. */
static bool caution_rapids(struct strbuf *out, const struct verdict *v)
{
	const struct controller *controller = &v->scene->machine->controller;

	if (!v->stats->motion.straight_rapids || controller->rapid_given == ANSWER_YES ||
	    dialect_rows[controller->dialect].straight_rapids)
		return false;
	strbuf_addf(out, "rapids of several axes (G0) were checked as straight lines, but whether the control moves "
			 "them so is not known: give <controller rapid=\"linear\">, \"dogleg\" (each axis at its own "
			 "rate) or \"any\"");
	return true;
}

/* The program was read to its end, and a tool feeds and turns but never comes near the part. */
static bool caution_far_cutter(struct strbuf *out, const struct verdict *v)
{
	const struct far_cutters *far = &v->stats->far_cutters;

	if (!far->far)
		return false;
	if (far->far == far->fed && far->fed > 1)
		strbuf_addf(out, "no cutter comes near the part at feed: tool %d comes nearest,", far->tool);
	else
		strbuf_addf(out, "tool %d never comes near the part at feed: it stays", far->tool);
	strbuf_addf(out, " %.4g mm away from ", far->distance);
	format_units_add_plain(out, v->scene->bodies[far->body].body->name);
	strbuf_addf(out, " (line %ld%s)", far->line, far->in_subprogram ? " of a subprogram" : "");
	if (far->far < far->fed && far->far > 1) {
		strbuf_addf(out, ", and so do ");
		format_units_add_count(out, (size_t)far->far - 1, "other tool");
	}
	strbuf_addf(out, "; check the work offset, the tool's length and H, and the location of the part, or give "
			 "the tool checked=\"reason\"");
	return true;
}

/* Only the first finding of a block and pair is reported; accepting it would hide later ones of that pair. */
static bool caution_accepted(struct strbuf *out, const struct verdict *v)
{
	if (!accepted(v))
		return false;
	strbuf_addf(out, "after an accepted finding, the same bodies or axis are not checked in the rest of that "
			 "block");
	return true;
}

static bool caution_shard(struct strbuf *out, const struct verdict *v)
{
	if (!is_shard(v))
		return false;
	strbuf_addf(out, "shard %d/%d: %ld of %ld blocks were checked here; the program is clear if all shards are",
		    v->options->shard, v->options->shards, v->stats->blocks_checked, v->stats->motion.blocks);
	return true;
}

/* Warnings go to standard error; the report must mention them, too. */
static bool caution_warnings(struct strbuf *out, const struct verdict *v)
{
	if (!v->warnings)
		return false;
	strbuf_addf(out, "%ld %s %s", v->warnings,
		    v->warnings == 1 ? "warning:" : "warnings, the first:", v->first_warning);
	return true;
}

/* Doubts that follow from the files alone; --check-machine gives all details. */
static bool caution_doubt(struct strbuf *out, const struct verdict *v, size_t i)
{
	const struct doubts *doubts = &v->scene->doubts;

	if (i >= doubts->count)
		return false;
	if (i < VERDICT_DOUBTS) {
		doubt_text_add(out, v->scene, &doubts->items[i]);
	} else {
		format_units_add_count(out, doubts->count - i, "more doubt");
		strbuf_addf(out, " about machine and setup (--check-machine names them)");
	}
	return true;
}

bool verdict_add_caution(struct strbuf *out, const struct verdict *v, int i)
{
	static bool (*const cautions[])(struct strbuf *, const struct verdict *) = {
		[CAUTION_SAMPLED] = caution_sampled,
		[CAUTION_NO_PAIRS] = caution_nothing,
		[CAUTION_NO_SETUP] = caution_setup,
		[CAUTION_EXCUSED] = caution_excused,
		[CAUTION_WAIVED] = caution_waived,
		[CAUTION_SURFACES] = caution_unknown,
		[CAUTION_MESH_CUTTER] = caution_mesh_cutter,
		[CAUTION_NO_PATH_TOLERANCE] = caution_blend,
		[CAUTION_STRAIGHT_RAPIDS] = caution_rapids,
		[CAUTION_FAR_CUTTER] = caution_far_cutter,
		[CAUTION_ACCEPTED] = caution_accepted,
		[CAUTION_SHARD] = caution_shard,
		[CAUTION_WARNINGS] = caution_warnings,
	};

	if (i >= CAUTION_DOUBT)
		return caution_doubt(out, v, (size_t)(i - CAUTION_DOUBT));
	/* --parse-only checks no bodies, so that cautions about bodies do not apply. */
	if (v->options->method == CHECK_NOTHING && cautions[i] != caution_blend && cautions[i] != caution_rapids &&
	    cautions[i] != caution_accepted && cautions[i] != caution_shard && cautions[i] != caution_warnings)
		return false;
	return cautions[i](out, v);
}

bool verdict_caution_is_doubt(int i)
{
	return i != CAUTION_EXCUSED && i != CAUTION_WAIVED && i != CAUTION_ACCEPTED && i != CAUTION_SHARD;
}
