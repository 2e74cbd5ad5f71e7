#include "cli/diag_tee.h"

static void pass_on(void *context, const struct diag_entry *entry)
{
	struct diag_tee *tee = context;

	error_list_add(&tee->errors, entry);
	diag_pass(tee->out, entry);
}

void diag_tee_init(struct diag_tee *tee, struct diag *out)
{
	*tee = (struct diag_tee){.diag = {.handle = pass_on, .context = tee}, .out = out};
}

void diag_tee_release(struct diag_tee *tee)
{
	error_list_release(&tee->errors);
}
