/*
 * query.h - the query of a request: which files of the upload are checked, and how.
 */
#ifndef CGI_QUERY_H
#define CGI_QUERY_H

#include <stdbool.h>

enum { NUMBER_LENGTH = 20, PROGRAMS_MAX = 8 };

struct request;

struct query {
	char *machine, *setup, *clearance, *dialect; /* NULL: not given, except for `machine` */
	char *programs[PROGRAMS_MAX];
	int program_count;
	bool all, ndjson;
};

/* Decodes `text` in place; the query points into it. Refuses the request if it is malformed. */
void query_read(struct query *query, char *text, struct request *request);

#endif
