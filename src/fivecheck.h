/*
 * fivecheck.h - fivecheck as a library: load a machine and a setup, check NC programs, receive what is found.
 *
 * The command line itself loads and checks through this header. Compile and link with
 * `pkg-config --cflags --libs fivecheck`: the library is a static archive whose only global symbols are those declared
 * here. They stay as they are from one version to the next; nothing else of the library does.
 *
 * Units: lengths in mm, angles in radians, times in seconds. Places are in machine coordinates. Strings are UTF-8 or
 * whatever bytes the file has, and end in 0.
 * Errors: a function that can fail returns false or NULL, leaves what it would have changed as it was, and reports to
 * its fivecheck_diag. Out of memory ends the process with status 3 and a message.
 * Ownership: who calls ..._new or ..._load calls the matching ..._free, which takes NULL, too. Paths and other
 * arguments are borrowed for the call unless it says otherwise; what a callback is given lives until it returns.
 * Threads: no global state. Different objects may be used by different threads at once. One model may be checked by
 * several threads at once, each with a diag of its own, once it is prepared and while nobody changes it.
 */
#ifndef FIVECHECK_H
#define FIVECHECK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

/* "0.1.0" */
const char *fivecheck_version(void);

/* Messages: what is wrong with an input, and where. */

typedef struct diag fivecheck_diag;
typedef struct diag_entry fivecheck_message;

enum fivecheck_severity { FIVECHECK_NOTE, FIVECHECK_WARNING, FIVECHECK_ERROR };

/* Calls `handle`, unless it is NULL, with every message at once, in the thread that reports it. */
fivecheck_diag *fivecheck_diag_new(void (*handle)(void *context, const fivecheck_message *message), void *context);
void fivecheck_diag_free(fivecheck_diag *diag);
/* Errors so far. */
size_t fivecheck_diag_errors(const fivecheck_diag *diag);

enum fivecheck_severity fivecheck_message_severity(const fivecheck_message *message);
const char *fivecheck_message_file(const fivecheck_message *message);	/* NULL: no file is to blame */
long fivecheck_message_line(const fivecheck_message *message);	/* from 1; 0: not known */
int fivecheck_message_column(const fivecheck_message *message);	/* in bytes, from 1; 0: not known */
const char *fivecheck_message_text(const fivecheck_message *message);	/* one line, without a final newline */

/* A model: a machine and the setup on it. */

typedef struct model fivecheck_model;

/* Reads a machine file and, unless it is NULL, a setup file, which replaces a setup inside the machine file. */
fivecheck_model *fivecheck_load(const char *machine, const char *setup, fivecheck_diag *diag);
void fivecheck_free(fivecheck_model *model);

/* The control that programs are written for, instead of the machine file's: "linuxcnc", "fanuc", "haas", ... */
bool fivecheck_set_dialect(fivecheck_model *model, const char *name, fivecheck_diag *diag);

/* 1 to 1024: the threads that fivecheck_prepare may use; unless set, one. False: out of range. */
bool fivecheck_set_threads(fivecheck_model *model, int threads);

/*
 * Reads the meshes and derives which pairs of bodies must be kept apart: by `clearance` (0 or more) where the machine
 * file gives no other. Once for a model, before programs are checked on it.
 */
bool fivecheck_prepare(fivecheck_model *model, double clearance, fivecheck_diag *diag);

/* How a program is checked. Options may be used for several programs, and by several threads while nobody sets one. */

typedef struct check_options fivecheck_options;

/* Unless set otherwise: the proof in continuous time, up to the first finding, with one thread. */
#define FIVECHECK_TOLERANCE 0.001
fivecheck_options *fivecheck_options_new(void);
void fivecheck_options_free(fivecheck_options *options);
/* mm, 1e-6 to 100: bodies nearer than their clearance and this may count as a finding. False: out of range. */
bool fivecheck_options_set_tolerance(fivecheck_options *options, double tolerance);
/* 1 to 1024. The result does not depend on it. False: out of range. */
bool fivecheck_options_set_threads(fivecheck_options *options, int threads);
/* Goes on after the first finding: reports the first of each block and pair. */
void fivecheck_options_set_all(fivecheck_options *options, bool all);
/* Interprets the program and watches the axis limits only; the model need not be prepared. */
void fivecheck_options_set_parse_only(fivecheck_options *options, bool parse_only);
/* Skips blocks that begin with a slash. */
void fivecheck_options_set_block_delete(fivecheck_options *options, bool block_delete);
/* Folders of subprogram files, after the program's own. The array is borrowed as long as the options are used. */
void fivecheck_options_set_includes(fivecheck_options *options, const char *const *folders, size_t count);

/* Findings. */

typedef struct finding fivecheck_finding;

enum fivecheck_kind {
	FIVECHECK_COLLISION,	/* bodies meet */
	FIVECHECK_CLEARANCE,	/* bodies come nearer than their clearance */
	FIVECHECK_LIMIT,	/* an axis leaves its travel */
	FIVECHECK_START_OVERLAP	/* bodies overlap before anything moves */
};

enum fivecheck_kind fivecheck_finding_kind(const fivecheck_finding *finding);
const char *fivecheck_finding_file(const fivecheck_finding *finding);
long fivecheck_finding_line(const fivecheck_finding *finding);
/*
 * The calls that led into the subprogram in which the block stands: level 0 is the call of that subprogram, 1 the call
 * of the one that called it, and so on. False, and untouched: there are not so many.
 */
bool fivecheck_finding_caller(const fivecheck_finding *finding, size_t level, const char **file, long *line);
/* The NC block as it stands in the file. */
const char *fivecheck_finding_block(const fivecheck_finding *finding);
/* Where in the block's motion, by time: 0 to 1. */
double fivecheck_finding_fraction(const fivecheck_finding *finding);
/* Seconds since the program began. */
double fivecheck_finding_time(const fivecheck_finding *finding);
/* Tool in the spindle; 0: none. */
int fivecheck_finding_tool(const fivecheck_finding *finding);
/* Where the axis with this letter (one of XYZABCUVW) stands; 0 if the machine has none. */
double fivecheck_finding_axis(const fivecheck_finding *finding, char letter);
/* Names of the two bodies; NULL for a limit. */
const char *fivecheck_finding_body_a(const fivecheck_finding *finding);
const char *fivecheck_finding_body_b(const fivecheck_finding *finding);
/* A point where they meet or are nearest. False, and untouched, for a limit. */
bool fivecheck_finding_point(const fivecheck_finding *finding, double point[3]);
/* Distance of the two bodies, and the one that is required; 0 for a limit. */
double fivecheck_finding_distance(const fivecheck_finding *finding);
double fivecheck_finding_required(const fivecheck_finding *finding);
/* The axis whose limit is passed, and the limit. 0 for all but a limit. */
char fivecheck_finding_limit_axis(const fivecheck_finding *finding);
double fivecheck_finding_limit(const fivecheck_finding *finding);

/* The check. */

typedef struct check_block fivecheck_block;
typedef struct check_stats fivecheck_statistics;

/*
 * Callbacks; each may be NULL. `finding` and `block` are called in the thread that called fivecheck_check, `progress`
 * in any thread, one call at a time.
 */
struct fivecheck_events {
	void *context;
	/* In the order of time. False: stop. NULL: go on as the options say. */
	bool (*finding)(void *context, const fivecheck_finding *finding);
	/*
	 * Several times in 0.1 s: how many lines have been checked. False: give up, which makes the result incomplete;
	 * what is under way has a second to come to its end, so that its findings can be reported.
	 */
	bool (*progress)(void *context, long lines);
	/* Each block that was checked, in order, if the options measure blocks (the command line's reports do). */
	void (*block)(void *context, const fivecheck_block *block);
};

enum fivecheck_result {
	FIVECHECK_CLEAR,	/* everything was checked, and nothing was found */
	FIVECHECK_FOUND,	/* at least one finding */
	FIVECHECK_INCOMPLETE	/* an error was reported: not everything was checked. Never take it for clear */
};

/*
 * Checks one program on a prepared model. `in` is read from where it stands and stays the caller's. That of a pipe, a
 * socket or a terminal is read through its descriptor, and each line is checked when it comes; unless the library was
 * built with glibc, nothing may have been read from such a stream before. `name` stands in messages, and subprograms
 * are looked for in its folder. Statistics, unless NULL, are filled in whatever the result.
 * proven, unless NULL, receives for each pair of the model (fivecheck_pair_count) the least distance that was proven
 * over the program, INFINITY if the pair was never looked at; this takes time.
 */
enum fivecheck_result fivecheck_check(fivecheck_model *model, const fivecheck_options *options, FILE *in,
				      const char *name, const struct fivecheck_events *events, fivecheck_diag *diag,
				      fivecheck_statistics *statistics, double *proven);

/* The same for a file of this name. */
enum fivecheck_result fivecheck_check_file(fivecheck_model *model, const fivecheck_options *options, const char *path,
					   const struct fivecheck_events *events, fivecheck_diag *diag,
					   fivecheck_statistics *statistics, double *proven);

/* All pairs of bodies of a prepared model; 0 before. */
size_t fivecheck_pair_count(const fivecheck_model *model);
/* Names of the bodies of a pair below the count. True: it is checked; false: it need not be, for this reason. */
bool fivecheck_pair(const fivecheck_model *model, size_t pair, const char **a, const char **b, const char **reason);

fivecheck_statistics *fivecheck_statistics_new(void);
void fivecheck_statistics_free(fivecheck_statistics *statistics);
long fivecheck_statistics_blocks(const fivecheck_statistics *statistics);	/* that were checked */
long fivecheck_statistics_findings(const fivecheck_statistics *statistics);
double fivecheck_statistics_motion_time(const fivecheck_statistics *statistics);	/* s that the program takes */

#ifdef __cplusplus
}
#endif

#endif
