#include "cli/options.h"

#include <stdlib.h>
#include <string.h>

void options_list_outputs(struct options *options, struct output_option list[OUTPUT_OPTIONS])
{
	const struct output_option others[] = {
		{"depfile", &options->depfile},
		{"clearance-report", &options->clearance_report},
		{"timing", &options->timing},
		{"report", &options->report},
		{"glb", &options->glb},
		{"picture", &options->picture},
		{"pose", &options->pose},
		{"stock-out", &options->stock_out},
	};

	_Static_assert(1 + FORMAT_COUNT + sizeof(others) / sizeof(*others) == OUTPUT_OPTIONS, "all are listed");
	*list++ = (struct output_option){options->output_of_format ? "format" : "output", &options->output};
	for (int i = 0; i < FORMAT_COUNT; i++)
		*list++ = (struct output_option){i == FORMAT_RECORD ? "record" : "format", &options->formats[i].path};
	memcpy(list, others, sizeof(others));
}

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
