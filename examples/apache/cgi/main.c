/*
 * main.c - checks an upload on the server: the body of a POST is a tar archive with the files of a job, and the query
 * names them.
 *
 *     tar --format=ustar -cf - machine.xml stl part.nc | curl --data-binary @- \
 *         -H 'Content-Type: application/x-tar' 'http://127.0.0.1/fivecheck/check?machine=machine.xml&program=part.nc'
 *
 * Query: machine, program (up to 8), setup, clearance, dialect, all=1, format=text or ndjson. The answer is what
 * fivecheck prints, messages included; the header Fivecheck-Status is its exit status.
 *
 * Nothing of an upload is trusted (archive.h, job.h). fivecheck runs at most once per processor at a time. At most
 * UPLOADS_MAX uploads lie unpacked at a time; others wait before they are read. The folder of a job is always removed.
 *
 * Environment (SetEnv): FIVECHECK, the program; FIVECHECK_WORK, a folder that only this program can write to;
 * FIVECHECK_MB, the largest upload; FIVECHECK_SECONDS, processor time of a job.
 */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "archive.h"
#include "job.h"
#include "lock.h"
#include "query.h"
#include "request.h"
#include "time_limit.h"

#define DEFAULT_WORK "/var/lib/fivecheck"
#define DISCARDED_MAX (64L << 20) /* bytes */

enum {
	DEFAULT_MB = 64,
	DEFAULT_SECONDS = 60,	/* of the processor */
	WAIT_SECONDS = 60,	/* for the upload; for a free processor */
	UPLOADS_MAX = 32	/* that lie unpacked at a time */
};

static long number_of(const char *name, long otherwise, long most)
{
	const char *text = getenv(name);
	char *end;
	long value = text ? strtol(text, &end, 10) : 0;

	return text && *text && !*end && value > 0 && value <= most ? value : otherwise;
}

static void answer(const struct query *query, int status, int output, struct request *request)
{
	FILE *file = fdopen(output, "rb");
	char bytes[4096];
	size_t count;

	if (status < 0)
		request_refuse(request, "503 Service Unavailable",
			       "the job took more time or memory than is allowed here");
	if (!file || status == 127 || fseek(file, 0, SEEK_SET))
		request_refuse(request, "500 Internal Server Error", "fivecheck could not be started");
	printf("Content-Type: %s; charset=utf-8\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
	       "Fivecheck-Status: %d\r\n\r\n",
	       query->ndjson ? "application/x-ndjson" : "text/plain", status);
	while ((count = fread(bytes, 1, sizeof(bytes), file)) > 0)
		fwrite(bytes, 1, count, stdout);
	fclose(file);
}

/* The type of an upload, in any case, with or without parameters. */
static bool is_tar(const char *type)
{
	static const char tar[] = "application/x-tar";
	const size_t length = sizeof(tar) - 1;

	return !strncasecmp(type, tar, length) && (type[length] == '\0' || strchr("; ", type[length]));
}

/* Answers whatever is not an upload of an allowed size and type. */
static void check_request(struct request *request, long size, long most)
{
	const char *method = getenv("REQUEST_METHOD"), *type = getenv("CONTENT_TYPE");

	if (!method || strcmp(method, "POST") != 0)
		request_refuse(request, "405 Method Not Allowed", "send the files of a job as a tar archive with POST");
	if (!size)
		request_refuse(request, "411 Length Required", "the length of the upload must be known");
	if (size > most)
		request_refuse(request, "413 Content Too Large", "an upload may have %ld MB", most >> 20);
	if (!type || !is_tar(type) || getenv("HTTP_CONTENT_ENCODING"))
		request_refuse(request, "415 Unsupported Media Type",
			       "the upload must be a plain tar archive, application/x-tar");
}

static void check_upload(const struct query *query, struct request *request)
{
	const char *work = getenv("FIVECHECK_WORK") ? getenv("FIVECHECK_WORK") : DEFAULT_WORK;
	long seconds = number_of("FIVECHECK_SECONDS", DEFAULT_SECONDS, 86400);
	int room = lock_take(work, "room", UPLOADS_MAX, "there are too many uploads", request);
	int slot, output, status;

	request_make_folder(request, work);
	archive_unpack(request);
	time_limit_set(WAIT_SECONDS);
	slot = lock_take_processor(work, request);
	time_limit_set(0);
	output = open(".output", O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_APPEND, 0600);
	if (output < 0)
		request_refuse(request, "500 Internal Server Error", "the folder of the job was lost");
	status = job_run(query, seconds, output, request);
	/* A client that reads the answer slowly, or not at all, occupies no processor and no room. */
	close(slot);
	request_remove_folder(request);
	close(room);
	answer(query, status, output, request);
}

int main(void)
{
	long most = number_of("FIVECHECK_MB", DEFAULT_MB, 4096) << 20, size = number_of("CONTENT_LENGTH", 0, 1L << 40);
	const char *text = getenv("QUERY_STRING");
	/* A refused body is read, too, up to a bound: a client that still sends may miss the answer. */
	struct request request = {.unread = size - most <= DISCARDED_MAX ? size : most + DISCARDED_MAX};
	struct query query = {0};
	char words[4096];

	umask(077);
	time_limit_init();
	time_limit_set(WAIT_SECONDS);
	check_request(&request, size, most);
	if (!text || strlen(text) >= sizeof(words))
		request_refuse(&request, "400 Bad Request", "the query is missing or too long");
	strcpy(words, text);
	query_read(&query, words, &request);
	check_upload(&query, &request);
	return EXIT_SUCCESS;
}
