#include "report/html/viewer.h"

#include "report/html/viewer_files.h"

/* Each array has one byte more than the file. */
#define FILE_OF(array) ((struct viewer_file){(const char *)(array), sizeof(array) - 1})

struct viewer_file viewer_script(void)
{
	return FILE_OF(viewer_js);
}

struct viewer_file viewer_boot_script(void)
{
	return FILE_OF(viewer_boot);
}

struct viewer_file viewer_style(void)
{
	return FILE_OF(viewer_css);
}
