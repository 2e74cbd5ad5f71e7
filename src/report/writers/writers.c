#include "report/writers/writers.h"

#define WRITER_ADDRESS(upper, lower) [FORMAT_##upper] = &lower##_writer,
const struct report_writer *const report_writers[FORMAT_COUNT] = {WRITERS(WRITER_ADDRESS)
								      RECORD_WRITERS(WRITER_ADDRESS)};

#define WRITER_NAME(upper, lower) #lower,
const char *const writer_names[] = {WRITERS(WRITER_NAME) "json", NULL};
