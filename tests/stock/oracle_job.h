/* oracle_job.h - random jobs with stock: a blank, tools, moves that cut it, and moves that feel what was cut. */
#ifndef ORACLE_JOB_H
#define ORACLE_JOB_H

#include <stdbool.h>

#include "oracle_tool.h"

#define MOVES 800

enum way {
	STRAIGHT,	/* all axes evenly */
	ARC,	/* in X and Y, Z evenly */
	GUIDED	/* TCP: the tip goes straight over the workpiece, while B turns evenly */
};

struct move {
	bool rapid, turning;
	enum way way;
	double centre[2], sweep;	/* ARC: mm, radians */
	bool bounded;	/* it may end anywhere (G38.3): */
	double stop;	/* the share at which it does */
	double off[3];	/* mm: how far beside its path it goes, within the path tolerance */
	int line;	/* of its program */
	int tool;	/* 0, 1 */
	bool probe;	/* pushes into the wall that the cutter leaves where it stands at `wall` */
	double wall[4];
	double to[4];	/* X Y Z B */
};

/*
 * The machine moves the tool by X, Y and Z and turns the stock by B about the Y axis. At B0 the middle of the blank is
 * at (0, 0, top / 2).
 */
struct job {
	double size[3], angles[3];	/* of the blank: mm, degrees */
	double axes[3][3];	/* its own X, Y and Z as the workholding sees them */
	double top;	/* mm */
	double tolerance;	/* mm: path tolerance of each linear axis; 0: exact */
	bool guided;	/* with TCP */
	int split;	/* the first move of the second program, whose blank is what the first one leaves; 0: there is none */
	double allowance;	/* mm: of a cutter at rapid */
	struct tool tools[2];	/* the second is the feeler */
	struct move moves[MOVES];
	int count;
};

/* Where the axes stand before the first move. */
extern const double job_home[4];

void job_make(struct job *job, struct oracle_random *random);

/* Where the axes stand before a move, if all of it went as it was programmed but for bounded moves. */
void job_start(const struct job *job, int move, double q[4]);

/* Where they are after a share of the move, which begins at `from`; without what it goes beside its path. */
void job_place(const struct move *m, const double from[4], double share, double q[4]);

/* A point of the workholding as the machine sees it with B at this angle, and back. */
void job_to_machine(const double p[3], double degrees, double at[3]);
void job_to_work(const double at[3], double degrees, double p[3]);

/* The places of a point in the workholding and along the blank's edges, from its middle. */
void job_into_blank(const struct job *job, const double point[3], double inside[3]);
void job_from_blank(const struct job *job, const double inside[3], double point[3]);

/* Is the point of the workholding in the blank, made larger by `margin`? */
bool job_in_blank(const struct job *job, const double point[3], double margin);

/* Writes m.xml, s.xml and p.nc into the folder, and s2.xml and p2.nc if it is split. Exits on an error. */
void job_write(struct job *job, const char *folder);

#endif
