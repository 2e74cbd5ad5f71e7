#include "cli/options.h"

#include <stdlib.h>

bool options_want_sensitivity(const struct options *options)
{
	for (int i = 0; i < CHANGES; i++) {
		if (options->sensitivity[i] > 0)
			return true;
	}
	return false;
}

void options_release(struct options *options)
{
	free(options->programs);
	free(options->list);
	free(options->includes.items);
	*options = (struct options){0};
}
