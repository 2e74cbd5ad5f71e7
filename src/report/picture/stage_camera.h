/* stage_camera.h - where to look from, so that the contact is seen. */
#ifndef FIVECHECK_REPORT_PICTURE_STAGE_CAMERA_H
#define FIVECHECK_REPORT_PICTURE_STAGE_CAMERA_H

#include "report/picture/stage.h"

/* The usual direction of sight, from the front, right and above; neither centre nor scale. */
struct camera camera_usual(void);

/* A camera that sees the contact as well as can be, or all bodies. */
struct camera stage_camera(const struct stage *stage);

#endif
