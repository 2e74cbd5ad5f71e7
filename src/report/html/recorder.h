/*
 * recorder.h - records one program, while it is checked, for a report: the path of the axes, findings, clearances.
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

/* The scales of the columns. */
#define RECORD_TIME 1e-5	/* s */
#define RECORD_LENGTH 0.01	/* mm */
#define RECORD_ANGLE 0.001	/* degrees */
#define RECORD_CLEARANCE 0.001	/* mm */
#define RECORD_FEED 0.1	/* mm/min */
#define RECORD_NORMAL 1e-6

/* At most this number of planes is kept, and as many again beside findings. */
enum { PLANES_MAX = 64 };

/* A finding, with the data for its drawing. */
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

/* A request to show the plane between the bodies of this pair at the end of this block. */
struct plane_wish {
	struct block_end at;
	size_t pair;
	bool forced;	/* the block is beside a finding */
};

/* The name of a file as used by the check, and a copy that outlives the check. */
struct recorded_file {
	const char *interned;
	char *name;
};

/* Do not move the struct after recorder_init. */
struct recorder {
	struct motion_sink watch;	/* pass it to the check: check_options.watch */
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
	struct stock_view stock;	/* pass it to the check: the stock at the first finding, else at the end */
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
	size_t least_file;	/* the index of its file in `files` */
	/* mm: the smallest clearance that was proved, also of blocks that were not measured; or the cap */
	double bound;
	bool sampled;	/* some blocks were not measured */
	struct plane_wish *wishes;	/* for planes, in the order of time */
	size_t wish_count, wish_capacity, wishes_forced;
	long plane_stride;	/* a plane is requested at intervals of this many blocks */
	int64_t (*planes)[PLANE_COLUMNS];	/* made when the recorder is closed */
	size_t plane_count;
	struct sweep sweep;
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

/* The first finding that fails the run, else the first one; NULL: there is none. */
const struct recorded_finding *recorder_first(const struct recorder *recorder);

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

/* The point between the nearest bodies, in machine coordinates. False: there are none below the cap. */
bool recorder_nearest_point(struct recorder *recorder, vec3 *point);

/* The scale of the column of this axis of the machine. */
double recorder_axis_scale(const struct axis *axis);

#endif
