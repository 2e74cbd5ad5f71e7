#include "check/finding.h"

const char *finding_kind_name(enum finding_kind kind)
{
	static const char *const names[] = {"collision", "clearance", "limit", "start-overlap"};

	return names[kind];
}
