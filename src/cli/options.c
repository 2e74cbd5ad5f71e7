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

bool options_want_digests(const struct options *options)
{
	return options->record || options->report || options->formats[FORMAT_NDJSON].wanted;
}

bool options_want_visual(const struct options *options)
{
	return options->report || options->glb || options->picture;
}

void options_release(struct options *options)
{
	free(options->programs);
	free(options->list);
	free(options->includes.items);
	*options = (struct options){0};
}
