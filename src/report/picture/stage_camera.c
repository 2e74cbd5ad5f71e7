#include "report/picture/stage_camera.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "report/picture/draft.h"

static struct camera look_from(double turn, double rise)
{
	const vec3 toward = {math_cos(rise) * math_cos(turn), math_cos(rise) * math_sin(turn), math_sin(rise)};
	const vec3 right = {-math_sin(turn), math_cos(turn), 0};

	return (struct camera){.right = right, .up = vec3_cross(toward, right), .toward = toward};
}

/* A camera for everything. */
static void frame_all(const struct stage *stage, struct camera *camera)
{
	vec3 least = {INFINITY, INFINITY, INFINITY}, greatest = {-INFINITY, -INFINITY, -INFINITY};

	for (int i = 0; (size_t)i < stage->scene->body_count; i++) {
		double r;
		vec3 p;

		if (!stage_shows(stage, i))
			continue;
		p = stage_middle(stage, i, &r);
		least = (vec3){fmin(least.x, p.x - r), fmin(least.y, p.y - r), fmin(least.z, p.z - r)};
		greatest = (vec3){fmax(greatest.x, p.x + r), fmax(greatest.y, p.y + r), fmax(greatest.z, p.z + r)};
	}
	camera->centre = vec3_lerp(least, greatest, 0.5);
	camera->scale = 1 / fmax(1, 0.9 * vec3_norm(vec3_sub(greatest, least)));
}

/* A camera for the contact: the smaller body should be visible as a whole, the larger one as far as it helps. */
static void frame_contact(const struct stage *stage, struct camera *camera)
{
	double a, b;

	stage_middle(stage, stage->a, &a);
	stage_middle(stage, stage->b, &b);
	camera->centre = stage->point;
	camera->scale = 1 / fmin(fmax(10 * fmin(a, b), 100), 2500);
}

static bool is_of_a(uint8_t paint)
{
	const int class = paint / PAINT_LEVELS;

	return class == PAINT_A || class == PAINT_CONTACT_A || class == PAINT_NEAR_A;
}

static bool is_of_b(uint8_t paint)
{
	const int class = paint / PAINT_LEVELS;

	return class == PAINT_B || class == PAINT_CONTACT_B || class == PAINT_NEAR_B;
}

/* The quality of a small picture of the contact: both bodies beside it, and nothing in front of it. */
static double score(const struct raster *raster)
{
	const int middle_x = raster->width / 2, middle_y = raster->height / 2, reach = raster->height / 5;
	double a = 0, b = 0, near_a = 0, near_b = 0;

	for (int y = 0; y < raster->height; y++) {
		for (int x = 0; x < raster->width; x++) {
			const uint8_t paint = raster->paints[y * raster->width + x];
			const bool near = abs(x - middle_x) <= reach && abs(y - middle_y) <= reach;
			const bool is_a = is_of_a(paint), is_b = is_of_b(paint);

			a += is_a;
			b += is_b;
			near_a += near && is_a;
			near_b += near && is_b;
		}
	}
	return 4 * fmin(near_a, near_b) + fmin(a, b) + 0.3 * (near_a + near_b);
}

/* Is the contact in front of everything else at its position, to within a tolerance? */
static bool sees_point(const struct stage *stage, const struct camera *camera, const struct raster *raster)
{
	const vec3 at = camera_project(camera, raster, stage->point);
	const int x = (int)at.x, y = (int)at.y;

	return x >= 0 && y >= 0 && x < raster->width && y < raster->height &&
	       raster->depths[y * raster->width + x] <= at.z + 1.5 / (camera->scale * raster->width);
}

static double rate(const struct stage *stage, const struct draft *draft, const struct camera *camera)
{
	struct raster raster;
	double result;

	raster_init(&raster, draft->width, draft->height);
	draft_draw(draft, camera, &raster);
	result = score(&raster) * (sees_point(stage, camera, &raster) ? 2 : 1);
	raster_release(&raster);
	return result;
}

struct camera camera_usual(void)
{
	return look_from(radians(-60), radians(30));
}

/*
 * People expect a view from the front, and from above the horizon, but not from the top. Such a view of a block shows
 * its top and two sides.
 */
static double familiar(int turn, int rise)
{
	return (rise == draft_rises[0] ? 1.2 : 1) * (turn <= 0 ? 1.1 : 1) * (turn % 90 ? 1.15 : 1);
}

/* A viewing direction, in degrees, and how well it shows the contact. */
struct candidate {
	int turn, rise;
	double score;
};

/*
 * Twelve directions at the usual height; the best of these also at the other heights; the best of all these in finer
 * pictures, whose drafts are ROUGH times as fine.
 */
enum { TURNS = 12, RISEN = 4, CANDIDATES = TURNS + (DRAFT_RISES - 1) * RISEN, JUDGED_FINELY = 6, ROUGH = 3 };

static struct camera camera_of(const struct stage *stage, const struct candidate *candidate)
{
	struct camera camera = look_from(radians(candidate->turn), radians(candidate->rise));

	frame_contact(stage, &camera);
	return camera;
}

static void judge_all(const struct stage *stage, const struct draft *draft, struct candidate *candidates, int count)
{
	for (int i = 0; i < count; i++) {
		struct candidate *it = &candidates[i];
		const struct camera camera = camera_of(stage, it);

		it->score = rate(stage, draft, &camera) * familiar(it->turn, it->rise);
	}
}

/* The best first; among equals the earliest one. */
static void sort_candidates(struct candidate *candidates, int count)
{
	for (int i = 1; i < count; i++) {
		const struct candidate it = candidates[i];
		int k = i;

		for (; k > 0 && candidates[k - 1].score < it.score; k--)
			candidates[k] = candidates[k - 1];
		candidates[k] = it;
	}
}

/* The candidates by rough pictures, the best first. */
static void find_candidates(const struct stage *stage, const struct draft *rough, struct candidate *candidates)
{
	int count = TURNS;

	for (int i = 0; i < TURNS; i++)
		candidates[i] = (struct candidate){.turn = -150 + 30 * i, .rise = draft_rises[0]};
	judge_all(stage, rough, candidates, TURNS);
	sort_candidates(candidates, TURNS);
	for (int i = 0; i < RISEN; i++) {
		for (int k = 1; k < DRAFT_RISES; k++)
			candidates[count++] = (struct candidate){.turn = candidates[i].turn, .rise = draft_rises[k]};
	}
	judge_all(stage, rough, candidates + TURNS, CANDIDATES - TURNS);
	sort_candidates(candidates, CANDIDATES);
}

static struct candidate best_candidate(const struct stage *stage, double scale)
{
	struct draft fine, rough;
	struct candidate candidates[CANDIDATES];

	draft_init(&fine, stage, scale);
	draft_init_coarser(&rough, &fine, ROUGH);
	find_candidates(stage, &rough, candidates);
	judge_all(stage, &fine, candidates, JUDGED_FINELY);
	sort_candidates(candidates, JUDGED_FINELY);
	draft_release(&fine);
	draft_release(&rough);
	return candidates[0];
}

struct camera stage_camera(const struct stage *stage)
{
	struct camera camera = camera_usual();
	struct candidate best;

	if (stage->a < 0 || stage->b < 0 || !stage->has_point) {
		frame_all(stage, &camera);
		return camera;
	}
	frame_contact(stage, &camera);
	best = best_candidate(stage, camera.scale);
	return camera_of(stage, &best);
}
