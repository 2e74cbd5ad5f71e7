/*
 * session.h - keeps a machine loaded between command lines: for a program that is checked again while it is being
 * written, and for axes that are moved by hand. The page of the checker uses it (src/wasi/page.c).
 */
#ifndef FIVECHECK_CLI_SESSION_H
#define FIVECHECK_CLI_SESSION_H

#include "cli/run_status.h"

struct session;

/* Call it before any other use of the checker in this process. */
struct session *session_new(void);
/* Accepts NULL. */
void session_free(struct session *session);

/*
 * Runs a command line that checks programs, with the same output as main. The first one loads the machine, and each one
 * with another machine file, setup or clearance loads it again. Loaded files are assumed to be unchanged, and their
 * digests are kept: begin a new session after a change of a file of the machine or the setup, or of --input-root.
 * argv[0] is ignored.
 */
enum run_status session_check(struct session *session, int argc, char **argv);

/*
 * Prints the distances of the bodies (report/pose_json.h) at a pose. The arguments from argv[1] on give axis positions,
 * like "X=12.5" (mm, degrees), and the tool in the spindle, like "T=3"; the other axes are at home. Call it after a
 * check has loaded a machine. RUN_FOUND: bodies meet, or are within their clearance.
 */
enum run_status session_pose(struct session *session, int argc, char **argv);

#endif
