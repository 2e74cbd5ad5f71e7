/* json_file.h - loads a JSON file of another program. */
#ifndef FIVECHECK_MACHINE_LIBRARY_JSON_FILE_H
#define FIVECHECK_MACHINE_LIBRARY_JSON_FILE_H

#include <jansson.h>

#include "base/diag.h"

/* The root of the file; the caller drops it with json_decref. NULL, reported: it cannot be read, or is no valid JSON. */
json_t *json_file_read(const char *path, struct diag *diag);

#endif
