/* json_file.h - loads a JSON file of another program. */
#ifndef FIVECHECK_MACHINE_LIBRARY_JSON_FILE_H
#define FIVECHECK_MACHINE_LIBRARY_JSON_FILE_H

#include <jansson.h>
#include <stdbool.h>

#include "base/diag.h"

/*
 * The root of the file; the caller releases it with json_decref. NULL, reported: the file cannot be read or is not
 * JSON.
 */
json_t *json_file_read(const char *path, struct diag *diag);

/* A number that may be missing or null; then *value is not changed. False: the value is not a finite number. */
bool json_file_number(const json_t *object, const char *name, double *value);

#endif
