#include "check/certified/proof.h"

#include "check/certified/merged_steps.h"
#include "check/step.h"
#include "geom/moved_tri.h"
#include "solids.h"
#include "step_program.h"
#include "suite.h"

/*
 * Two boxes face each other, and X moves one of them straight away from the other, so X gives their distance. A quick
 * method may pass a step only if they stay farther apart than c + W + e, the greatest distance at which the sweep can
 * report anything (check/certified/proof.h). Here the distances are just below and just above that.
 */
static const double E = 0.1;	/* mm: the tolerance */

struct faces {
	struct duo duo;
	struct pair_proof proof;
	struct path paths[2];
	struct batch_step steps[2];
};

/* mm: clearance, path tolerance of X, distance at X = 0; both steps move X by `way`. */
static void faces_init(struct faces *f, double clearance, double off, double gap, double way)
{
	const struct chain chain = {1, {{.slot = 0, .direction = {1, 0, 0}}}};
	xform place_a = xform_identity(), place_b = xform_identity();
	struct mesh a = {0}, b = {0};

	solid_box(&a, (vec3){10, 10, 10});
	solid_box(&b, (vec3){10, 10, 10});
	place_b.translation.x = 20 + gap;
	duo_init(&f->duo, &chain, &a, &b, &place_a, &place_b);
	pair_proof_init(&f->proof, &f->duo.pair, clearance, E);
	pair_proof_aim(&f->proof, clearance);
	for (int i = 0; i < 2; i++) {
		const axis_values from = {{i * way}}, to = {{(i + 1) * way}};

		f->paths[i] = path_between(&from, &to, PATH_STRAIGHT);
		f->steps[i] = (struct batch_step){.motion = step_on(&f->paths[i])};
		f->steps[i].motion.tolerance = (axis_values){{off}};
	}
}

/* Adds the distance at X to the proof, as a true distance query would. */
static void tell_distance(struct faces *f, double x, double distance)
{
	const axis_values q = {{x}};
	struct chain_state state;

	chain_state_init(&state, &f->duo.chain, &q, &f->duo.pair.ball_a, &f->duo.pair.ball_b);
	pair_proof_add_distance(&f->proof, &q, &state, distance);
}

typedef bool quick_way(struct faces *f, struct sweep *sweep, double gap);

static bool by_budget(struct faces *f, struct sweep *sweep, double gap)
{
	const struct motion_step *step = &f->steps[0].motion;
	struct position_errors errors = step_errors(&f->duo.chain, step);

	(void)sweep;
	tell_distance(f, 0, gap);
	return pair_proof_step_by_budget(&f->proof, step, &errors);
}

static bool by_box(struct faces *f, struct sweep *sweep, double gap)
{
	const axis_values *q0 = &f->steps[0].motion.span.q0, *q1 = &f->steps[0].motion.span.q1;
	struct position_errors errors = step_errors(&f->duo.chain, &f->steps[0].motion);

	(void)sweep;
	tell_distance(f, 0, gap);
	return pair_proof_box(&f->proof, q0->v[0] < q1->v[0] ? q0 : q1, q0->v[0] < q1->v[0] ? q1 : q0, &errors, q1,
			      false);
}

/* The budget that is large enough is not the last one. */
static bool by_earlier_budget(struct faces *f, struct sweep *sweep, double gap)
{
	(void)sweep;
	tell_distance(f, 0, gap);
	tell_distance(f, 1000, 1000 + gap);
	return pair_proof_recall(&f->proof, &f->steps[0].motion);
}

static bool by_chord(struct faces *f, struct sweep *sweep, double gap)
{
	struct chord chord = merged_steps_chord(f->steps, 2);

	(void)gap;
	return pair_proof_chord(&f->proof, sweep, &chord);
}

static bool by_planes(struct faces *f, struct sweep *sweep, double gap)
{
	const struct motion_step *step = &f->steps[0].motion;
	struct position_errors errors = step_errors(&f->duo.chain, step);

	(void)sweep;
	(void)gap;
	return pair_proof_step_by_planes(&f->proof, step, &errors, true);
}

static bool by_halves(struct faces *f, struct sweep *sweep, double gap)
{
	const struct motion_step *step = &f->steps[0].motion;
	struct position_errors errors = step_errors(&f->duo.chain, step);

	(void)sweep;
	(void)gap;
	return pair_proof_halves_by_planes(&f->proof, step, &errors, 2);
}

static bool box_by_planes(struct faces *f, struct sweep *sweep, double gap)
{
	const axis_values *q0 = &f->steps[0].motion.span.q0, *q1 = &f->steps[0].motion.span.q1;
	const axis_values *low = q0->v[0] < q1->v[0] ? q0 : q1, *high = low == q0 ? q1 : q0;
	struct position_errors errors = step_errors(&f->duo.chain, &f->steps[0].motion);

	(void)sweep;
	(void)gap;
	return pair_proof_box_by_planes(&f->proof, low, high, &errors, true);
}

/* The planes were measured for the second step. */
static bool by_kept_planes(struct faces *f, struct sweep *sweep, double gap)
{
	struct position_errors errors = step_errors(&f->duo.chain, &f->steps[0].motion);

	(void)sweep;
	(void)gap;
	pair_proof_step_by_planes(&f->proof, &f->steps[1].motion, &errors, true);
	return pair_proof_step_by_planes(&f->proof, &f->steps[0].motion, &errors, false);
}

static bool passes(quick_way *way, double clearance, double off, double gap, double move)
{
	struct sweep sweep = {0};
	struct faces f;
	bool passed;

	faces_init(&f, clearance, off, gap, move);
	passed = way(&f, &sweep, gap);
	sweep_release(&sweep);
	pair_proof_release(&f.proof);
	duo_release(&f.duo);
	return passed;
}

static void look_at(quick_way *way, const char *name)
{
	const double clearances[] = {0, 2}, offs[] = {0, 0.03};

	for (int i = 0; i < 4; i++) {
		double c = clearances[i / 2], w = offs[i % 2], most = c + w + E;

		/* The boxes move apart, so that they are nearest where the distance is known. */
		ck_assert_msg(!passes(way, c, w, most - 0.9 * E, 1e-4), "%s: %g mm, at c + W + e/10", name, c);
		ck_assert_msg(!passes(way, c, w, most - 0.01 * E, 1e-4), "%s: %g mm, just within e", name, c);
		ck_assert_msg(passes(way, c, w, most + 0.2 * E, 1e-4), "%s: %g mm, beyond e", name, c);
		/* The boxes come nearer, in both steps, to just below the limit. */
		ck_assert_msg(!passes(way, c, w, most + 0.2 * E, -0.3 * E), "%s: %g mm, comes within e", name, c);
		ck_assert_msg(passes(way, c, w, most + 0.9 * E, -0.3 * E), "%s: %g mm, stays beyond e", name, c);
	}
}

START_TEST(no_quick_way_passes_what_the_sweep_may_report)
{
	look_at(by_budget, "budget");
	look_at(by_box, "box of a budget");
	look_at(by_earlier_budget, "earlier budget");
	look_at(by_chord, "chord");
	look_at(by_planes, "planes");
	look_at(by_halves, "halves by planes");
	look_at(box_by_planes, "box by planes");
	look_at(by_kept_planes, "kept planes");
}
END_TEST

/* The sweep itself must report a distance up to c + W, and must not report one beyond c + W + e. */
START_TEST(the_sweep_reports_within_the_tolerance)
{
	const double gaps[] = {-0.02, 1.01 * E};

	for (int i = 0; i < 2; i++) {
		struct sweep sweep = {0};
		struct contact contact;
		struct faces f;

		faces_init(&f, 2, 0.03, 2 + 0.03 + gaps[i], 1e-4);
		ck_assert_int_eq(pair_proof_step(&f.proof, &sweep, &f.steps[0].motion, &contact),
				 i ? QUERY_CLEAR : QUERY_CONTACT);
		sweep_release(&sweep);
		pair_proof_release(&f.proof);
		duo_release(&f.duo);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("the tolerance in budgets and chords");

	tcase_add_test(tcase, no_quick_way_passes_what_the_sweep_may_report);
	tcase_add_test(tcase, the_sweep_reports_within_the_tolerance);
	return run_suite("quick_ways", tcase);
}
