/* machine_plan_xml.h - the commented machine file that `fivecheck init` writes. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_XML_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_XML_H

#include "base/strbuf.h"
#include "cli/init/machine_plan.h"

/* Appends the whole file. The plan must have been completed by machine_plan_finish. */
void machine_plan_xml_write(struct strbuf *out, const struct machine_plan *plan);

/* Appends one line with both chains: "base > Y > X > Z > spindle; base > A > C > workholding". */
void machine_plan_xml_chains(struct strbuf *out, const struct machine_plan *plan);

#endif
