#include "report/axis_words.h"

#include <math.h>

#include "machine/kinematics_check.h"

/* Cosine: a direction within a tenth of a degree of X, Y or Z is named after it. */
static const double THE_SAME = 0.9999985;

/* The drawing's axis along the direction, 0 to 2, and its sign; -1: none. */
static int along_which(vec3 v, int *sign)
{
	const double parts[3] = {v.x, v.y, v.z};

	for (int k = 0; k < 3; k++) {
		*sign = parts[k] > 0 ? 1 : -1;
		if (fabs(parts[k]) > THE_SAME)
			return k;
	}
	return -1;
}

/* "+X", "-Z", or the vector itself. */
static void add_way(struct strbuf *out, vec3 v)
{
	int sign, letter = along_which(v, &sign);

	if (letter >= 0)
		strbuf_addf(out, "%c%c", sign > 0 ? '+' : '-', "XYZ"[letter]);
	else
		strbuf_addf(out, "(%.4g %.4g %.4g)", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

/* As seen from the point of the vector: from above for a turn about Z. */
static void add_turn(struct strbuf *out, vec3 v)
{
	static const char *const views[] = {"from +X", "from +Y", "from above (+Z)"};
	int sign, letter = along_which(v, &sign);

	if (letter >= 0) {
		strbuf_addf(out, "turns %s, seen %s", sign > 0 ? "counter-clockwise" : "clockwise", views[letter]);
	} else {
		strbuf_addf(out, "turns counter-clockwise, seen from where ");
		add_way(out, v);
		strbuf_addf(out, " points");
	}
}

/* The name of what the axis carries: the tool, the work, or other bodies. */
static const char *carried(int side)
{
	return side > 0 ? "the tool" : side < 0 ? "the work" : "what it carries";
}

static void add_linear(struct strbuf *out, const struct machine *machine, const struct axis *axis, int side)
{
	strbuf_addf(out, "%s moves 10 mm toward ", carried(side));
	add_way(out, axis->direction);
	if (side < 0) {
		strbuf_addf(out, "; the tool moves toward ");
		add_way(out, kinematics_direction(machine, axis));
		strbuf_addf(out, " relative to the work");
	}
}

static void add_rotary(struct strbuf *out, const struct machine *machine, const struct axis *axis, int side)
{
	strbuf_addf(out, "%s ", carried(side));
	add_turn(out, axis->direction);
	if (side) {
		strbuf_addf(out, "; the tool turns right-handed about ");
		add_way(out, kinematics_direction(machine, axis));
		strbuf_addf(out, " relative to the work");
	}
}

void axis_words_add_axis(struct strbuf *out, const struct machine *machine, const struct axis *axis)
{
	int side = kinematics_side(machine, axis);

	if (axis->rotary)
		add_rotary(out, machine, axis, side);
	else
		add_linear(out, machine, axis, side);
}

void axis_words_add(struct strbuf *out, const struct machine *machine)
{
	strbuf_addf(out, "\nwhat a positive value does (all axes at 0, directions of the drawing)\n");
	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		strbuf_addf(out, "  %s+10: ", axis->name);
		axis_words_add_axis(out, machine, axis);
		if (axis->checked)
			strbuf_addf(out, " (checked: %s)", axis->checked);
		strbuf_addf(out, "\n");
	}
}
