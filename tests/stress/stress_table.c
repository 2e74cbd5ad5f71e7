/* stress_table - prints the cases of tests/unit/stress_*.h, what FCL answers, what fivecheck answers: as Markdown. */
#include <ctype.h>
#include <stdlib.h>

#include "fcl_answer.h"
#include "stress_encounters.h"
#include "stress_positions.h"

#define SAMPLES 1000
#define SAMPLE (1.000001 / SAMPLES)

/* Of the size of a pair: a distance off by less is right, as FCL takes roots of squares and has no bound to keep. */
#define GENEROUS 1e-9

struct opinion {
	bool meet;
	double distance;
	long meet_wrong, distance_wrong;	/* of all disguises */
};

static struct fcl_body *fcl_triangle(const tri *t)
{
	double corners[9];

	for (int k = 0; k < 9; k++) {
		const vec3 *p = &t->p[k / 3];

		corners[k] = k % 3 == 0 ? p->x : k % 3 == 1 ? p->y : p->z;
	}
	return fcl_body_new(corners, 1);
}

static void ask_fcl(const tri *a, const tri *b, bool *meet, double *distance)
{
	struct fcl_body *of_a = fcl_triangle(a), *of_b = fcl_triangle(b);

	*meet = fcl_bodies_meet(of_a, of_b, NULL);
	*distance = fcl_bodies_distance(of_a, of_b, NULL);
	fcl_body_free(of_a);
	fcl_body_free(of_b);
}

static void ask_fivecheck(const tri *a, const tri *b, bool *meet, double *distance)
{
	vec3 on_a, on_b;

	*meet = tri_meet(a, b);
	*distance = tri_distance(a, b, &on_a, &on_b);
}

/* Contact where there is none is wrong however near it is. */
static bool is_wrong(double distance, double truth, double size)
{
	return !(fabs(distance - truth) <= GENEROUS * size) || (truth > 0 && distance <= 0);
}

typedef void ask_fn(const tri *a, const tri *b, bool *meet, double *distance);

static struct opinion opinion_of(ask_fn *ask, const struct position *position)
{
	struct opinion answer = {0};

	ask(&position->a, &position->b, &answer.meet, &answer.distance);
	for (int k = 0; k < DISGUISES; k++) {
		tri a, b;
		double truth = disguise_pair(position, k, &a, &b), distance;
		bool meet;

		ask(&a, &b, &meet, &distance);
		answer.meet_wrong += meet != (truth <= 0);
		answer.distance_wrong += is_wrong(distance, truth, tri_pair_size(&a, &b));
	}
	return answer;
}

static void print_wrong(long wrong)
{
	if (wrong)
		printf("**%ld**", wrong);
	else
		printf("0");
}

static void print_answer(const struct opinion *answer, const struct position *position)
{
	double size = tri_pair_size(&position->a, &position->b);
	bool wrong = answer->meet != (position->distance <= 0);
	bool off = is_wrong(answer->distance, position->distance, size);

	printf(" | %s%s%s, ", wrong ? "**" : "", answer->meet ? "meet" : "apart", wrong ? "**" : "");
	printf("%s%.3g%s | ", off ? "**" : "", answer->distance, off ? "**" : "");
	print_wrong(answer->meet_wrong);
	printf(", ");
	print_wrong(answer->distance_wrong);
}

static void print_positions(void)
{
	printf("| two triangles | distance, mm | FCL %s | wrong | fivecheck %s | wrong |\n|---|---|---|---|---|---|\n",
	       fcl_version(), FIVECHECK_VERSION);
	for (size_t i = 0; i < POSITIONS; i++) {
		struct opinion fcl = opinion_of(ask_fcl, &positions[i]);
		struct opinion fivecheck = opinion_of(ask_fivecheck, &positions[i]);

		printf("| %s | %.3g", positions[i].name, positions[i].distance);
		print_answer(&fcl, &positions[i]);
		print_answer(&fivecheck, &positions[i]);
		printf(" |\n");
	}
}

/* ------------------------------------------------------------- encounters */

static struct fcl_body *fcl_mesh(const struct mesh *mesh)
{
	double *corners = mem_alloc(9 * mesh->count * sizeof(*corners));
	struct fcl_body *body;

	for (size_t i = 0; i < 9 * mesh->count; i++)
		corners[i] = mesh->triangles[i / 9].v[i / 3 % 3][i % 3];
	body = fcl_body_new(corners, mesh->count);
	free(corners);
	return body;
}

static void pose_at(const struct duo *duo, const struct stress_case *c, double s, double pose[12])
{
	xform x = duo_pose(duo, &c->chord.q0, &c->chord.q1, s, NULL);
	const mat3 *r = &x.rotation;
	const double entries[12] = {r->x.x, r->y.x, r->z.x, r->x.y, r->y.y, r->z.y, r->x.z, r->y.z, r->z.z,
				    x.translation.x, x.translation.y, x.translation.z};

	memcpy(pose, entries, sizeof(entries));
}

/* The first of SAMPLES + 1 places at which FCL has them meet, or nearer than the clearance. */
static double sampled(const struct duo *duo, const struct stress_case *c, const struct fcl_body *a,
		      const struct fcl_body *b)
{
	for (int k = 0; k <= SAMPLES; k++) {
		double pose[12];

		pose_at(duo, c, (double)k / SAMPLES, pose);
		if (c->clearance > 0 ? fcl_bodies_distance(a, b, pose) <= c->clearance : fcl_bodies_meet(a, b, pose))
			return (double)k / SAMPLES;
	}
	return NEVER;
}

static double swept(const struct duo *duo, const struct stress_case *c)
{
	struct sweep sweep = {0};
	struct contact contact = {0};
	enum sweep_answer answer = sweep_chord(&sweep, &duo->pair, &c->chord, c->clearance, c->tolerance, &contact);

	sweep_release(&sweep);
	return answer == SWEEP_CONTACT ? contact.s : NEVER;
}

/* FCL's is allowed a sample's share. */
static void print_first(double s, const struct stress_case *c, double slack)
{
	bool wrong = (s >= 0) != (c->first >= 0) || (s >= 0 && fabs(s - c->first) > slack);
	const char *mark = wrong ? "**" : "";

	if (s < 0)
		printf(" | %snever%s", mark, mark);
	else
		printf(" | %s%.9g %%%s", mark, 100 * s, mark);
}

static bool turns(const struct chain *chain)
{
	for (size_t i = 0; i < chain->count; i++)
		if (chain->joints[i].rotary)
			return true;
	return false;
}

/* Conservative advancement is asked where the motion is a straight one, and no clearance is wanted. */
static void print_encounter(const struct stress_row *row)
{
	struct stress_case c = row->make();
	struct fcl_body *a = fcl_mesh(&c.a), *b = fcl_mesh(&c.b);
	double from[12], to[12];
	struct duo duo;

	duo_init(&duo, &c.chain, &c.a, &c.b, &c.place_a, &c.place_b);
	pose_at(&duo, &c, 0, from);
	pose_at(&duo, &c, 1, to);
	printf("| ");
	for (const char *p = row->name; *p; p++)
		putchar(*p == '_' ? ' ' : *p);
	print_first(c.first, &c, 0);
	print_first(sampled(&duo, &c, a, b), &c, SAMPLE);
	if (turns(&c.chain) || c.clearance > 0)
		printf(" | not asked");
	else
		print_first(fcl_bodies_advance(a, b, from, to), &c, SAMPLE);
	print_first(swept(&duo, &c), &c, c.slack);
	printf(" |\n");
	duo_release(&duo);
	fcl_body_free(a);
	fcl_body_free(b);
}

int main(void)
{
	print_positions();
	printf("\n| first contact | at | FCL, %d samples | FCL, conservative advancement | fivecheck |\n"
	       "|---|---|---|---|---|\n", SAMPLES);
	for (size_t i = 0; i < ROWS; i++)
		print_encounter(&rows[i]);
	return 0;
}
