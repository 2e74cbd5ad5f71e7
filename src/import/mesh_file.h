/* mesh_file.h - finds and reads the meshes that a file of another program refers to. */
#ifndef FIVECHECK_IMPORT_MESH_FILE_H
#define FIVECHECK_IMPORT_MESH_FILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "geom/mesh.h"

/*
 * Finds a mesh by a path from another computer, with / or \: below `folder` and below the folder of `file` (either may
 * be NULL), by the longest end of the path that exists, in upper or lower case. ".." is never followed. On success the
 * path is in *found.
 */
bool mesh_file_find(struct strbuf *found, const char *folder, const char *file, const char *written);

/* The formats that mesh_helper.h reads; determined by the content, except OBJ and glTF as text, by the name. */
enum mesh_format { MESH_OTHER, MESH_OBJ, MESH_PLY, MESH_3MF, MESH_GLTF };

enum mesh_format mesh_file_format(const char *path);

/*
 * Reads a file whose format has no units: STL, VERICUT-model, OBJ or PLY. All its parts become one mesh. `scale`: mm
 * per unit of the file. False: reported.
 */
bool mesh_file_read(struct mesh *out, const char *path, double scale, struct diag *diag);

#endif
