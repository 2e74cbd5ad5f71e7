#include "cli/explain.h"

#include "base/spelling.h"
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
		diag_error(diag, nowhere, "--explain: '%s' is none of %s", word, strbuf_text(&names));
	strbuf_release(&names);
}

bool explain_add(struct strbuf *out, const struct options *options, struct diag *diag)
{
	/* The words of reports are in small letters, the codes of programs in capital ones: they never collide. */
	if (topics_explain(out, options->explain))
		return true;
	refuse(options->explain, diag);
	return false;
}
