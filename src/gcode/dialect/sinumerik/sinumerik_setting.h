/* sinumerik_setting.h - outputs, settings, machine data and data of tools that a program writes. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SETTING_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SETTING_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * "$SC_CONTPREC=0.01" behind its name. What changes no path is read and forgotten; data of tools must be those of the
 * setup. False: reported.
 */
bool sinumerik_setting_write(struct interp *interp, struct lexer *lexer, const char *name, int column);

#endif
