/* mesh_reading.h - reads the meshes of many bodies, and builds their trees, with several threads. */
#ifndef FIVECHECK_SCENE_MESH_READING_H
#define FIVECHECK_SCENE_MESH_READING_H

#include "scene/scene.h"

/*
 * Reads the meshes of all bodies, whether or not a pair needs them, and builds their trees. Pieces of tools that are
 * given by sections are made later, when needed. False: some meshes are faulty; each is reported, in their order.
 */
bool mesh_reading_run(struct scene *scene, int threads, struct diag *diag);

#endif
