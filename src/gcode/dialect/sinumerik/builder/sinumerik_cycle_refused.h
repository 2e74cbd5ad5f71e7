/* sinumerik_cycle_refused.h - cycles of the control that are not read. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BUILDER_SINUMERIK_CYCLE_REFUSED_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BUILDER_SINUMERIK_CYCLE_REFUSED_H

/* A cycle of the control that is known and refused: what it does; NULL: it is none. */
const char *sinumerik_cycle_refused(const char *name);

#endif
