/* read_on.h - continues to read a program after a fault, to report further faults in the same run (all_faults). */
#ifndef FIVECHECK_GCODE_READ_ON_H
#define FIVECHECK_GCODE_READ_ON_H

#include <stdbool.h>
#include <stddef.h>

struct interp;

/*
 * Call after a fault, where the next word or block can be read. The positions of the axes are not known from then on,
 * so no moves are sent to the sink any more. False: no fault was reported since `errors_before`, or the run ends with
 * the first fault.
 */
bool read_on(struct interp *interp, size_t errors_before);

/*
 * Call for a block that was not carried out: the positions of the axes that it would have moved are unknown
 * (interp.lost) until an absolute coordinate moves them. Faults that follow only from this, such as the radius of an
 * arc, are not reported. The block's modes are still applied.
 */
void read_on_lose(struct interp *interp);

/*
 * Reports that the setup lacks something. True: the block is carried out as if the setup had it, so that no other
 * fault follows from this one.
 */
#define read_on_without(interp, ...) (fault_report(&(interp)->at, __VA_ARGS__), read_on(interp, 0))

#endif
