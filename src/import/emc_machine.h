/*
 * emc_machine.h - reads the ini file of a machine with LinuxCNC (formerly EMC): axes, travels, rates, and its
 * kinematics module.
 */
#ifndef FIVECHECK_IMPORT_EMC_MACHINE_H
#define FIVECHECK_IMPORT_EMC_MACHINE_H

#include <stdbool.h>

#include "import/import.h"

/*
 * xyzac-trt-kins, xyzbc-trt-kins, xyzab_tdr_kins, xyzacb_trsrn, xyzbca_trsrn, 5axiskins and maxkins define the places
 * of their rotary axes by parameters from HAL; the formulas are those of the modules. Other kinematics do not define
 * the chain: then options->table gives the axes that carry the work, from the base on, and all others carry the tool,
 * in the order of options->head if it is given. An ini file has no bodies. Missing data is noted as a TODO. False:
 * reported.
 */
bool emc_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
		      struct diag *diag);

#endif
