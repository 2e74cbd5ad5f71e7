#include "report/report.h"

#include "report/writers/github.h"
#include "report/writers/junit.h"
#include "report/writers/ndjson.h"
#include "report/writers/record.h"
#include "report/writers/sarif.h"
#include "report/writers/text.h"

const struct report_writer *const report_writers[FORMAT_COUNT] = {
	[FORMAT_TEXT] = &text_writer, [FORMAT_NDJSON] = &ndjson_writer, [FORMAT_JUNIT] = &junit_writer,
	[FORMAT_SARIF] = &sarif_writer, [FORMAT_GITHUB] = &github_writer,
	[FORMAT_RECORD] = &record_writer,
};
