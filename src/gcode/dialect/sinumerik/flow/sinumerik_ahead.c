#include "gcode/dialect/sinumerik/flow/sinumerik_ahead.h"

#include <stdbool.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Has the block the M-code with these digits? */
static enum sinumerik_ahead ahead_of(const char *digits, size_t length)
{
	static const struct {
		const char *digits;
		enum sinumerik_ahead ahead;
	} codes[] = {
	    {"6", SINUMERIK_AHEAD_CHANGE},
	    {"2", SINUMERIK_AHEAD_END},
	    {"17", SINUMERIK_AHEAD_END},
	    {"30", SINUMERIK_AHEAD_END},
	};
	const size_t zeros = strspn(digits, "0");

	for (size_t i = 0; i < sizeof(codes) / sizeof(codes[0]); i++) {
		if (zeros + strlen(codes[i].digits) == length &&
		    !strncmp(digits + zeros, codes[i].digits, length - zeros))
			return codes[i].ahead;
	}
	return SINUMERIK_AHEAD_NOTHING;
}

/* Letters with numbers, such as T1M06D1. Moves *at behind them, or behind the name, if it is a name. */
static enum sinumerik_ahead look_at_run(const char *words, size_t *at)
{
	enum sinumerik_ahead ahead = SINUMERIK_AHEAD_NOTHING;

	while (sinumerik_starts_name(words[*at])) {
		const bool is_m = ascii_upper(words[*at]) == 'M';
		const size_t number = *at + 1 + strspn(words + *at + 1, "+-"),
			     length = strspn(words + number, "0123456789.");
		const enum sinumerik_ahead code = is_m ? ahead_of(words + number, length) : SINUMERIK_AHEAD_NOTHING;

		if (length == 0) {
			*at += strspn(words + *at, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789");
			return SINUMERIK_AHEAD_NOTHING;
		}
		ahead = code > ahead ? code : ahead;
		*at = number + length;
	}
	return words[*at] != '(' && words[*at] != ':' && words[*at] != '=' ? ahead : SINUMERIK_AHEAD_NOTHING;
}

enum sinumerik_ahead sinumerik_ahead_of_line(const char *words)
{
	enum sinumerik_ahead ahead = SINUMERIK_AHEAD_NOTHING;
	size_t at = 0;
	bool quoted = false;

	while (words[at] && (quoted || words[at] != ';') && ahead != SINUMERIK_AHEAD_CHANGE) {
		enum sinumerik_ahead run = SINUMERIK_AHEAD_NOTHING;

		quoted = quoted != (words[at] == '"');
		if (quoted || !sinumerik_starts_name(words[at]))
			at++;
		else
			run = look_at_run(words, &at);
		ahead = run > ahead ? run : ahead;
	}
	return ahead;
}
