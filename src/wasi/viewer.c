/*
 * viewer.c - replaces src/report/html/viewer.c: the script of the viewer is a file of the run, which the host provides
 * (src/web/app/fivecheck.js). A page that shows the machine without a report need not load it.
 */
#include "report/html/viewer.h"

#include <stdio.h>
#include <stdlib.h>

#include "report/html/viewer_files.h"

#define SCRIPT "/tmp/fivecheck/viewer.js"

/*
 * The status of a run without the script; fivecheck(1) has no such status. STATUS.LACKING of src/web/app/fivecheck.js.
 */
enum { STATUS_LACKING = 4 };

struct viewer_file viewer_script(void)
{
	/* Read again for each report, so that it takes no space in the module. */
	static char script[1 << 18];
	FILE *file = fopen(SCRIPT, "rb");
	size_t count = file ? fread(script, 1, sizeof(script), file) : 0;

	if (file)
		fclose(file);
	if (!count || count == sizeof(script))
		exit(STATUS_LACKING);
	return (struct viewer_file){script, count};
}

/* Each array has one byte more than the file. */
struct viewer_file viewer_boot_script(void)
{
	return (struct viewer_file){(const char *)viewer_boot, sizeof(viewer_boot) - 1};
}

struct viewer_file viewer_style(void)
{
	return (struct viewer_file){(const char *)viewer_css, sizeof(viewer_css) - 1};
}
