#include "stock/stock_sweep.h"

#include <math.h>

#include "base/minmax.h"
#include "base/same_double.h"
#include "stock/passage.h"

/* The largest number of halvings of a chord: then a motion of a kilometre is shorter than a nanometre. */
#define SWEEP_DEPTH 44

/* Cells that are smaller than this share of the motion are divided only after the motion is halved. */
#define CELL_SHARE 0.125

struct placed_obstacle stock_sweep_place(const struct stock_sweep *sweep, const axis_values *q)
{
	const xform b_in_a = body_pair_pose(sweep->bodies, q);

	return (struct placed_obstacle){sweep->obstacle, sweep->stock_is_a ? xform_inverse(&b_in_a) : b_in_a};
}

static bool must_stop(struct stock_sweep *sweep, long visits)
{
	if (sweep->effort && sweep->cells->visits - visits > sweep->effort)
		sweep->exhausted = true;
	if (cancel_asked(sweep->cancel))
		sweep->broken_off = true;
	return sweep->exhausted || sweep->broken_off;
}

/* mm: the rounding of a distance with the axes at q. */
static double rounding_at(const struct stock_sweep *sweep, const axis_values *q)
{
	const xform pose = body_pair_pose(sweep->bodies, q);

	return body_pair_rounding(sweep->bodies, q, pose.translation);
}

static void fill_contact(const struct stock_sweep *sweep, const struct cube *cube, const axis_values *q, double s,
			 struct contact *contact)
{
	const struct placed_obstacle placed = stock_sweep_place(sweep, q);
	const vec3 point = xform_apply(&placed.to_obstacle, cube->centre);
	const double gap = obstacle_distance(sweep->obstacle, point) - stock_cells_radius(sweep->cells);

	*contact = (struct contact){
		.s = s,
		.q = *q,
		.distance = larger(gap, 0),
		.point = sweep->stock_is_a ? cube->centre : point,
	};
}

static struct chain_state state_at(const struct stock_sweep *sweep, const axis_values *q)
{
	struct chain_state state;

	chain_state_init(&state, sweep->bodies->chain, q, &sweep->bodies->ball_a, &sweep->bodies->ball_b);
	return state;
}

static void halve_straight(const struct chord *whole, struct chord *first, struct chord *second)
{
	*first = *second = *whole;
	first->q1 = second->q0 = axis_values_between(&whole->q0, &whole->q1, 0.5);
}

/* The largest distance of points from their positions in the middle of a piece of motion. */
struct spread {
	double way;	/* mm: by the motion */
	double error;	/* mm: by the chord error */
	double path;	/* mm: by the path tolerance */
};

static struct spread spread_of(const struct stock_sweep *sweep, const struct chord *chord)
{
	const struct chain_state start = state_at(sweep, &chord->q0), end = state_at(sweep, &chord->q1);
	struct chord_bound bound;

	chord_bound_init(&bound, &(struct joint_chord){
		.chain = sweep->bodies->chain, .start = &start, .end = &end,
		.q0 = &chord->q0, .q1 = &chord->q1, .chord_error = &chord->chord_error, .tolerance = chord->tolerance,
	});
	return (struct spread){0.5 * bound.length, smaller(bound.displacement[0], bound.displacement[1]),
			       smaller(bound.path[0], bound.path[1])};
}

/* The largest number of cells for one search for a certain position: deep ones are found first. */
#define PROOF_EFFORT 400

bool stock_sweep_proves(struct stock_sweep *sweep, const struct chord *chord, const axis_values *q, double time)
{
	const struct placed_obstacle placed = stock_sweep_place(sweep, q);
	const struct spread spread = spread_of(sweep, chord);
	const double doubt = spread.error + spread.path + rounding_at(sweep, q);
	vec3 point;

	return stock_cells_prove(sweep->cells, &placed, time, doubt - sweep->clearance, PROOF_EFFORT, &point);
}

/* The time of a piece of a chord: its start and its length, as shares of the whole. */
struct share {
	double from, length;
};

static bool turns(const struct stock_sweep *sweep, const struct chord *chord)
{
	const struct chain *chain = sweep->bodies->chain;

	for (size_t i = 0; i < chain->count; i++) {
		const int slot = chain->joints[i].slot;

		if (chain->joints[i].rotary && !same_double(chord->q0.v[slot], chord->q1.v[slot]))
			return true;
	}
	return false;
}

/* Does the obstacle come within reach of cells on the chord? `beside`: how far points may be beside the chord. */
static bool meets_in_passage(const struct stock_sweep *sweep, const struct passage *passage, double time, double beside,
			     struct cube *found)
{
	const struct placed_obstacle placed = {&passage->obstacle, xform_inverse(&passage->pose)};

	return stock_cells_meet(sweep->cells, &placed, time, sweep->clearance + beside + passage->error, 0, found);
}

/* Is there a cell that is not proved apart over the chord? If so, *found is such a cell, perhaps a large one. */
static bool meets(const struct stock_sweep *sweep, const struct chord *chord, const struct spread *spread, double time,
		  bool final, struct cube *found)
{
	const axis_values middle = axis_values_between(&chord->q0, &chord->q1, 0.5);
	const struct placed_obstacle placed = stock_sweep_place(sweep, &middle);
	const double beside = spread->error + spread->path + rounding_at(sweep, &middle);
	struct passage passage;

	if (sweep->stock_is_a && sweep->obstacle->revolved && !turns(sweep, chord)) {
		const xform from = body_pair_pose(sweep->bodies, &chord->q0);
		const xform to = body_pair_pose(sweep->bodies, &chord->q1);

		if (passage_init(&passage, sweep->obstacle, &from, &to, sweep->least_way)) {
			const bool met = meets_in_passage(sweep, &passage, time, beside, found);

			passage_release(&passage);
			return met;
		}
	}
	return stock_cells_meet(sweep->cells, &placed, time, sweep->clearance + spread->way + beside,
				final ? 0 : CELL_SHARE * spread->way, found);
}

static enum sweep_answer sweep_piece(struct stock_sweep *sweep, const struct chord *chord, struct share share,
				     double number, int depth, long visits, struct contact *contact)
{
	const struct spread spread = spread_of(sweep, chord);
	const bool final = depth == SWEEP_DEPTH ||
			   (spread.way <= sweep->least_way && (!chord->curve || spread.error <= sweep->least_way));
	struct chord halves[2];
	struct cube found;
	enum sweep_answer answer;

	if (must_stop(sweep, visits))
		return SWEEP_UNDECIDED;
	if (!meets(sweep, chord, &spread, number + share.from, final, &found))
		return SWEEP_APART;
	if (final) {
		fill_contact(sweep, &found, &chord->q0, share.from, contact);
		return SWEEP_CONTACT;
	}
	(chord->curve ? chord->halve : halve_straight)(chord, &halves[0], &halves[1]);
	share.length /= 2;
	answer = sweep_piece(sweep, &halves[0], share, number, depth + 1, visits, contact);
	share.from += share.length;
	return answer == SWEEP_APART ? sweep_piece(sweep, &halves[1], share, number, depth + 1, visits, contact)
				     : answer;
}

enum sweep_answer stock_sweep_chord(struct stock_sweep *sweep, const struct chord *chord, double number,
				    struct contact *contact)
{
	return sweep_piece(sweep, chord, (struct share){0, 1}, number, 0, sweep->cells->visits, contact);
}

/* The joint that moves points farthest between low and high. */
static int widest_slot(const struct stock_sweep *sweep, const struct chain_state *middle, const axis_values *half)
{
	const struct chain *chain = sweep->bodies->chain;
	double widest = -1;
	int slot = 0;

	for (size_t i = 0; i < chain->count; i++) {
		const struct joint *joint = &chain->joints[i];
		const double lever = joint->rotary ? smaller(middle->rho[0][i], middle->rho[1][i]) : 1;

		if (lever * half->v[joint->slot] > widest) {
			widest = lever * half->v[joint->slot];
			slot = joint->slot;
		}
	}
	return slot;
}

static enum sweep_answer sweep_positions(struct stock_sweep *sweep, const axis_values *low, const axis_values *high,
					 double number, int depth, long visits, struct contact *contact)
{
	const axis_values middle = axis_values_between(low, high, 0.5);
	const struct chain_state state = state_at(sweep, &middle);
	const struct placed_obstacle placed = stock_sweep_place(sweep, &middle);
	axis_values half, mid_high = *high, mid_low = *low;
	struct box_bound bound;
	struct cube found;
	enum sweep_answer answer;
	double reach;
	int slot;

	for (int i = 0; i < SLOT_COUNT; i++)
		half.v[i] = 0.5 * (high->v[i] - low->v[i]);
	box_bound_init(&bound, sweep->bodies->chain, &state, &half);
	reach = smaller(bound.reach[0], bound.reach[1]);
	if (must_stop(sweep, visits))
		return SWEEP_UNDECIDED;
	if (!stock_cells_meet(sweep->cells, &placed, number, sweep->clearance + reach + rounding_at(sweep, &middle),
			      reach <= sweep->least_way ? 0 : CELL_SHARE * reach, &found))
		return SWEEP_APART;
	if (reach <= sweep->least_way || depth == SWEEP_DEPTH * SLOT_COUNT) {
		fill_contact(sweep, &found, &middle, 0, contact);
		return SWEEP_CONTACT;
	}
	slot = widest_slot(sweep, &state, &half);
	mid_high.v[slot] = mid_low.v[slot] = middle.v[slot];
	answer = sweep_positions(sweep, low, &mid_high, number, depth + 1, visits, contact);
	return answer == SWEEP_APART ? sweep_positions(sweep, &mid_low, high, number, depth + 1, visits, contact)
				     : answer;
}

enum sweep_answer stock_sweep_box(struct stock_sweep *sweep, const axis_values *low, const axis_values *high,
				  double number, struct contact *contact)
{
	return sweep_positions(sweep, low, high, number, 0, sweep->cells->visits, contact);
}
