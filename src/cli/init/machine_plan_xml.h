/* machine_plan_xml.h - the commented machine file that `fivecheck init` writes. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_XML_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_XML_H

#include "base/strbuf.h"
#include "cli/init/machine_plan.h"

/* The plan has to be finished. */
void machine_plan_xml_write(struct strbuf *out, const struct machine_plan *plan);

/* One line: what carries what, from the base to the spindle and to the workholding. */
void machine_plan_xml_chains(struct strbuf *out, const struct machine_plan *plan);

#endif
