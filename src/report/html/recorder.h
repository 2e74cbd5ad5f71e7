/*
 * recorder.h - records one program, while it is checked, for a report: the path of the axes, findings, clearances.
 * Memory does not grow with the program.
 */
#ifndef FIVECHECK_REPORT_HTML_RECORDER_H
#define FIVECHECK_REPORT_HTML_RECORDER_H

#include <stdbool.h>
#include <stddef.h>

#include "check/sink.h"
#include "motion/events.h"
#include "report/html/recorded_files.h"
#include "report/html/recorded_findings.h"
#include "report/html/recorded_planes.h"
#include "report/html/recorded_table.h"
#include "report/report.h"
#include "scene/sweep.h"
#include "stock/stock_mesh.h"

/* Columns of the path before the axes. */
enum { PATH_TIME, PATH_BLOCK, PATH_LINE, PATH_FILE, PATH_TOOL, PATH_CLASS, PATH_MODES, PATH_FEED, PATH_AXES };
enum { CLEARANCE_TIME, CLEARANCE_LEAST, CLEARANCE_MOST, CLEARANCE_PAIR, CLEARANCE_COLUMNS };

/* The end of a block. */
struct block_end {
	long number;	/* from 1; 0: none */
	const char *file;	/* its name, valid during the check */
	long line;
	double from, to;	/* s */
	axis_values axes;
	int tool;
	double found;	/* mm: the smallest distance of two bodies in a finding of the block; infinite without one */
	int64_t found_pair;	/* their pair in the scene; -1: not known */
};

/* The number of blocks between reading and checking is smaller. */
enum { BLOCK_ENDS = 4096 };

/* At most this number of different modes is kept, apart from the feed; in a program with more, some rows have none. */
enum { MODES_MAX = 512 };

/* Where the smallest clearance was measured. */
struct recorded_nearest {
	double clearance;	/* mm; the cap of the recorder if none is smaller */
	size_t pair;
	size_t file;	/* the index of its file */
	struct block_end end;	/* of its block */
};

/* The modes that were in force, each once, whatever the feed. */
struct recorded_modes {
	struct motion_modes *items;
	size_t count, capacity;
	int64_t current;	/* index of those in force; -1: not known */
	double feed;	/* in force, mm/s: as in motion_modes */
};

/* How far the program was read. */
struct recorded_progress {
	long blocks;	/* number of them */
	double start;	/* s: of the first step */
	double block_from, now;	/* s: where the block before, and the last step, ended */
	axis_values position;	/* at the end of the last step */
	int tool;
};

/* Do not move the struct after recorder_init. */
struct recorder {
	struct motion_sink watch;	/* pass it to the check: check_options.watch */
	struct stock_view stock;	/* pass it to the check: the stock at the first finding, else at the end */
	struct scene *scene;
	double cap;	/* mm: of the clearances */
	struct recorded_progress read;
	struct block_end *ends;	/* ring: block n at n % BLOCK_ENDS */
	double checked;	/* s: the end of the last block that was handed to recorder_block */

	/* What the report shows. */
	struct recorded_files files;
	struct recorded_modes modes;
	struct recorded_findings findings;
	struct recorded_table path, clearance;
	struct recorded_nearest nearest;
	double bound;	/* mm: the smallest proved clearance, also of blocks that were not measured; or the cap */
	bool sampled;	/* some blocks were not measured */
	struct recorded_planes planes;
	struct sweep sweep;	/* finds nearest triangles */
};

/* `program`: the name of its file, which the report uses. The scene must have been built. */
void recorder_init(struct recorder *recorder, struct scene *scene, const char *program, double cap);
void recorder_release(struct recorder *recorder);

/* Call it for each finding and for each checked block (check_sink). */
void recorder_finding(struct recorder *recorder, const struct finding *finding, struct finding_style style);
void recorder_block(struct recorder *recorder, const struct check_block *block);

/* A clearance in thousandths of a mm, as it is shown: never more than was proved. */
double recorder_shown(double clearance);

/* Completes the tables. False: a temporary file failed; *error is its errno. */
bool recorder_close(struct recorder *recorder, int *error);

struct recorded_row {
	double time;	/* s */
	axis_values axes;
};

/* Times increase from row to row. The rows are owned. */
struct recorded_window {
	struct recorded_row *rows;
	size_t count;
};

/*
 * The path of the last WINDOW_SECONDS before the first finding, or as much of it as WINDOW_ROWS rows hold; the last row
 * is the finding. Without a finding, the coarse level of the whole path. Empty if nothing moves. The recorder must be
 * closed.
 */
#define WINDOW_SECONDS 20.0
enum { WINDOW_ROWS = 8192 };
struct recorded_window recorder_window(struct recorder *recorder);

/* Was a clearance below the cap measured? */
bool recorder_is_near(const struct recorder *recorder);

/* mm: what was proved for all blocks; at most the cap. */
double recorder_bound(const struct recorder *recorder);

/* The point between the nearest bodies, in machine coordinates. False: there are none below the cap. */
bool recorder_nearest_point(struct recorder *recorder, vec3 *point);

#endif
