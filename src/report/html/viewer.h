/* viewer.h - the viewer that a report contains: src/web as scripts/bundle-web joined it when the program was built. */
#ifndef FIVECHECK_REPORT_HTML_VIEWER_H
#define FIVECHECK_REPORT_HTML_VIEWER_H

#include <stddef.h>

struct viewer_file {
	const char *bytes;	/* UTF-8, not terminated */
	size_t count;
};

struct viewer_file viewer_script(void);
/* The script that inflates the viewer and runs it. */
struct viewer_file viewer_boot_script(void);
struct viewer_file viewer_style(void);

#endif
