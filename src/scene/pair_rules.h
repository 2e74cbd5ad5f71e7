/* pair_rules.h - what the user's <pair> elements say about two bodies. */
#ifndef FIVECHECK_SCENE_PAIR_RULES_H
#define FIVECHECK_SCENE_PAIR_RULES_H

#include "machine/machine.h"

/* The result of all rules for a pair; clearance < 0: no rule gives one. */
struct pair_ruling {
	enum rule_check check;
	const char *reason;	/* of NEVER */
	double clearance;
};

/*
 * The rule with the more specific names takes precedence: a body is more specific than a role, a role more than a link,
 * and the more specific of a rule's two names is compared first. Between equals ALWAYS precedes NEVER, and the larger
 * clearance the smaller.
 */
struct pair_ruling pair_rules_apply(const struct machine *machine, const struct body *a, const struct body *b);

#endif
