/* mesh_reading.h - reads the meshes of many bodies, and builds their trees, with several threads. */
#ifndef FIVECHECK_SCENE_MESH_READING_H
#define FIVECHECK_SCENE_MESH_READING_H

#include "scene/scene.h"

/*
 * Reads what scene_body_bvh would read for the bodies wanted[0..count), each of them once. What is wrong with a mesh
 * is reported in their order, once, and the body has failed.
 */
void mesh_reading_run(struct scene *scene, const int *wanted, size_t count, int threads, struct diag *diag);

#endif
