/*
 * request.h - one request: the bytes of its body, the folder of its job, and the answer that refuses it.
 */
#ifndef CGI_REQUEST_H
#define CGI_REQUEST_H

#include <stdbool.h>
#include <stddef.h>

struct request {
	long unread; /* bytes of the body */
	char folder[512]; /* of the job; empty: there is none */
};

/* Makes the folder of the job in the folder `work`, and enters it. */
void request_make_folder(struct request *request, const char *work);
void request_remove_folder(struct request *request);

/* False: the body has ended, or time is up. */
bool request_read(struct request *request, char *to, size_t count);
/* Reads the rest of the body and discards it. */
void request_discard(struct request *request);

/* Answers with a status of HTTP and a message, leaves no folder behind, and exits. */
_Noreturn void request_refuse(struct request *request, const char *status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
