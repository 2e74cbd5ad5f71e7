/* oracle_tool.h - the tools of the random jobs, by their outlines: shares no code with fivecheck. */
#ifndef ORACLE_TOOL_H
#define ORACLE_TOOL_H

#include <stdbool.h>
#include <stdio.h>

#include "oracle_random.h"

enum piece { HOLDER, SHANK, CUTTER, PIECES };
enum tip { FLAT, BALL, BULL, CONE, UNDERCUT, TIPS };

enum { OUTLINE_MAX = 64 };

/* The outline of a piece from its top at the axis to its bottom at the axis. */
struct outline {
	int count;
	double r[OUTLINE_MAX], z[OUTLINE_MAX];	/* mm: radius, height over the tool's tip */
	double widest;
};

struct tool {
	double length[PIECES], radius[PIECES], neck, corner;	/* radius < 0: the piece is not there */
	enum tip tip;
	struct outline outlines[PIECES];
};

void tool_make(struct tool *t, struct oracle_random *random);

/* A pin of this radius, twice as long, with a ball's end; its stem is too thin to matter. */
void tool_make_feeler(struct tool *t, double radius);

/* The radius of a piece at a height over the tip; negative: it is not there. */
double tool_radius_at(const struct tool *t, enum piece piece, double z);

/* mm: the distance of a point to the surface of a piece, to 0.001; negative inside. */
double tool_distance(const struct tool *t, enum piece piece, double r, double z);

/* mm: not more than that distance; quick. */
double tool_least_distance(const struct tool *t, enum piece piece, double r, double z);

/* <cutter> with its sections. */
void tool_write_cutter(const struct tool *t, FILE *out);

#endif
