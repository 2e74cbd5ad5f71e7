/*
 * program.h - a random NC program and the motion of its axes, which is recorded while the program is made, and never
 * read from it.
 */
#ifndef CAMPAIGN_PROGRAM_H
#define CAMPAIGN_PROGRAM_H

#include <string>
#include <vector>

#include "machine.h"

enum class Path {
	STRAIGHT,	/* every axis in proportion */
	DOGLEG,	/* every axis at its own rate */
	ARC,	/* two axes on a circle, the others in proportion */
	TIP	/* the tip of the tool on a straight line in the workpiece (TCP), rotary axes in proportion */
};

/* One line of the program makes one move. */
struct Move {
	int line, tool;
	bool cuts = false;	/* at feed, with a turning spindle */
	Path path = Path::STRAIGHT;
	Position from = {}, to = {};
	int first = 0, second = 0;	/* ARC: the axes of the plane */
	double centre[2] = {0, 0}, sweep = 0;	/* radians */
	vec tip_from = {0, 0, 0}, tip_to = {0, 0, 0};	/* TIP: in the workpiece, at the zero pose */
	double length = 0;	/* TIP: from the gauge point */
};

struct Program {
	std::string text;
	std::vector<Move> moves;
};

Program generate_program(Random &random, const Machine &machine);

/* The positions of the axes at the share s of a move; time and s are proportional. */
Position position(const Machine &machine, const Move &move, double s);

/* ---------------------------------------------------------- tool centre point */

/* The tip of a tool of this length in the workpiece, both at the zero pose. */
vec tip_at(const Machine &machine, const Position &q, double length);

/* The linear axes that bring the tip there, with the rotary axes of q. */
Position follow_tip(const Machine &machine, const Position &q, vec tip, double length);

/* The X Y Z to program for this: the position of the gauge point there if every rotary axis were at 0. */
vec commanded_for(const Machine &machine, vec tip);
vec tip_for(const Machine &machine, vec commanded);

/* Do X Y Z together move well in every direction? */
bool tip_can_follow(const Machine &machine);

#endif
