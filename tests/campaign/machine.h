/* machine.h - a random machine with its setup: as kinematics and meshes of the campaign itself, and as files. */
#ifndef CAMPAIGN_MACHINE_H
#define CAMPAIGN_MACHINE_H

#include <array>
#include <string>
#include <vector>

#include "shapes.h"

/* Positions in the order of the axes of the machine; mm and degrees. */
using Position = std::array<double, AXES_MAX>;

enum class Role { MACHINE, FIXTURE, PART, HOLDER, CUTTER };

struct Body {
	std::string name;
	Role role = Role::MACHINE;
	int link = 0, tool = 0;
	bool core = false;	/* of the cutter: what must stay out of the part while it does not cut */
	vec location = {0, 0, 0}, turns = {0, 0, 0};	/* of the file's coordinates; degrees about X, Y, Z in turn */
	Surface drawn, placed;	/* as in the file (floats); at the zero pose */
	double slack = 0;	/* mm: how far fivecheck's solid, which contains this one, may extend beyond it */
};

struct Travel {
	double low, high;	/* the ends of the travel */
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
	solid_pair bodies;	/* in the form of travel.h */
	bool required;	/* false: rigid, or cutting */
	bool core;	/* a cutter's core and the part: required while it does not cut; no clearance */
};

/* No copies: `world` points into `bodies`. */
struct Machine {
	Machine() = default;
	Machine(const Machine &) = delete;

	std::string dialect, rapid;
	std::vector<Travel> travels;
	std::vector<Body> bodies;
	std::vector<Tool> tools;
	std::vector<Offset> offsets;	/* from G54 on; 0 if the setup does not have it */
	std::vector<Pair> pairs;
	int spindle = 0, table = 0;	/* links */
	vec gauge = {0, 0, 0}, tool_direction = {0, 0, -1}, work = {0, 0, 0};
	bool follows_tip = false;	/* TCP can be commanded */
	bool has_setup = false;
	scene world = {};	/* with the same axes and bodies */
	std::vector<solid> solids;

	/* -1: there is no such axis */
	int axis(char letter) const;
	Position home() const;
};

void generate_machine(Random &random, Machine &machine);

/* Writes m.xml, s.xml if there is a setup, and the meshes. */
void write_machine(const Machine &machine, const std::string &folder);

/* The number of axes between two links. */
int axes_between(const scene &world, int a, int b);

/* A decimal with this number of places, as it will be read again. */
std::string decimal(double value, int places);

#endif
