/* mtconnect_travel.h - travel and rate of an axis in a device description of MTConnect. */
#ifndef FIVECHECK_IMPORT_MTCONNECT_TRAVEL_H
#define FIVECHECK_IMPORT_MTCONNECT_TRAVEL_H

#include <stdbool.h>

#include "machine/description.h"
#include "machine/xml/xml_reader.h"

/*
 * Sets the limits (infinite if there is none) and the rate of `axis`, whose field rotary is set: from Specifications of
 * the types POSITION, ANGLE, VELOCITY and ANGULAR_VELOCITY, and from the Constraints of its position in machine
 * coordinates; of several travels the narrowest, of several rates the lowest. False: reported.
 */
bool mtconnect_travel(struct xml_reader *xml, const xmlNode *device, const xmlNode *component,
		      struct axis_description *axis);

#endif
