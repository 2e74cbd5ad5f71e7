/* diag_tee.h - passes diagnostics on and keeps a copy of the errors. */
#ifndef FIVECHECK_CLI_DIAG_TEE_H
#define FIVECHECK_CLI_DIAG_TEE_H

#include "base/diag.h"
#include "cli/error_list.h"

/* Report to `diag`: every diagnostic goes to `out`, and error_list_add keeps the errors. */
struct diag_tee {
	struct diag diag;
	struct diag *out;	/* borrowed */
	struct error_list errors;
};

/* Do not move the tee afterwards: its diag points back to it. */
void diag_tee_init(struct diag_tee *tee, struct diag *out);
void diag_tee_release(struct diag_tee *tee);

#endif
