#include "safe_path.h"

#include <string.h>

bool is_safe_path(const char *path)
{
	if (!*path || strlen(path) > PATH_LENGTH || strpbrk(path, "\\:"))
		return false;
	for (const char *part = path;;) {
		size_t length = strcspn(part, "/");

		if (length == 0 || *part == '-' || *part == '.')
			return false;
		for (size_t i = 0; i < length; i++) {
			if ((unsigned char)part[i] < 32 || part[i] == 127)
				return false;
		}
		if (!part[length])
			return true;
		part += length + 1;
	}
}
