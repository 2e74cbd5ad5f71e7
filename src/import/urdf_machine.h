/* urdf_machine.h - reads a machine from URDF, the robot description of ROS: links, joints, meshes. */
#ifndef FIVECHECK_IMPORT_URDF_MACHINE_H
#define FIVECHECK_IMPORT_URDF_MACHINE_H

#include <stdbool.h>

#include "import/import.h"

/*
 * Joints that move become axes; the letter of an axis is a separate word in the name of its joint ("X", "joint_x",
 * "a-axis"). The bodies are the collision shapes of the links; a link without any has its visual shapes. Tools are
 * mounted on a link named spindle, tool or tool0, along its +Z; the work on a link named work, workholding, attach,
 * fixture or part. Lengths in the file are metres. False, reported: the file is faulty, or a joint is of a kind that no
 * machine has.
 */
bool urdf_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
		       struct diag *diag);

#endif
