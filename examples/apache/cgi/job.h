/*
 * job.h - runs fivecheck on the files of a request, with limits of time, memory, output and processes. It sees only the
 * folder of the job (--input-root).
 */
#ifndef CGI_JOB_H
#define CGI_JOB_H

struct query;
struct request;

/*
 * What fivecheck prints goes to the file `output`. Returns its exit status, or -1 if it was killed. `seconds` is
 * processor time.
 */
int job_run(const struct query *query, long seconds, int output, struct request *request);

#endif
