/* machine.h - a random machine with its setup: as kinematics and meshes of the campaign's own, and as files. */
#ifndef CAMPAIGN_MACHINE_H
#define CAMPAIGN_MACHINE_H

#include <array>
#include <string>
#include <vector>

#include "shapes.h"

/* Positions in the order of the machine's axes; mm and degrees. */
using Position = std::array<double, AXES_MAX>;

enum class Role { MACHINE, FIXTURE, PART, HOLDER, CUTTER };

struct Body {
	std::string name;
	Role role = Role::MACHINE;
	int link = 0, tool = 0;
	bool core = false;	/* of the cutter of that name: what must stay out of the part while it does not cut */
	vec location = {0, 0, 0}, turns = {0, 0, 0};	/* of the file's coordinates; degrees about X, then Y, then Z */
	Surface drawn, placed;	/* as in the file (floats); at the zero pose */
	double slack = 0;	/* mm: how far fivecheck's solid, which encloses this one, may stick out of it */
};

struct Travel {
	double low, high;	/* ends of travel */
	double rate;	/* mm/s, degrees/s */
};

struct Tool {
	int number;
	double length, diameter, holder_length, holder_diameter;
	bool ball;
};

struct Offset {
	std::string name;
	Position shift;
};

struct Pair {
	solid_pair bodies;	/* as travel.h wants it */
	bool required;	/* false: rigid, or cutting */
	bool core;	/* a cutter's core and the part: required while the cutter does not cut, and has no clearance */
};

/* Not to be copied: `world` points into `bodies`. */
struct Machine {
	Machine() = default;
	Machine(const Machine &) = delete;

	std::string dialect, rapid;
	std::vector<Travel> travels;
	std::vector<Body> bodies;
	std::vector<Tool> tools;
	std::vector<Offset> offsets;	/* G54 on; where the setup has none, 0 */
	std::vector<Pair> pairs;
	int spindle = 0, table = 0;	/* links */
	vec gauge = {0, 0, 0}, tool_direction = {0, 0, -1}, work = {0, 0, 0};
	bool follows_tip = false;	/* TCP can be commanded */
	bool has_setup = false;
	scene world = {};	/* the same axes and bodies */
	std::vector<solid> solids;

	/* -1 where there is no such axis */
	int axis(char letter) const;
	Position home() const;
};

void generate_machine(Random &random, Machine &machine);

/* m.xml, s.xml if there is a setup, and the meshes. */
void write_machine(const Machine &machine, const std::string &folder);

/* Number of axes between two links. */
int axes_between(const scene &world, int a, int b);

/* A decimal of so many places, as it will be read again. */
std::string decimal(double value, int places);

#endif
