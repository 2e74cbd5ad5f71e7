/*
 * recorder.h - what a report needs of one program while it is checked: the path of the axes, findings, clearances.
 * Memory does not grow with the program.
 */
#ifndef FIVECHECK_REPORT_HTML_RECORDER_H
#define FIVECHECK_REPORT_HTML_RECORDER_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "check/sink.h"
#include "motion/events.h"
#include "report/html/recorded_table.h"
#include "report/report.h"
#include "scene/sweep.h"
#include "stock/stock_mesh.h"

/* Columns of the path before the axes. */
enum { PATH_TIME, PATH_BLOCK, PATH_LINE, PATH_FILE, PATH_TOOL, PATH_CLASS, PATH_MODES, PATH_FEED, PATH_AXES };
enum { CLEARANCE_TIME, CLEARANCE_LEAST, CLEARANCE_MOST, CLEARANCE_PAIR, CLEARANCE_COLUMNS };
enum {
	PLANE_TIME,
	PLANE_PAIR,
	PLANE_POINT,
	PLANE_NORMAL = PLANE_POINT + 3,
	PLANE_DISTANCE = PLANE_NORMAL + 3,
	PLANE_COLUMNS
};

/* What a one in the columns means. */
#define RECORD_TIME 1e-5	/* s */
#define RECORD_LENGTH 0.01	/* mm */
#define RECORD_ANGLE 0.001	/* degrees */
#define RECORD_CLEARANCE 0.001	/* mm */
#define RECORD_FEED 0.1	/* mm/min */
#define RECORD_NORMAL 1e-6

/* At most so many planes are kept, and so many more beside findings. */
enum { PLANES_MAX = 64 };

/* A finding, with what is drawn of it. */
struct recorded_finding {
	json_t *object;	/* as in NDJSON; owned */
	char *message;	/* owned */
	char *file, *text;	/* owned; the text of the block */
	enum finding_kind kind;
	enum finding_status status;
	long line, block;	/* number of the block, from 1; 0: not known */
	double time, fraction;
	double stock_time;	/* as in the finding */
	axis_values axes;
	int tool;
	int a, b;	/* bodies; -1 for a limit */
	int link;	/* of the axis that leaves its travel; 0: no limit */
	vec3 point;	/* machine coordinates */
	bool has_triangles;	/* false: a limit, or one of the bodies is the stock */
	vec3 triangles[2][3];	/* of a and of b, machine coordinates at the finding's pose */
};

/* Where a block ended. */
struct block_end {
	long number;	/* from 1; 0: none */
	const char *file;	/* its name, as long as the check goes on */
	long line;
	double from, to;	/* s */
	axis_values axes;
	int tool;
	double found;	/* mm: the smallest distance of two bodies in a finding of the block; infinite without one */
	int64_t found_pair;	/* their pair in the scene; -1: not known */
};

/* Blocks between being read and being checked are fewer. */
enum { BLOCK_ENDS = 4096 };

/* So many different modes are kept, feeds apart; in a program that has more, some rows name none. */
enum { MODES_MAX = 512 };

/* At the end of this block the plane between the bodies of this pair is to be shown. */
struct plane_wish {
	struct block_end at;
	size_t pair;
	bool forced;	/* it stands beside a finding */
};

/* The name of a file as the check calls it, and a copy that outlives the check. */
struct recorded_file {
	const char *interned;
	char *name;
};

/* Not to be moved after recorder_init. */
struct recorder {
	struct motion_sink watch;	/* give it to the check: check_options.watch */
	struct scene *scene;
	double cap;	/* mm: of the clearances */
	struct recorded_table path, clearance;
	struct motion_modes *modes;	/* different but for the feed */
	size_t mode_count, mode_capacity;
	int64_t mode;	/* in force: its index, from 0; -1: not known */
	double feed;	/* mm/s: as in motion_modes */
	struct recorded_file *files;
	size_t file_count, file_capacity;
	struct recorded_finding *findings;	/* the first FINDINGS_MAX */
	size_t finding_count, finding_capacity;
	long findings_left_out;
	struct stock_view stock;	/* give it to the check: the stock at the first finding, else at the end */
	struct block_end *ends;	/* ring: block n at n % BLOCK_ENDS */
	long blocks;	/* that were read */
	double now, block_from;	/* s: where the last step, and the block before, ended */
	axis_values position;
	int tool;
	double start;	/* s: of the first step */
	double checked;	/* s: the end of the last block that was handed to recorder_block */
	double least;	/* mm: the smallest clearance that was measured; the cap if none is smaller */
	size_t least_pair;
	struct block_end least_at;	/* the end of its block */
	size_t least_file;	/* in which it stands: of `files` */
	/* mm: the smallest clearance that was proved, also of blocks that were not measured; or the cap */
	double bound;
	bool sampled;	/* some blocks were not measured */
	struct plane_wish *wishes;	/* for planes, in the order of time */
	size_t wish_count, wish_capacity, wishes_forced;
	long plane_stride;	/* every so many blocks a plane is wished for */
	int64_t (*planes)[PLANE_COLUMNS];	/* made when the recorder is closed */
	size_t plane_count;
	struct sweep sweep;
};

/* `program` is its file's name, which the report calls it by. The scene must have been built. */
void recorder_init(struct recorder *recorder, struct scene *scene, const char *program, double cap);
void recorder_release(struct recorder *recorder);

/* To be called for each finding and for each block that was checked (check_sink). */
void recorder_finding(struct recorder *recorder, const struct finding *finding, struct finding_style style);
void recorder_block(struct recorder *recorder, const struct check_block *block);

/* mm, in thousandths, as a clearance is shown: never more than was proved. */
double recorder_shown(double clearance);

/* Completes the tables. False: a temporary file failed; *error is its errno. */
bool recorder_close(struct recorder *recorder, int *error);

/* The first finding that fails the run, else the first one; NULL: there is none. */
const struct recorded_finding *recorder_first(const struct recorder *recorder);

struct recorded_row {
	double time;	/* s */
	axis_values axes;
};

/* Times rise from row to row. The rows are owned. */
struct recorded_window {
	struct recorded_row *rows;
	size_t count;
};

/*
 * The path of the last WINDOW_SECONDS before the first finding, or as much of that as there are WINDOW_ROWS rows for;
 * its last row is the finding. Without a finding the coarse level of the whole path. Empty if nothing moves. The
 * recorder is closed.
 */
#define WINDOW_SECONDS 20.0
enum { WINDOW_ROWS = 8192 };
struct recorded_window recorder_window(struct recorder *recorder);

/* The point between the bodies that were nearest, in machine coordinates. False: there are none below the cap. */
bool recorder_nearest_point(struct recorder *recorder, vec3 *point);

/* What a one means in the column of this axis of the machine. */
double recorder_axis_scale(const struct axis *axis);

#endif
