#include "control/control_variable.h"

#include <string.h>

#include "base/ascii.h"

bool control_variable_name_normalise(const char *given, char name[CONTROL_VARIABLE_NAME])
{
	char made[CONTROL_VARIABLE_NAME];
	size_t length = 0;

	for (; *given; given++) {
		if (*given == ' ' || *given == '\t')
			continue;
		if (length == CONTROL_VARIABLE_NAME - 1)
			return false;
		made[length++] = ascii_upper(*given);
	}
	made[length] = '\0';
	if (length > 0)
		memcpy(name, made, length + 1);
	return length > 0;
}

const struct control_variable *control_variable_find(const struct controller *controller, const char *name)
{
	for (size_t i = 0; i < controller->variable_count; i++) {
		if (!strcmp(controller->variables[i].name, name))
			return &controller->variables[i];
	}
	return NULL;
}
