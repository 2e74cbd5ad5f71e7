/* pose.h - writes all bodies at one instant as one STL file (--pose). */
#ifndef FIVECHECK_REPORT_POSE_H
#define FIVECHECK_REPORT_POSE_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/diag.h"
#include "scene/scene.h"

/*
 * Writes a binary STL in mm and machine coordinates: the machine, the fixtures, the part, the blank without any cuts,
 * and the tool in the spindle (0: none). False, reported: the file is not changed.
 */
bool pose_write(const char *path, struct scene *scene, const axis_values *axes, int tool, struct diag *diag);

#endif
