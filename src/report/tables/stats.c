#include "report/tables/stats.h"

#include "report/format/format_units.h"
#include "report/verdict.h"
#include "scene/scene.h"

void stats_sum(struct run_stats *sums, const struct check_stats *stats, enum check_result result,
	       bool accepted)
{
	struct check_stats *to = &sums->check;

	sums->programs++;
	sums->pairs_required =
	    stats->pairs_required > sums->pairs_required ? stats->pairs_required : sums->pairs_required;
	sums->clear += result == CHECK_CLEAR;
	sums->accepted += accepted;
	sums->incomplete += result == CHECK_INCOMPLETE;
	to->motion.lines += stats->motion.lines;
	to->motion.blocks += stats->motion.blocks;
	to->motion.moves += stats->motion.moves;
	to->motion.spans += stats->motion.spans;
	to->motion.seconds += stats->motion.seconds;
	to->findings += stats->findings;
	to->budgets += stats->budgets;
	to->planes += stats->planes;
	to->measured += stats->measured;
	to->queries += stats->queries;
	to->certificates += stats->certificates;
	to->bisections += stats->bisections;
	to->samples += stats->samples;
	to->seconds_interpret += stats->seconds_interpret;
	to->seconds_check += stats->seconds_check;
}

static void add_program(struct strbuf *out, const struct run_stats *sums)
{
	const struct motion_summary *motion = &sums->check.motion;

	strbuf_addf(out, "  programs      %zu, %zu without a finding", sums->programs, sums->clear);
	if (sums->accepted)
		strbuf_addf(out, ", %zu with accepted ones only", sums->accepted);
	if (sums->incomplete)
		strbuf_addf(out, ", %zu incomplete", sums->incomplete);
	strbuf_addf(out, "\n  blocks        %ld in ", motion->blocks);
	format_units_add_count(out, (size_t)motion->lines, "line");
	strbuf_addf(out, "\n  moves         %ld in ", motion->moves);
	format_units_add_count(out, (size_t)motion->spans, "span");
	strbuf_addf(out, ", ");
	format_units_add_duration(out, motion->seconds);
	strbuf_addf(out, " of machining\n");
}

static void add_pairs(struct strbuf *out, struct scene *scene)
{
	size_t required = scene_count_pairs(scene, PAIR_CHECKED), excused = scene_count_pairs(scene, PAIR_ADJACENT);
	size_t read, built;

	scene_count_meshes(scene, &read, &built);
	strbuf_addf(out, "  pairs         %zu required, %zu excused as adjacent, %zu skipped", required, excused,
		    scene->pair_count - required - excused);
	strbuf_addf(out, " (%zu rigid, %zu out of reach, %zu waived, %zu cutting)\n",
		    scene_count_pairs(scene, PAIR_RIGID), scene_count_pairs(scene, PAIR_OUT_OF_REACH),
		    scene_count_pairs(scene, PAIR_WAIVED), scene_count_pairs(scene, PAIR_CUTTING));
	strbuf_addf(out, "  meshes        %zu read, %zu trees built, %zu not needed\n", read,
		    built, scene->body_count - built);
}

static void add_work(struct strbuf *out, const struct check_stats *stats, enum check_method method)
{
	strbuf_addf(out, "  budgets       %ld steps of pairs passed on a proven distance\n", stats->budgets);
	strbuf_addf(out, "  planes        %ld steps of pairs passed by planes that travel with a link\n",
		    stats->planes);
	if (stats->measured)
		strbuf_addf(out, "  measured      %ld steps of pairs passed by what the clearance report proved\n",
			    stats->measured);
	strbuf_addf(out, "  queries       %ld\n", stats->queries);
	strbuf_addf(out, "  certificates  %ld\n", stats->certificates);
	strbuf_addf(out, "  bisections    %ld\n", stats->bisections);
	if (method != CHECK_CERTIFIED)
		strbuf_addf(out, "  samples       %ld\n", stats->samples);
}

/* Shares of the wall time, and seconds: below these, waiting for files and the scheduler is normal. */
#define PROCESSOR_SHARE 0.75
#define WALL_LEAST 0.1

static void add_time(struct strbuf *out, const struct run_stats *sums)
{
	const struct check_stats *stats = &sums->check;
	double busy = stats->seconds_interpret + stats->seconds_check;

	strbuf_addf(out, "%.3f s load, %.3f s interpret, %.3f s check", sums->seconds_load, stats->seconds_interpret,
		    stats->seconds_check);
	if (busy > 0)
		strbuf_addf(out, "; %.0f blocks/s", (double)stats->motion.blocks / busy);
	if (sums->seconds_wall > WALL_LEAST && sums->seconds_processor < PROCESSOR_SHARE * sums->seconds_wall)
		strbuf_addf(out, "; %.3f s of processor time in %.3f s", sums->seconds_processor, sums->seconds_wall);
	strbuf_addf(out, "\n");
}

void stats_add_line(struct strbuf *out, const struct run_stats *sums, enum check_method method)
{
	format_units_add_count(out, (size_t)sums->check.motion.blocks, "block");
	if (method != CHECK_NOTHING) {
		strbuf_addf(out, ", ");
		format_units_add_count(out, sums->pairs_required, "pair");
	}
	strbuf_addf(out, "; time ");
	add_time(out, sums);
}

void stats_add(struct strbuf *out, const struct run_stats *sums, struct scene *scene, enum check_method method)
{
	const struct check_stats *stats = &sums->check;

	strbuf_addf(out, "statistics\n");
	add_program(out, sums);
	if (method != CHECK_NOTHING) {
		add_pairs(out, scene);
		add_work(out, stats, method);
	}
	strbuf_addf(out, "  time          ");
	add_time(out, sums);
}
