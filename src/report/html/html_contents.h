/* html_contents.h - everything that the report of one program contains. */
#ifndef FIVECHECK_REPORT_HTML_HTML_CONTENTS_H
#define FIVECHECK_REPORT_HTML_HTML_CONTENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "report/html/recorder.h"
#include "report/html/scene_pack.h"
#include "report/html/stock_pack.h"
#include "report/report.h"

/* All pointers are borrowed. */
struct html_contents {
	const struct scene_pack *scene;
	const struct stock_pack *stock;
	const struct report_run *run;
	const struct report_program *program;
	struct recorder *recorder;	/* closed */
	const struct report_file *files;	/* that were read */
	size_t file_count;
	size_t budget;	/* bytes that the file may have, unless its indispensable parts need more */
	bool no_code;	/* leave the program's text out */
	const struct strbuf *picture;	/* an SVG element and a <figcaption>; or NULL */
};

#endif
