/* oracle_job.h - random jobs with stock: a blank, tools, moves that cut it, and moves that feel what was cut. */
#ifndef ORACLE_JOB_H
#define ORACLE_JOB_H

#include <stdbool.h>

#include "oracle_tool.h"

#define MOVES 800

struct move {
	bool rapid, turning;
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
	double allowance;	/* mm: of a cutter at rapid */
	struct tool tools[2];	/* the second is the feeler */
	struct move moves[MOVES];
	int count;
};

/* Where the axes stand before the first move. */
extern const double job_home[4];

void job_make(struct job *job, struct oracle_random *random);

/* The places of a point in the workholding and along the blank's edges, from its middle. */
void job_into_blank(const struct job *job, const double point[3], double inside[3]);
void job_from_blank(const struct job *job, const double inside[3], double point[3]);

/* Is the point of the workholding in the blank, made larger by `margin`? */
bool job_in_blank(const struct job *job, const double point[3], double margin);

/* Writes m.xml, s.xml and p.nc into the folder. The move i stands in line i + 2. Exits on an error. */
void job_write(const struct job *job, const char *folder);

#endif
