/*
 * safe_path.h - names of files that a stranger sent.
 */
#ifndef CGI_SAFE_PATH_H
#define CGI_SAFE_PATH_H

#include <stdbool.h>

enum { PATH_LENGTH = 200 };

/* Is it a relative path that stays in its folder? No part of it begins with a dot or a dash. */
bool is_safe_path(const char *path);

#endif
