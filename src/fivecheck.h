/*
 * fivecheck.h - fivecheck as a library: load a machine and a setup, check NC programs, receive the findings.
 *
 * The command line itself loads and checks through this header. Compile and link with
 * `pkg-config --cflags --libs fivecheck`. The library is a static archive whose only global symbols are those declared
 * here. These symbols stay stable from one version to the next; nothing else of the library does.
 *
 * Units: lengths in mm, angles in radians, times in seconds. Positions are in machine coordinates. Strings are UTF-8,
 * or the bytes of the file, and end in 0.
 * Errors: a function that can fail returns false or NULL, leaves its outputs unchanged, and reports the error to its
 * fivecheck_diag. Out of memory ends the process with status 3 and a message.
 * Ownership: each ..._new and ..._load needs its matching ..._free, which accepts NULL. Paths and other arguments are
 * borrowed for the call, unless the function says otherwise. The arguments of a callback are valid until it returns.
 * Threads: there is no global state. Different threads may use different objects at once. Several threads may check one
 * model at once, each with its own diag, after the model was prepared and while nobody changes it.
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

/* Calls `handle`, unless it is NULL, immediately for every message, in the thread that reports it. */
fivecheck_diag *fivecheck_diag_new(void (*handle)(void *context, const fivecheck_message *message), void *context);
void fivecheck_diag_free(fivecheck_diag *diag);
/* The number of errors so far. */
size_t fivecheck_diag_errors(const fivecheck_diag *diag);

enum fivecheck_severity fivecheck_message_severity(const fivecheck_message *message);
const char *fivecheck_message_file(const fivecheck_message *message);	/* NULL: the message is about no file */
long fivecheck_message_line(const fivecheck_message *message);	/* from 1; 0: not known */
int fivecheck_message_column(const fivecheck_message *message);	/* in bytes, from 1; 0: not known */
const char *fivecheck_message_text(const fivecheck_message *message);	/* one line, without a final newline */

/* A model: a machine and the setup on it. */

typedef struct model fivecheck_model;

/* Reads a machine file and, unless it is NULL, a setup file, which replaces a setup inside the machine file. */
fivecheck_model *fivecheck_load(const char *machine, const char *setup, fivecheck_diag *diag);
void fivecheck_free(fivecheck_model *model);

/* The dialect of the programs, instead of that of the machine file: "linuxcnc", "fanuc", "haas", ... */
bool fivecheck_set_dialect(fivecheck_model *model, const char *name, fivecheck_diag *diag);

/* 1 to 1024: the number of threads for fivecheck_prepare; one by default. False: out of range. */
bool fivecheck_set_threads(fivecheck_model *model, int threads);

/*
 * Reads the meshes and derives which pairs of bodies must be kept apart: by `clearance` (0 or more), unless the machine
 * file gives another one. Call it once for a model, before programs are checked on it.
 */
bool fivecheck_prepare(fivecheck_model *model, double clearance, fivecheck_diag *diag);

/* How a program is checked. The same options serve several programs, and several threads while nobody changes them. */

typedef struct check_options fivecheck_options;

/* Unless set otherwise: the proof in continuous time, up to the first finding, with one thread. */
#define FIVECHECK_TOLERANCE 0.001
fivecheck_options *fivecheck_options_new(void);
void fivecheck_options_free(fivecheck_options *options);
/* mm, 1e-6 to 100: bodies nearer than their clearance and this may count as a finding. False: out of range. */
bool fivecheck_options_set_tolerance(fivecheck_options *options, double tolerance);
/* 1 to 1024. The result does not depend on it. False: out of range. */
bool fivecheck_options_set_threads(fivecheck_options *options, int threads);
/* Continues after the first finding: reports the first one of each block and pair. */
void fivecheck_options_set_all(fivecheck_options *options, bool all);
/* Interprets the program and checks only the axis limits; the model need not be prepared. */
void fivecheck_options_set_parse_only(fivecheck_options *options, bool parse_only);
/* Skips blocks that begin with a slash. */
void fivecheck_options_set_block_delete(fivecheck_options *options, bool block_delete);
/* Folders of subprogram files, searched after the program's own. The array is borrowed while the options are used. */
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
 * The calls that led into the subprogram of the block: level 0 is the call of this subprogram, 1 the call of its
 * caller, and so on. False: there is no such level; the outputs are unchanged.
 */
bool fivecheck_finding_caller(const fivecheck_finding *finding, size_t level, const char **file, long *line);
/* The text of the NC block. */
const char *fivecheck_finding_block(const fivecheck_finding *finding);
/* The place in the block's motion, by time: 0 to 1. */
double fivecheck_finding_fraction(const fivecheck_finding *finding);
/* Seconds since the program began. */
double fivecheck_finding_time(const fivecheck_finding *finding);
/* Tool in the spindle; 0: none. */
int fivecheck_finding_tool(const fivecheck_finding *finding);
/* The position of the axis with this letter (one of XYZABCUVW); 0 if the machine has no such axis. */
double fivecheck_finding_axis(const fivecheck_finding *finding, char letter);
/* Names of the two bodies; NULL for a limit. */
const char *fivecheck_finding_body_a(const fivecheck_finding *finding);
const char *fivecheck_finding_body_b(const fivecheck_finding *finding);
/* A point where the bodies meet or are nearest. False for a limit; the output is unchanged. */
bool fivecheck_finding_point(const fivecheck_finding *finding, double point[3]);
/* The distance of the two bodies, and the required distance; 0 for a limit. */
double fivecheck_finding_distance(const fivecheck_finding *finding);
double fivecheck_finding_required(const fivecheck_finding *finding);
/* The axis that passes its limit, and the limit. 0 for all other kinds. */
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
	/* Findings come in the order of time. False: stop. NULL: continue as the options say. */
	bool (*finding)(void *context, const fivecheck_finding *finding);
	/*
	 * Called several times in 0.1 s with the number of lines checked so far. False: give up; the result is
	 * incomplete. Running work has one second to finish, so that its findings can be reported.
	 */
	bool (*progress)(void *context, long lines);
	/*
	 * Called for each checked block, in order, if the options measure blocks (the reports of the command line do).
	 */
	void (*block)(void *context, const fivecheck_block *block);
};

enum fivecheck_result {
	FIVECHECK_CLEAR,	/* everything was checked, and nothing was found */
	FIVECHECK_FOUND,	/* at least one finding */
	FIVECHECK_INCOMPLETE	/* an error was reported: not everything was checked. Never take it for clear */
};

/*
 * Checks one program on a prepared model. `in` is read from its current position and stays the caller's. A pipe, a
 * socket or a terminal is read through its descriptor, and each line is checked as soon as it arrives; unless the
 * library was built with glibc, nothing may have been read from such a stream before. `name` appears in messages, and
 * subprograms are searched in its folder. `statistics`, unless NULL, is always filled in.
 * `proven`, unless NULL, receives for each pair of the model (fivecheck_pair_count) the smallest distance that was
 * proven during the program, INFINITY if the pair was never examined; this takes more time.
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
/* The names of a pair's bodies. True: the pair is checked. False: it need not be checked, for this reason. */
bool fivecheck_pair(const fivecheck_model *model, size_t pair, const char **a, const char **b, const char **reason);

fivecheck_statistics *fivecheck_statistics_new(void);
void fivecheck_statistics_free(fivecheck_statistics *statistics);
long fivecheck_statistics_blocks(const fivecheck_statistics *statistics);	/* checked blocks */
long fivecheck_statistics_findings(const fivecheck_statistics *statistics);
double fivecheck_statistics_motion_time(const fivecheck_statistics *statistics);	/* duration of the program, s */

#ifdef __cplusplus
}
#endif

#endif
