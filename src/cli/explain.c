#include "cli/explain.h"

#include <string.h>

#include "base/spelling.h"
#include "cli/dialect_choice.h"
#include "control/dialects.h"
#include "gcode/code_list.h"
#include "gcode/dialect/dialects.h"
#include "report/topics.h"

static const struct srcloc nowhere;

static void refuse(const char *word, struct diag *diag)
{
	struct spelling nearest;
	struct strbuf names = {0};

	spelling_init(&nearest, word);
	for (int i = 0; i < TOPIC_COUNT; i++) {
		spelling_offer(&nearest, topic_names[i]);
		strbuf_addf(&names, "%s%s", i ? ", " : "", topic_names[i]);
	}
	if (nearest.best)
		diag_error(diag, nowhere, "--explain: '%s' is not known; did you mean %s?", word, nearest.best);
	else
		diag_error(diag, nowhere,
			   "--explain: '%s' is neither a code of a dialect ('codes' lists them) nor one of %s", word,
			   strbuf_text(&names));
	strbuf_release(&names);
}

/* Explains a code in the given dialect, or in every dialect that knows it; "codes": all codes. */
static bool explain_code(struct strbuf *out, const struct options *options)
{
	bool found = false;

	for (int row = 0; dialect_names[row]; row++) {
		const struct dialect *dialect = dialect_of_row(row);

		if (options->dialect >= 0 && !dialect_choice_is_auto(options->dialect) && options->dialect != row)
			continue;
		if (strcmp(options->explain, "codes") != 0) {
			found |= code_list_explain(out, dialect, options->explain);
			continue;
		}
		found = true;
		strbuf_addf(out, "%s%s, by %s\n", row && options->dialect < 0 ? "\n" : "", dialect->name,
			    dialect->manual);
		code_list_add(out, dialect);
	}
	return found;
}

bool explain_add(struct strbuf *out, const struct options *options, struct diag *diag)
{
	/* No word of the reports is also a code of a dialect. */
	if (topics_explain(out, options->explain) || explain_code(out, options))
		return true;
	refuse(options->explain, diag);
	return false;
}
