#include "control/control_presets.h"

#include <stdio.h>
#include <string.h>

/*
 * "Machine Coordinate System (G53)": in G91 the command is ignored. "Cutter Compensation", offset mode: outside
 * corners are drawn out; on the later generations a parameter (19607#2, CCC) decides.
 */
const struct control_preset presets_of_parameters[] = {
	{.name = "16i",
	 .source = "B-63534EN",
	 .g53_with_g91 = G53_WITH_G91_INCREMENTAL,
	 .comp_corner = COMP_CORNER_LINEAR},
	{.name = "0i-MB",
	 .source = "B-63844EN",
	 .g53_with_g91 = G53_WITH_G91_INCREMENTAL,
	 .comp_corner = COMP_CORNER_LINEAR},
	{.name = "0i-D", .source = "B-64304EN", .g53_with_g91 = G53_WITH_G91_INCREMENTAL},
	{.name = "0i-F", .source = "B-64604EN", .g53_with_g91 = G53_WITH_G91_INCREMENTAL},
	{.name = "30i-B", .source = "B-64484EN", .g53_with_g91 = G53_WITH_G91_INCREMENTAL},
	{.name = NULL},
};

/* "G-codes": those that are active at power-on, among them G17 and G90. */
const struct control_preset presets_of_settings[] = {
	{.name = "classic",
	 .source = "mill operator's manual 96-8000",
	 .power_on_distance = POWER_ON_ABSOLUTE,
	 .power_on_plane = POWER_ON_XY},
	{.name = "ngc",
	 .source = "mill operator's manual 96-8210",
	 .power_on_distance = POWER_ON_ABSOLUTE,
	 .power_on_plane = POWER_ON_XY},
	{.name = NULL},
};

const struct control_preset *control_preset_find(const struct control_preset *presets, const char *name)
{
	for (; presets && presets->name; presets++) {
		if (!strcmp(presets->name, name))
			return presets;
	}
	return NULL;
}

void control_preset_names(const struct control_preset *presets, char *text, size_t size)
{
	size_t length = 0;

	text[0] = '\0';
	for (const struct control_preset *preset = presets; preset->name && length < size; preset++) {
		const char *before = preset == presets ? "" : preset[1].name ? ", " : " or ";

		length += (size_t)snprintf(text + length, size - length, "%s%s", before, preset->name);
	}
}

void control_preset_apply(const struct control_preset *preset, struct controller *controller)
{
	if (!controller->g53_with_g91)
		controller->g53_with_g91 = preset->g53_with_g91;
	if (!controller->comp_corner)
		controller->comp_corner = preset->comp_corner;
	if (!controller->power_on_distance)
		controller->power_on_distance = preset->power_on_distance;
	if (!controller->power_on_plane)
		controller->power_on_plane = preset->power_on_plane;
}
