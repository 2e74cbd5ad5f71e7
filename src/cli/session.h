/*
 * session.h - a machine that stays loaded between command lines: for a program that is checked again while it is being
 * written, and for axes that are moved by hand. The page of the checker uses it (src/wasi/page.c).
 */
#ifndef FIVECHECK_CLI_SESSION_H
#define FIVECHECK_CLI_SESSION_H

#include "cli/run_status.h"

struct session;

/* Before any other use of the checker in this process. */
struct session *session_new(void);
/* NULL is fine. */
void session_free(struct session *session);

/*
 * Runs a command line that checks programs; it prints what main would print. The machine is loaded by the first one,
 * and again where another one names another machine file, setup or clearance. What was loaded is believed, and its
 * digests are kept: who changes a file of the machine or the setup, or --input-root, begins a new session. argv[0] is
 * not looked at.
 */
enum run_status session_check(struct session *session, int argc, char **argv);

/*
 * Prints how near the bodies are (report/pose_json.h) while the axes stand where the words from argv[1] on say, as
 * "X=12.5" (mm, degrees), with the tool of "T=3" in the spindle; the others stand at home. To be called after a check
 * has loaded a machine. RUN_FOUND: bodies meet, or are nearer than their clearance.
 */
enum run_status session_pose(struct session *session, int argc, char **argv);

#endif
