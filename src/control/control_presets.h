/* control_presets.h - what the manuals of one generation of controls answer, whatever its parameters are. */
#ifndef FIVECHECK_CONTROL_CONTROL_PRESETS_H
#define FIVECHECK_CONTROL_CONTROL_PRESETS_H

#include "control/controller.h"

/* A value of 0 is left to the machine file. */
struct control_preset {
	const char *name;	/* as it stands after preset= */
	const char *source;	/* the manual that says so */
	enum g53_with_g91 g53_with_g91;
	enum comp_corner_form comp_corner;
	enum power_on_distance power_on_distance;
	enum power_on_plane power_on_plane;
};

/* Each ends with a row that has no name. */
extern const struct control_preset presets_of_parameters[], presets_of_settings[];

/* The preset with this name among a control's; NULL: it has none, or no such. */
const struct control_preset *control_preset_find(const struct control_preset *presets, const char *name);

/* What a control's presets are called, for messages: "a, b or c". */
void control_preset_names(const struct control_preset *presets, char *text, size_t size);

/* Answers the questions that are open yet. */
void control_preset_apply(const struct control_preset *preset, struct controller *controller);

#endif
