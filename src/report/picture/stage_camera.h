/* stage_camera.h - chooses a viewing direction that shows the contact. */
#ifndef FIVECHECK_REPORT_PICTURE_STAGE_CAMERA_H
#define FIVECHECK_REPORT_PICTURE_STAGE_CAMERA_H

#include "report/picture/stage.h"

/* The usual viewing direction, from the front, right and above; neither centre nor scale. */
struct camera camera_usual(void);

/* The camera that shows the contact best, or all bodies. */
struct camera stage_camera(const struct stage *stage);

#endif
