#include "report/report.h"

#include "report/github.h"
#include "report/junit.h"
#include "report/ndjson.h"
#include "report/record.h"
#include "report/sarif.h"
#include "report/text.h"

const struct report_writer *const report_writers[FORMAT_COUNT] = {
	[FORMAT_TEXT] = &text_writer, [FORMAT_NDJSON] = &ndjson_writer, [FORMAT_JUNIT] = &junit_writer,
	[FORMAT_SARIF] = &sarif_writer, [FORMAT_GITHUB] = &github_writer,
	[FORMAT_RECORD] = &record_writer,
};
