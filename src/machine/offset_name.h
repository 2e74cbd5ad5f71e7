/* offset_name.h - the names of work offsets in setups, and the one name of each that programs are read with. */
#ifndef FIVECHECK_MACHINE_OFFSET_NAME_H
#define FIVECHECK_MACHINE_OFFSET_NAME_H

#include <stdbool.h>

#define OFFSET_NAME_SIZE 16

/*
 * "G54" to "G59.3", "G505" to "G599", "#0" to "#9999" as they are; "G54.1 P7" for "G54.1P7", "G54 P7", "G154 P7" and
 * "G116" (G110 to G129 are P1 to P20); "G54.4 P1" to "G54.4 P7". False: no work offset has this name.
 */
bool offset_name_read(const char *name, char read[OFFSET_NAME_SIZE]);

#endif
