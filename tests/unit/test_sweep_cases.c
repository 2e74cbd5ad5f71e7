
#include "first_contact.h"
#include "scene/coherence.h"
#include "scene/sweep.h"
#include "suite.h"

static const struct joint along_x = {SLOT_X, false, {1, 0, 0}, {0, 0, 0}};
static const struct joint along_z = {SLOT_Z, false, {0, 0, 1}, {0, 0, 0}};
static const struct joint about_z = {SLOT_C, true, {0, 0, 1}, {0, 0, 0}};
static const xform here = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static struct mesh box_at(vec3 half, vec3 centre)
{
	struct mesh mesh = {0};
	xform place = here;

	place.translation = centre;
	solid_box(&mesh, half);
	solid_place(&mesh, &place);
	return mesh;
}

static struct mesh prism_at(int corners, double radius, double half, int rows, vec3 centre)
{
	struct mesh mesh = {0};
	xform place = here;

	place.translation = centre;
	solid_prism(&mesh, corners, radius, half, rows);
	solid_place(&mesh, &place);
	return mesh;
}

static struct chain chain_of(const struct joint *first, const struct joint *second)
{
	struct chain chain = {.count = 1, .joints = {*first}};

	if (second)
		chain.joints[chain.count++] = *second;
	return chain;
}

/* A move of one or two axes from 0 (or `from`) to `to`. */
static struct chord move_of(int slot, double from, double to, int other, double other_to)
{
	struct chord chord = {.q0 = {{0}}, .q1 = {{0}}};

	chord.q0.v[slot] = from;
	chord.q1.v[slot] = to;
	if (other >= 0)
		chord.q1.v[other] = other_to;
	return chord;
}

static enum sweep_answer sweep_once(struct duo *duo, const struct chord *chord, double clearance, double tolerance,
				    struct contact *contact)
{
	struct sweep sweep = {0};
	struct coherence coherence = {0};
	enum sweep_answer answer, again;
	struct contact second;

	answer = sweep_chord(&sweep, &duo->pair, chord, clearance, tolerance, contact);
	/* Again, with storage that was used before, and with the remembered axes and pairs. */
	duo->pair.coherence = &coherence;
	again = sweep_chord(&sweep, &duo->pair, chord, clearance, tolerance, &second);
	require(again == answer, "a coherence changes the answer from %d to %d", (int)answer, (int)again);
	duo->pair.coherence = NULL;
	sweep_release(&sweep);
	return answer;
}

static void expect_contact(struct duo *duo, const struct chord *chord, double clearance, double tolerance, double s,
			   double slack)
{
	struct contact contact = {0};
	enum sweep_answer answer = sweep_once(duo, chord, clearance, tolerance, &contact);

	require(answer == SWEEP_CONTACT, "no contact at %g: %d", s, (int)answer);
	require(fabs(contact.s - s) <= slack, "contact at %.12g, not at %.12g", contact.s, s);
	require(contact.distance <= clearance + tolerance, "%g apart", contact.distance);
}

static void expect_apart(struct duo *duo, const struct chord *chord, double clearance, double tolerance)
{
	struct contact contact = {0};
	enum sweep_answer answer = sweep_once(duo, chord, clearance, tolerance, &contact);

	require(answer == SWEEP_APART, "%d, at %.12g", (int)answer, contact.s);
}

/* A wall of 0.01 mm, crossed by one move of 300 mm; then the same far from the origin of both drawings. */
START_TEST(thin_wall)
{
	for (int far = 0; far < 2; far++) {
		const double offset = far ? 0x1p20 : 0;
		struct chain chain = chain_of(&along_x, NULL);
		struct mesh wall = box_at((vec3){far ? 0.0625 : 0.005, 50, 50}, (vec3){offset, offset, -offset});
		struct mesh cube = box_at((vec3){5, 5, 5}, (vec3){offset - 130, offset + 3, 1 - offset});
		double thickness = far ? 0.0625 : (double)(float)0.005;
		struct chord chord = move_of(SLOT_X, 0, 300, -1, 0);
		struct duo duo;

		duo_init(&duo, &chain, &wall, &cube, &here, &here);
		expect_contact(&duo, &chord, 0, 1e-3, (125 - thickness) / 300, 1.1e-3 / 300);
		expect_contact(&duo, &chord, 2, 1e-3, (123 - thickness) / 300, 1.1e-3 / 300);
		if (!far)
			expect_contact(&duo, &chord, 0, 1e-8, (125 - thickness) / 300, 2e-8 / 300);
		duo_release(&duo);
	}
}
END_TEST

/*
 * A bar on a turning table and a post, apart at both ends of the turn: they meet when the bar's corner reaches the
 * post.
 */
START_TEST(middle_of_a_turn)
{
	struct chain chain = chain_of(&about_z, NULL);
	struct mesh post = box_at((vec3){1, 1, 10}, (vec3){0, 101, 0}),
		    bar = box_at((vec3){100.5, 0.5, 0.5}, (vec3){0, 0, 0});
	struct chord chord = move_of(SLOT_C, 0, PI, -1, 0);
	struct contact contact;
	struct duo duo;

	duo_init(&duo, &chain, &post, &bar, &here, &here);
	for (int k = 0; k < 2; k++) {
		enum sweep_answer answer = sweep_once(&duo, &chord, k ? 3 : 0, 1e-3, &contact);

		require(answer == SWEEP_CONTACT, "not found");
		oracle_judge(&duo, &chord.q0, &chord.q1, k ? 3 : 0, 1e-3, answer, &contact, "turn", k);
	}
	duo_release(&duo);
	/* A little farther out the corner, at sqrt(100.5^2 + 0.5^2) from the axis, just passes. */
	post = box_at((vec3){1, 1, 10}, (vec3){0, 101.5 + 0.003, 0});
	bar = box_at((vec3){100.5, 0.5, 0.5}, (vec3){0, 0, 0});
	duo_init(&duo, &chain, &post, &bar, &here, &here);
	expect_apart(&duo, &chord, 0, 1e-3);
	duo_release(&duo);
}
END_TEST

/* Along a plate at 10 um: clear with a smaller clearance, an immediate contact with a larger one. */
START_TEST(slide)
{
	struct chain chain = chain_of(&along_x, &along_z);
	struct mesh plate = box_at((vec3){500, 50, 5}, (vec3){0, 0, -5});
	struct mesh block = prism_at(24, 20, 10, 3, (vec3){0, 0, 10});
	struct chord chord = move_of(SLOT_X, -400, 400, -1, 0);
	struct duo duo;

	duo_init(&duo, &chain, &plate, &block, &here, &here);
	chord.q0.v[SLOT_Z] = chord.q1.v[SLOT_Z] = 0.01;
	expect_apart(&duo, &chord, 0, 1e-3);
	expect_apart(&duo, &chord, 0.008, 1e-3);
	expect_apart(&duo, &chord, 0.01 - 1e-6, 1e-3);
	expect_contact(&duo, &chord, 0.0101, 1e-3, 0, 1e-6);
	/* The body comes down on the way: in the middle the gap is 0.005. */
	chord.q1.v[SLOT_Z] = 0;
	expect_contact(&duo, &chord, 0.005, 1e-5, 0.5, 1e-5 / 0.01);
	chord.q0.v[SLOT_Z] = chord.q1.v[SLOT_Z] = -0.002;
	expect_contact(&duo, &chord, 0, 1e-3, 0, 1e-6);
	duo_release(&duo);
}
END_TEST

START_TEST(starts_and_ends)
{
	struct chain chain = chain_of(&along_x, NULL);
	struct mesh a = box_at((vec3){5, 5, 5}, (vec3){0, 0, 0}), b = box_at((vec3){5, 5, 5}, (vec3){0, 1, 2});
	struct chord departs = move_of(SLOT_X, 9, 30, -1, 0), touching = move_of(SLOT_X, 10, 30, -1, 0),
		     arrives = move_of(SLOT_X, 30, 10, -1, 0), stops_short = move_of(SLOT_X, 30, 10.002, -1, 0),
		     still = move_of(SLOT_X, 10.002, 10.002, -1, 0), inside = move_of(SLOT_X, 8, 8, -1, 0);
	struct duo duo;

	duo_init(&duo, &chain, &a, &b, &here, &here);
	expect_contact(&duo, &departs, 0, 1e-3, 0, 0);
	expect_contact(&duo, &touching, 0, 1e-3, 0, 0);
	expect_contact(&duo, &arrives, 0, 1e-3, 1, 1e-3 / 20);
	expect_contact(&duo, &arrives, 0, 1e-9, 1, 1e-9 / 20);
	expect_apart(&duo, &stops_short, 0, 1e-3);
	expect_contact(&duo, &stops_short, 0.002, 1e-3, 1, 1e-3 / 20);
	expect_apart(&duo, &still, 0, 1e-3);
	expect_apart(&duo, &still, 0.0019, 1e-3);
	expect_contact(&duo, &still, 0.0021, 1e-3, 0, 0);
	expect_contact(&duo, &inside, 0, 1e-3, 0, 0);
	duo_release(&duo);
}
END_TEST

/*
 * A disc with 32 corners turns by 30,000 degrees inside a square frame, 0.2 mm from it: more intervals than are kept at
 * a time. Then the same while it drifts toward the frame, and meets its wall at the very end.
 */
START_TEST(many_turns)
{
	struct chain chain = chain_of(&along_x, &about_z);
	struct mesh frame = {0}, disc = prism_at(32, 50, 5, 1, (vec3){0, 0, 0});
	struct chord turns = move_of(SLOT_C, 0, radians(30000), -1, 0);
	struct sweep sweep = {0};
	struct contact contact;
	enum sweep_answer answer;
	struct duo duo;

	for (int k = 0; k < 4; k++) {
		vec3 half = k & 1 ? (vec3){1, 60, 10} : (vec3){60, 1, 10};
		double d = (k & 2 ? 1 : -1) * 51.2;
		struct mesh wall = box_at(half, k & 1 ? (vec3){d, 0, 0} : (vec3){0, d, 0});

		for (size_t i = 0; i < wall.count; i++)
			solid_add(&frame, mesh_corner(&wall.triangles[i], 0), mesh_corner(&wall.triangles[i], 1),
				  mesh_corner(&wall.triangles[i], 2));
		mesh_release(&wall);
	}
	duo_init(&duo, &chain, &frame, &disc, &here, &here);
	answer = sweep_chord(&sweep, &duo.pair, &turns, 0, 1e-3, &contact);
	require(answer == SWEEP_APART, "%d", (int)answer);
	require(sweep.bisections > 4096, "only %ld bisections: this was to overflow", sweep.bisections);
	turns.q1.v[SLOT_X] = 0.202;
	answer = sweep_chord(&sweep, &duo.pair, &turns, 0, 1e-3, &contact);
	require(answer == SWEEP_CONTACT && contact.s > 0.96 && contact.s < 1, "%d at %.9g", (int)answer, contact.s);
	/*
	 * The wall is straight: at 0.2 / 0.202 of the move the circle of the disc meets it, and its next corner soon
	 * after.
	 */
	require(contact.s > (0.2 - 1e-3) / 0.202 && contact.s < 0.2 / 0.202 + 1e-3, "%.9g", contact.s);
	sweep_release(&sweep);
	duo_release(&duo);
}
END_TEST

/* The same encounter near the origin of machine and drawings and far from it. */
START_TEST(far_from_the_origin)
{
	const vec3 shift = {0x1p20, -0x1p20, 0x1p19};
	struct sweep sweep = {0};

	for (long n = 0; n < random_cases(200); n++) {
		struct random random = random_case(7, n);
		struct chain chains[2];
		struct chord chord = {.q0 = {{0}}};
		struct contact contacts[2];
		enum sweep_answer answers[2];
		struct duo duos[2];
		xform places[2] = {here, here};
		/* Multiples of 1/8 are exact in a float up to 2^20. */
		vec3 half = {1 + random_below(&random, 100) / 8.0, 1 + random_below(&random, 100) / 8.0, 2};
		vec3 at = {random_below(&random, 400) / 8.0 - 25, random_below(&random, 400) / 8.0 - 25, 0.5};

		chains[0] = random_chain(&random, 1 + random_below(&random, 4), 100);
		chains[1] = chains[0];
		for (size_t i = 0; i < chains[0].count; i++)
			chains[1].joints[i].location = vec3_add(chains[0].joints[i].location, shift);
		random_move(&random, &chains[0], 200, &chord.q0, &chord.q1);
		for (size_t i = 0; i < chains[0].count; i++) {
			int slot = chains[0].joints[i].slot;

			chord.q1.v[slot] -= chord.q0.v[slot];
			chord.q0.v[slot] = 0;
		}
		for (int k = 0; k < 2; k++) {
			struct mesh a = box_at((vec3){4, 8, 16}, k ? shift : (vec3){0, 0, 0});
			struct mesh b = box_at(half, k ? vec3_add(at, shift) : at);

			duo_init(&duos[k], &chains[k], &a, &b, &places[k], &places[k]);
			answers[k] = sweep_chord(&sweep, &duos[k].pair, &chord, 0, 1e-3, &contacts[k]);
			oracle_judge(&duos[0], &chord.q0, &chord.q1, 0, 1e-3, answers[k], &contacts[k], "far", n);
		}
		duo_release(&duos[0]);
		duo_release(&duos[1]);
	}
	sweep_release(&sweep);
}
END_TEST

/* If rounding exceeds the tolerance, the answer is "undecided", after a short time and without a guess. */
START_TEST(hopeless_tolerance)
{
	struct chain chain = chain_of(&along_x, NULL);
	struct mesh a = box_at((vec3){0x1p28, 64, 64}, (vec3){0x1p29, 0, 0}),
		    b = box_at((vec3){64, 64, 64}, (vec3){0, 0, 128});
	struct chord chord = move_of(SLOT_X, 0, 0x1p30, -1, 0);
	struct contact contact;
	struct duo duo;

	duo_init(&duo, &chain, &a, &b, &here, &here);
	ck_assert_int_eq(sweep_once(&duo, &chord, 1e-6, 1e-9, &contact), SWEEP_UNDECIDED);
	duo_release(&duo);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("closed forms");

	tcase_add_test(tcase, thin_wall);
	tcase_add_test(tcase, middle_of_a_turn);
	tcase_add_test(tcase, slide);
	tcase_add_test(tcase, starts_and_ends);
	tcase_add_test(tcase, many_turns);
	tcase_add_test(tcase, far_from_the_origin);
	tcase_add_test(tcase, hopeless_tolerance);
	return run_suite("sweep_cases", tcase);
}
