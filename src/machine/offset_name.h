/* offset_name.h - the names of work offsets in setups, and the spelling of each in programs as they are read. */
#ifndef FIVECHECK_MACHINE_OFFSET_NAME_H
#define FIVECHECK_MACHINE_OFFSET_NAME_H

#include <stdbool.h>

#define OFFSET_NAME_SIZE 16

/*
 * Leaves "G54" to "G59.3", "G505" to "G599" and "#0" to "#9999" as they are; gives "G54.1 P7" for "G54.1P7", "G54 P7",
 * "G154 P7" and "G116" (G110 to G129 are P1 to P20), and "G54.4 P1" to "G54.4 P7". False: it is not the name of a work
 * offset.
 */
bool offset_name_read(const char *name, char read[OFFSET_NAME_SIZE]);

#endif
