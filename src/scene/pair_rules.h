/* pair_rules.h - what the user's <pair> elements say of two bodies. */
#ifndef FIVECHECK_SCENE_PAIR_RULES_H
#define FIVECHECK_SCENE_PAIR_RULES_H

#include "machine/machine.h"

/* What holds for a pair after all rules; clearance < 0: no rule gives one. */
struct pair_ruling {
	enum rule_check check;
	const char *reason;	/* of NEVER */
	double clearance;
};

/*
 * The rule with the more particular names wins (body before role before link,
 * the more particular of its two names first); among equals ALWAYS beats
 * NEVER, and the larger clearance the smaller.
 */
struct pair_ruling pair_rules_apply(const struct machine *machine, const struct body *a, const struct body *b);

#endif
