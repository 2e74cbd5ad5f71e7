#include "machine/body.h"

#include <string.h>

#include "base/axes.h"

const char *const body_roles[] = {
	[ROLE_MACHINE] = "",	 [ROLE_FIXTURE] = "fixture", [ROLE_PART] = "part",
	[ROLE_STOCK] = "stock",	 [ROLE_HOLDER] = "holder", [ROLE_SHANK] = "shank",
	[ROLE_CUTTER] = "cutter", NULL,
};

bool body_name_is_reserved(const char *name)
{
	if (name[0] && !name[1] && slot_of_letter(name[0]) >= 0)
		return true;
	for (int role = ROLE_FIXTURE; body_roles[role]; role++)
		if (strcmp(name, body_roles[role]) == 0)
			return true;
	return strcmp(name, "base") == 0;
}
