#include "machine.h"

#include <algorithm>
#include <cstdio>

#include "../bench/mesh_apart.h"

/*
 * mm: how deep a cutter may enter the part at rapid or with a stopped spindle; and how much deeper it must be to be
 * certainly found.
 */
static const double RAPID_ALLOWANCE = 0.1;
static const double CORE_MARGIN = 0.02;

/* Neighbours that are drawn nearer than 5 mm are excused. Here there are none, so that every pair counts. */
static const double NEIGHBOURS_APART = 5.01;
static const double OTHERS_APART = 0.05;

static const char LETTERS[] = "XYZABCUVW";

std::string decimal(double value, int places)
{
	char text[64];

	std::snprintf(text, sizeof(text), "%.*f", places, value);
	return text;
}

static double rounded(double value, int places)
{
	return std::stod(decimal(value, places));
}

static vec rounded(vec v, int places)
{
	return vec_of(rounded(v.x, places), rounded(v.y, places), rounded(v.z, places));
}

int Machine::axis(char letter) const
{
	for (int i = 0; i < world.axis_count; i++)
		if (world.axes[i].letter == letter)
			return i;
	return -1;
}

Position Machine::home() const
{
	Position q = {};

	for (int i = 0; i < world.axis_count; i++)
		q[(size_t)i] = world.axes[i].home;
	return q;
}

int axes_between(const scene &world, int a, int b)
{
	int count = 0;

	/* Parents have lower numbers. */
	for (; a != b; count++) {
		int &later = a > b ? a : b;

		later = world.axes[later - 1].parent;
	}
	return count;
}

/* ------------------------------------------------------------------ axes */

/* Three times out of four along a coordinate axis. The value is the link. */
static int add_axis(Random &random, Machine &machine, char letter, int parent, bool askew)
{
	axis &axis = machine.world.axes[machine.world.axis_count++];
	bool rotary = letter >= 'A' && letter <= 'C';
	int k = rotary ? letter - 'A' : letter >= 'X' ? letter - 'X' : letter - 'U';
	double along[3] = {0, 0, 0}, width = rotary ? random.in(60, 360) : random.in(40, 300);
	double middle = random.in(-0.3, 0.3) * width, skew = random.in(0.05, 0.4);
	Travel travel;

	along[k] = random.chance(0.8) ? 1 : -1;
	axis.direction = vec_of(along[0], along[1], along[2]);
	if (askew && random.chance(0.3))
		axis.direction = add(axis.direction, times(skew, random.direction()));
	else if (rotary && random.chance(0.2))
		axis.direction = random.chance(0.5) ? vec_of(0, 1, 1) : random.direction();
	axis.direction = rounded(axis.direction, 6);
	axis.direction = times(1 / norm(axis.direction), axis.direction);
	axis.letter = letter;
	axis.rotary = rotary;
	axis.parent = parent;
	axis.location = rounded(random.point(120), 3);
	travel.low = rounded(middle - width / 2, 3);
	travel.high = rounded(middle + width / 2, 3);
	travel.rate = rounded(random.in(20, 600), 0);
	axis.home = random.chance(0.8) ? 0 : rounded(random.in(travel.low, travel.high), 3);
	axis.home = std::min(std::max(axis.home, travel.low), travel.high);
	machine.travels.push_back(travel);
	return machine.world.axis_count;
}

/*
 * One of the three families: X Y Z in any order, each in the head or the table, and one to three rotary axes beyond
 * them.
 */
static void five_axes(Random &random, Machine &machine)
{
	std::vector<char> linear = {'X', 'Y', 'Z'}, rotary = {'A', 'B', 'C'};
	bool askew = random.chance(0.3);
	int family = random.below(3), count = 1 + random.below(2), head = 0, table = 0;

	random.shuffle(linear);
	random.shuffle(rotary);
	for (char letter : linear) {
		int &side = random.chance(0.6) ? head : table;

		side = add_axis(random, machine, letter, side, askew);
	}
	if (random.chance(0.1))
		count++;
	for (int i = 0; i < count; i++) {
		int &side = family == 0 || (family == 2 && i % 2) ? table : head;

		side = add_axis(random, machine, rotary[(size_t)i], side, false);
	}
	machine.spindle = head;
	machine.table = table;
	machine.follows_tip = true;
}

/* A tree of any axes in any order. */
static void any_axes(Random &random, Machine &machine)
{
	std::vector<char> letters(LETTERS, LETTERS + 9);
	int count = 1 + random.below(6);

	if (random.chance(0.5)) {
		count = std::max(count, 3);
		random.shuffle(letters);
		std::stable_partition(letters.begin(), letters.end(), [](char c) { return c >= 'X'; });
	} else {
		random.shuffle(letters);
	}
	for (int i = 0; i < count; i++)
		add_axis(random, machine, letters[(size_t)i], i && random.chance(0.6) ? i : random.below(i + 1), true);
	machine.spindle = random.below(count + 1);
	machine.table = random.below(count + 1);
}

/* ---------------------------------------------------------------- bodies */

static pose turned_about(int k, double degrees)
{
	axis axis = {'A', 1, 0, {k == 0 ? 1.0 : 0, k == 1 ? 1.0 : 0, k == 2 ? 1.0 : 0}, {0, 0, 0}, 0};

	return axis_motion(&axis, degrees);
}

/* The placement of the mesh at the zero pose. */
static pose place_of(const Machine &machine, const Body &body)
{
	pose x = turned_about(0, body.turns.x), y = turned_about(1, body.turns.y), z = turned_about(2, body.turns.z);
	pose yx = after(&y, &x), place = after(&z, &yx);

	place.t = body.location;
	if (body.role == Role::FIXTURE || body.role == Role::PART)
		place.t = add(place.t, machine.work);
	return place;
}

static void bound(solid &solid)
{
	vec low = vec_of(INFINITY, INFINITY, INFINITY), high = times(-1, low);

	for (size_t i = 0; i < 3 * solid.count; i++) {
		vec p = solid.triangles[i / 3].p[i % 3];

		low = vec_of(std::fmin(low.x, p.x), std::fmin(low.y, p.y), std::fmin(low.z, p.z));
		high = vec_of(std::fmax(high.x, p.x), std::fmax(high.y, p.y), std::fmax(high.z, p.z));
	}
	solid.middle = times(0.5, add(low, high));
	for (size_t i = 0; i < 3 * solid.count; i++)
		solid.radius = std::fmax(solid.radius, norm(sub(solid.triangles[i / 3].p[i % 3], solid.middle)));
}

/* Valid as long as the body's `placed` is. */
static solid solid_of(Body &body)
{
	solid solid = {};

	solid.link = body.link;
	solid.tool = body.tool;
	std::snprintf(solid.name, sizeof(solid.name), "%s", body.name.c_str());
	solid.triangles = body.placed.data();
	solid.count = body.placed.size();
	bound(solid);
	return solid;
}

static void place(Random &random, const Machine &machine, Body &body)
{
	body.location = rounded(random.point(110), 3);
	body.turns = random.chance(0.5) ? vec_of(0, 0, 0) : rounded(random.point(180), 3);
	body.placed = body.drawn;
	pose where = place_of(machine, body);
	for (triangle &t : body.placed)
		for (vec &p : t.p)
			p = apply(&where, p);
}

static double distance(const solid &a, const solid &b, const pose &rel)
{
	box_tree trees[2] = {box_tree_of(&a), box_tree_of(&b)};
	hint hint = {0, 0};
	double apart = mesh_apart(&trees[0], &trees[1], &rel, &hint);

	for (box_tree &tree : trees) {
		std::free(tree.triangles);
		std::free(tree.nodes);
	}
	return apart;
}

static bool may_stand(Machine &machine, Body &body)
{
	solid mine = solid_of(body);
	pose poses[AXES_MAX + 1];

	link_poses(&machine.world, machine.home().data(), poses);
	for (Body &other : machine.bodies) {
		solid theirs = solid_of(other);
		pose back = inverse(&poses[body.link]), rel = after(&back, &poses[other.link]), forth = inverse(&rel);
		int between = axes_between(machine.world, body.link, other.link);

		if (between && (distance(mine, theirs, rel) < (between == 1 ? NEIGHBOURS_APART : OTHERS_APART) ||
				encloses(mine, apply(&rel, theirs.triangles[0].p[0])) ||
				encloses(theirs, apply(&forth, mine.triangles[0].p[0]))))
			return false;
	}
	return true;
}

/* The body is left out if there is no room for it. */
static void add_body(Random &random, Machine &machine, const std::string &name, Role role, int link, double size)
{
	Body body;

	body.name = name;
	body.role = role;
	body.link = link;
	body.drawn = random_shape(random, size);
	for (triangle &t : body.drawn)
		for (vec &p : t.p)
			p = vec_of((float)p.x, (float)p.y, (float)p.z);
	for (int tries = 0; tries < 12; tries++) {
		place(random, machine, body);
		if (may_stand(machine, body)) {
			machine.bodies.push_back(body);
			return;
		}
	}
}

/* A profile from the gauge point toward the tip, which starts `from` mm below it. */
static Body &add_tool_body(Machine &machine, const Tool &tool, Role role, const std::vector<Ring> &profile)
{
	const int sides = 96;
	Body body;
	vec z = machine.tool_direction, x = cross(z, std::fabs(z.x) < 0.8 ? vec_of(1, 0, 0) : vec_of(0, 1, 0)), y;
	double widest = 0;

	x = times(1 / norm(x), x);
	y = cross(z, x);
	for (const Ring &ring : profile)
		widest = std::max(widest, ring.radius);
	body.name = "T" + std::to_string(tool.number) + (role == Role::HOLDER ? " holder" : " cutter");
	body.role = role;
	body.link = machine.spindle;
	body.tool = tool.number;
	body.placed = revolved(profile, sides);
	for (triangle &t : body.placed)
		for (vec &p : t.p)
			p = add(machine.gauge, add(times(p.x, x), add(times(p.y, y), times(p.z, z))));
	/* fivecheck's solid is up to 0.01 mm outside the true one, and that outside this one by the height of an arc. */
	body.slack = 0.0101 + widest * (1 - std::cos(3.14159265358979323846 / 64));
	machine.bodies.push_back(body);
	return machine.bodies.back();
}

/* A cutter whose surface is `depth` below that of the tool; its upper end stays in place. */
static std::vector<Ring> cutter_profile(const Tool &tool, double depth)
{
	double r = tool.diameter / 2 - depth, foot = tool.length - depth;
	std::vector<Ring> profile = {{r, tool.holder_length}, {r, tool.ball ? foot - r : foot}};

	for (int i = 1; tool.ball && i <= 16; i++) {
		double angle = 3.14159265358979323846 / 32 * i;

		profile.push_back({i < 16 ? r * std::cos(angle) : 0, foot - r + r * std::sin(angle)});
	}
	return profile;
}

static void add_tool(Random &random, Machine &machine, int number)
{
	Tool tool;

	tool.number = number;
	tool.holder_length = rounded(random.in(10, 60), 2);
	tool.holder_diameter = rounded(random.in(15, 80), 2);
	tool.diameter = rounded(random.in(2, 30), 2);
	tool.length = rounded(tool.holder_length + tool.diameter + random.in(5, 60), 2);
	tool.ball = random.chance(0.5);
	add_tool_body(machine, tool, Role::HOLDER,
		      {{tool.holder_diameter / 2, 0}, {tool.holder_diameter / 2, tool.holder_length}});
	add_tool_body(machine, tool, Role::CUTTER, cutter_profile(tool, 0));
	Body &core = add_tool_body(machine, tool, Role::CUTTER, cutter_profile(tool, RAPID_ALLOWANCE + CORE_MARGIN));
	core.core = true;
	core.slack += 2 * CORE_MARGIN;
	machine.tools.push_back(tool);
}

static void add_setup(Random &random, Machine &machine)
{
	int tools = random.below(4);

	machine.has_setup = true;
	if (random.chance(0.5))
		add_body(random, machine, "vise", Role::FIXTURE, machine.table, random.size(5, 60));
	if (random.chance(0.5))
		add_body(random, machine, "blank", Role::PART, machine.table, random.size(5, 60));
	for (int i = 1; i <= tools; i++)
		add_tool(random, machine, i);
	for (const char *name : {"G54", "G55", "G56"}) {
		Offset offset = {name, {}};

		for (int i = 0; i < machine.world.axis_count; i++)
			offset.shift[(size_t)i] = random.chance(0.5) ? rounded(random.in(-30, 30), 3) : 0;
		machine.offsets.push_back(offset);
	}
}

static bool cutting(const Body &a, const Body &b)
{
	return (a.role == Role::CUTTER && b.role == Role::PART) || (a.role == Role::PART && b.role == Role::CUTTER);
}

/* The world of the bodies, and their pairs. */
static void settle(Machine &machine)
{
	for (Body &body : machine.bodies)
		machine.solids.push_back(solid_of(body));
	machine.world.solids = machine.solids.data();
	machine.world.solid_count = (int)machine.solids.size();
	for (size_t a = 0; a < machine.bodies.size(); a++) {
		for (size_t b = a + 1; b < machine.bodies.size(); b++) {
			const Body &x = machine.bodies[a], &y = machine.bodies[b];
			bool rigid = !axes_between(machine.world, x.link, y.link);

			bool core = x.core || y.core, required = core == cutting(x, y);

			machine.pairs.push_back({{(int)a, (int)b, 0, 1}, !rigid && required, core});
		}
	}
}

void generate_machine(Random &random, Machine &machine)
{
	static const char *const dialects[] = {"linuxcnc", "fanuc", "haas"};

	random.chance(0.6) ? five_axes(random, machine) : any_axes(random, machine);
	machine.dialect = dialects[random.below(3)];
	machine.rapid = random.chance(0.5) ? "linear" : "dogleg";
	machine.gauge = rounded(random.point(100), 3);
	machine.tool_direction = random.chance(0.7) ? vec_of(0, 0, -1) : rounded(random.direction(), 6);
	machine.tool_direction = times(1 / norm(machine.tool_direction), machine.tool_direction);
	machine.work = rounded(random.point(100), 3);
	for (int link = 0; link <= machine.world.axis_count; link++) {
		std::string name = link ? std::string("link ") + machine.world.axes[link - 1].letter : "bed";

		add_body(random, machine, name, Role::MACHINE, link, random.size(4, 50));
		if (random.chance(0.15))
			add_body(random, machine, name + " too", Role::MACHINE, link, random.size(4, 40));
	}
	if (random.chance(0.7))
		add_setup(random, machine);
	settle(machine);
}
