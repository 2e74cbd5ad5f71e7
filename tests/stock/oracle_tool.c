#include "oracle_tool.h"

#include <math.h>

/* Straight pieces of a quarter circle: of 4 mm radius they leave it by 0.0005 mm. */
#define ARC_PIECES 50

static void add_point(struct outline *outline, double r, double z)
{
	outline->r[outline->count] = r;
	outline->z[outline->count++] = z;
	outline->widest = fmax(outline->widest, r);
}

static double bottom_of(const struct tool *t, enum piece piece)
{
	double z = 0;

	for (int i = CUTTER; i > (int)piece; i--)
		z += t->length[i];
	return z;
}

/* The lower end of the cutter, from where it has its full radius to the axis. */
static void add_tip(const struct tool *t, struct outline *outline)
{
	const double r = t->radius[CUTTER], c = t->tip == BALL ? r : t->corner, quarter = 0.5 * acos(-1);

	if (t->tip == BALL || t->tip == BULL) {
		for (int i = 0; i <= ARC_PIECES; i++)
			add_point(outline, r - c + c * cos(quarter * i / ARC_PIECES), c - c * sin(quarter * i / ARC_PIECES));
	} else if (t->tip == CONE) {	/* 90 degrees */
		add_point(outline, r, r);
		add_point(outline, 0, 0);
	} else {
		add_point(outline, r, 0);
	}
	add_point(outline, 0, 0);
}

static void make_outline(struct tool *t, enum piece piece)
{
	struct outline *outline = &t->outlines[piece];
	const double low = bottom_of(t, piece), high = low + t->length[piece], half = 0.5 * t->length[piece];

	*outline = (struct outline){.count = 0};
	if (t->radius[piece] < 0)
		return;
	add_point(outline, 0, high);
	if (piece == CUTTER && t->tip == UNDERCUT) {
		add_point(outline, t->neck, high);
		add_point(outline, t->neck, half);
		add_point(outline, t->radius[piece], half);
	} else {
		add_point(outline, t->radius[piece], high);
	}
	if (piece == CUTTER) {
		add_tip(t, outline);
	} else {
		add_point(outline, t->radius[piece], low);
		add_point(outline, 0, low);
	}
}

void tool_make(struct tool *t, struct oracle_random *random)
{
	*t = (struct tool){.tip = (enum tip)uniform(random, 0, TIPS)};
	t->radius[CUTTER] = rounded(uniform(random, 1.5, 4));
	t->length[CUTTER] = rounded(uniform(random, 1.2, 4) * t->radius[CUTTER]);
	t->corner = rounded(uniform(random, 0.2, 0.9) * t->radius[CUTTER]);
	t->neck = rounded(uniform(random, 0.4, 0.8) * t->radius[CUTTER]);
	/* Often as wide as the slots that it has to go through, but for a little. */
	t->radius[SHANK] = rounded(uniform(random, 0, 1) < 0.5 ? t->radius[CUTTER] + uniform(random, -0.3, 0.3)
							       : uniform(random, 0.5, 1.2) * t->radius[CUTTER]);
	t->length[SHANK] = rounded(uniform(random, 4, 12));
	t->radius[HOLDER] = rounded(uniform(random, 6, 14));
	t->length[HOLDER] = 100 - t->length[CUTTER] - t->length[SHANK];
	for (int piece = 0; piece < PIECES; piece++)
		make_outline(t, (enum piece)piece);
}

void tool_make_feeler(struct tool *t, double radius)
{
	*t = (struct tool){.length = {0, 0, 2 * radius}, .radius = {-1, -1, radius}, .tip = BALL};
	make_outline(t, CUTTER);
}

double tool_radius_at(const struct tool *t, enum piece piece, double z)
{
	const struct outline *o = &t->outlines[piece];
	double radius = -1;

	for (int i = 0; i + 1 < o->count; i++) {
		const double high = o->z[i], low = o->z[i + 1];

		if (z <= high && z >= low)
			radius = fmax(radius, high > low ? o->r[i] + (o->r[i + 1] - o->r[i]) * (high - z) / (high - low)
							 : fmax(o->r[i], o->r[i + 1]));
	}
	return radius;
}

double tool_least_distance(const struct tool *t, enum piece piece, double r, double z)
{
	const struct outline *o = &t->outlines[piece];

	if (!o->count)
		return INFINITY;
	return fmax(r - o->widest, fmax(z - o->z[0], o->z[o->count - 1] - z));
}

/* The outline together with the axis is a polygon; only the outline is surface. */
double tool_distance(const struct tool *t, enum piece piece, double r, double z)
{
	const struct outline *o = &t->outlines[piece];
	double best = INFINITY;
	bool inside = false;

	for (int i = 0; i + 1 < o->count; i++) {
		const double ar = o->r[i + 1] - o->r[i], az = o->z[i + 1] - o->z[i], length2 = ar * ar + az * az;
		const double br = r - o->r[i], bz = z - o->z[i];
		const double s = length2 > 0 ? fmin(fmax((br * ar + bz * az) / length2, 0), 1) : 0;

		best = fmin(best, hypot(br - s * ar, bz - s * az));
		/* Crossings of the ray outward. */
		if ((o->z[i] > z) != (o->z[i + 1] > z) && r < o->r[i] + (z - o->z[i]) / az * ar)
			inside = !inside;
	}
	return inside ? -best : best;
}

void tool_write_cutter(const struct tool *t, FILE *out)
{
	static const char *const tips[] = {"flat", "ball", "bull", "cone", "flat"};
	const double d = 2 * t->radius[CUTTER], half = 0.5 * t->length[CUTTER];

	fprintf(out, "<cutter tip=\"%s\"", tips[t->tip]);
	if (t->tip == BULL)
		fprintf(out, " corner=\"%.3f\"", t->corner);
	if (t->tip == CONE)
		fprintf(out, " angle=\"90\"");
	fprintf(out, ">");
	if (t->tip == UNDERCUT)
		fprintf(out, "<section length=\"%.6f\" diameter=\"%.6f\"/><section length=\"%.6f\" diameter=\"%.6f\"/>",
			half, 2 * t->neck, half, d);
	else
		fprintf(out, "<section length=\"%.6f\" diameter=\"%.6f\"/>", t->length[CUTTER], d);
	fprintf(out, "</cutter>");
}
