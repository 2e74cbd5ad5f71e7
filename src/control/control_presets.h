/* control_presets.h - answers from the manuals of one generation of controls, independent of its parameters. */
#ifndef FIVECHECK_CONTROL_CONTROL_PRESETS_H
#define FIVECHECK_CONTROL_CONTROL_PRESETS_H

#include "control/controller.h"

/* A value of 0 leaves the question to the machine file. */
struct control_preset {
	const char *name;	/* as in preset="" */
	const char *source;	/* the manual that gives the answers */
	enum g53_with_g91 g53_with_g91;
	enum comp_corner_form comp_corner;
	enum power_on_distance power_on_distance;
	enum power_on_plane power_on_plane;
};

/* Each list ends with a row without a name. */
extern const struct control_preset presets_of_parameters[], presets_of_settings[];

/* The preset of a control with this name; NULL: there is none. */
const struct control_preset *control_preset_find(const struct control_preset *presets, const char *name);

/* The names of a control's presets, for messages: "a, b or c". */
void control_preset_names(const struct control_preset *presets, char *text, size_t size);

/* Answers the questions that are still open. */
void control_preset_apply(const struct control_preset *preset, struct controller *controller);

#endif
