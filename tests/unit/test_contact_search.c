#include "scene/contact_search.h"
#include "scene/tool_contact.h"

#include "machine/tool_solid.h"
#include "solids.h"
#include "suite.h"

/* Joints of a few hundred mm and of whole turns; a small tool far from a small body, which it can reach. */
static void make_duo(struct random *random, struct duo *duo, axis_values *low, axis_values *high, axis_values *meeting)
{
	struct mesh a = random_solid(random, 10), b = random_solid(random, 6);
	struct chain chain = random_chain(random, 3 + random_below(random, 3), 200);
	xform place_a = random_place(random, 100), place_b;

	for (int k = 0; k < SLOT_COUNT; k++) {
		double size = slot_is_rotary(k) ? PI : 300;

		low->v[k] = -size;
		high->v[k] = size;
		meeting->v[k] = random_in(random, -0.9 * size, 0.9 * size);
	}
	place_b = place_near(random, &chain, meeting, &place_a, (vec3){0, 0, 0});
	duo_init(duo, &chain, &a, &b, &place_a, &place_b);
}

/* Everything found is a contact, and most contacts are found. */
START_TEST(finds_contacts)
{
	long found = 0, there = 0;

	for (long n = 0; n < random_cases(400); n++) {
		struct random random = random_case(1, n);
		struct contact_search search = {0};
		struct sweep sweep = {0};
		axis_values low, high, meeting;
		double clearance = n % 3 ? 0 : 1.5;
		struct duo duo;
		xform pose;

		make_duo(&random, &duo, &low, &high, &meeting);
		pose = duo_pose(&duo, &meeting, &meeting, 0, NULL);
		there += brute_distance(duo.a, duo.b, &pose, INFINITY) <= clearance;
		if (contact_search_finds(&search, &sweep, &duo.pair, clearance, &low, &high, false) ||
		    contact_search_finds(&search, &sweep, &duo.pair, clearance, &low, &high, true)) {
			const axis_values *q = &search.met[0];

			require(search.count == 1, "case %ld: %d kept", n, search.count);
			for (size_t i = 0; i < duo.chain.count; i++) {
				int slot = duo.chain.joints[i].slot;

				require(q->v[slot] >= low.v[slot] && q->v[slot] <= high.v[slot], "case %ld: travel", n);
			}
			pose = duo_pose(&duo, q, q, 0, NULL);
			require(brute_distance(duo.a, duo.b, &pose, INFINITY) <= clearance + 1e-6,
				"case %ld: no contact there", n);
			found++;
			/* The same bodies meet again at the same position and near it. */
			require(contact_search_recalls(&search, &sweep, &duo.pair, clearance, &low, &high, q, 0),
				"case %ld: not there again", n);
			require(contact_search_finds(&search, &sweep, &duo.pair, clearance, &low, &high, false),
				"case %ld", n);
		}
		sweep_release(&sweep);
		duo_release(&duo);
	}
	require(4 * found >= 3 * there, "found %ld where at least %ld are", found, there);
}
END_TEST

/* A recalled contact near a position is a contact within the travel; most contacts are recalled. */
START_TEST(recalls_contacts)
{
	long found = 0, there = 0;

	for (long n = 0; n < random_cases(400); n++) {
		struct random random = random_case(2, n);
		struct contact_search search = {0};
		struct sweep sweep = {0};
		axis_values low, high, meeting, near;
		double clearance = n % 3 ? 0 : 1.5;
		struct duo duo;
		xform pose;

		make_duo(&random, &duo, &low, &high, &meeting);
		near = meeting;
		for (int k = 0; k < SLOT_COUNT; k++)
			near.v[k] += random_in(&random, -1, 1) * (slot_is_rotary(k) ? 0.05 : 10);
		pose = duo_pose(&duo, &meeting, &meeting, 0, NULL);
		there += brute_distance(duo.a, duo.b, &pose, INFINITY) <= clearance;
		if (contact_search_recalls(&search, &sweep, &duo.pair, clearance, &low, &high, &near, 8)) {
			const axis_values *q = &search.met[0];

			for (size_t i = 0; i < duo.chain.count; i++) {
				int slot = duo.chain.joints[i].slot;

				require(q->v[slot] >= low.v[slot] && q->v[slot] <= high.v[slot], "case %ld: travel", n);
			}
			pose = duo_pose(&duo, q, q, 0, NULL);
			require(brute_distance(duo.a, duo.b, &pose, INFINITY) <= clearance + 1e-6,
				"case %ld: no contact there", n);
			found++;
		}
		sweep_release(&sweep);
		duo_release(&duo);
	}
	require(2 * found >= there, "recalled %ld where at least %ld are", found, there);
}
END_TEST

/* A cylinder as a tool's piece: what is found is a corner of the body that is inside it, within the travel. */
START_TEST(finds_tools)
{
	const struct tool_section section = {40, 30, 30};
	const struct tool_solid cylinder = {.sections = &section, .count = 1, .top = 20, .tip = TIP_FLAT};
	long found = 0;

	for (long n = 0; n < random_cases(400); n++) {
		struct random random = random_case(3, n);
		struct tool_contact last = {0};
		axis_values low, high, meeting;
		struct body body = {0}, piece = {.profile = &cylinder};
		struct duo duo;

		make_duo(&random, &duo, &low, &high, &meeting);
		body.placement = duo.pair.place_a;
		piece.placement = duo.pair.place_b;
		for (int again = 0;
		     again < 2 && tool_contact_finds(&last, &body, duo.a, &piece, &duo.chain, &low, &high); again++) {
			xform pose = duo_pose(&duo, &last.at, &last.at, 0, NULL), back = xform_inverse(&pose);
			xform in_a = xform_inverse(&body.placement);
			vec3 p = xform_apply(&back, xform_apply(&in_a, last.corner));
			double nearest = INFINITY;

			for (size_t i = 0; i < 3 * duo.a->mesh.count; i++) {
				vec3 corner = mesh_corner(&duo.a->mesh.triangles[i / 3], (int)(i % 3));

				corner = xform_apply(&body.placement, corner);
				nearest = fmin(nearest, vec3_norm(vec3_sub(corner, last.corner)));
			}
			require(nearest < 1e-9, "case %ld: no corner of the body", n);
			require(hypot(p.x, p.y) < 15 && fabs(p.z) < 20, "case %ld: not inside", n);
			for (size_t i = 0; i < duo.chain.count; i++) {
				int slot = duo.chain.joints[i].slot;

				require(last.at.v[slot] >= low.v[slot] && last.at.v[slot] <= high.v[slot],
					"case %ld: travel", n);
			}
			found += !again;
		}
		duo_release(&duo);
	}
	require(8 * found >= random_cases(400), "found %ld", found);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("search");

	tcase_add_test(tcase, finds_contacts);
	tcase_add_test(tcase, recalls_contacts);
	tcase_add_test(tcase, finds_tools);
	return run_suite("contact_search", tcase);
}
