/*
 * archive.h - unpacks the body of a request, a plain tar archive, into the folder of the job (the present folder).
 *
 * Files are never larger unpacked than they were sent. Links are refused, and no name leads out of the folder. Files
 * and folders together are at most FILES_MAX.
 */
#ifndef CGI_ARCHIVE_H
#define CGI_ARCHIVE_H

struct request;

/* Reads the whole body; refuses the request if the archive has something that is not allowed. */
void archive_unpack(struct request *request);

#endif
