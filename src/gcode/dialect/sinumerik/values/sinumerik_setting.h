/* sinumerik_setting.h - a program writes outputs, settings, machine data, and data of tools. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_SETTING_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_SETTING_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * Reads the rest of "$SC_CONTPREC=0.01" after the name. A setting that changes no path has no effect; data of tools
 * must be equal to those of the setup. False: reported.
 */
bool sinumerik_setting_write(struct interp *interp, struct lexer *lexer, const char *name, int column);

#endif
