/* read_on.h - after a fault: reads a program on, to report its other faults in the same run (all_faults). */
#ifndef FIVECHECK_GCODE_READ_ON_H
#define FIVECHECK_GCODE_READ_ON_H

#include <stdbool.h>
#include <stddef.h>

struct interp;

/*
 * After a fault, the next word or block is where the program can be understood again. Where the axes are is not known
 * from there on, so that nobody hears of moves any more. False: no fault was reported since, or the run ends with it.
 */
bool read_on(struct interp *interp, size_t errors_before);

/*
 * Of a block that was not carried out: the axes that it would have moved are lost (interp.lost) until an absolute
 * coordinate leads them on. Faults that follow from this alone, such as the radius of an arc, are not reported. The
 * modes of the block hold all the same.
 */
void read_on_lose(struct interp *interp);

/*
 * Reports that the setup lacks something. True: the block is carried out all the same, as if the setup had it, so that
 * no other fault follows from this one.
 */
#define read_on_without(interp, ...) (fault_report(&(interp)->at, __VA_ARGS__), read_on(interp, 0))

#endif
