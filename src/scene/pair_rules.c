#include "scene/pair_rules.h"

#include <stdbool.h>
#include <string.h>

static bool names(const struct pair_name *name, const struct body *body)
{
	switch (name->kind) {
	case NAME_LINK:
		return body_is_of_link(body, name->link);
	case NAME_ROLE:
		return body->role == name->role;
	case NAME_BODY:
		return !strcmp(body->name, name->body);
	}
	return false;
}

static bool speaks_of(const struct pair_rule *rule, const struct body *a, const struct body *b)
{
	return (names(&rule->a, a) && names(&rule->b, b)) || (names(&rule->a, b) && names(&rule->b, a));
}

/* The larger number is more specific. */
static int rank(const struct pair_rule *rule)
{
	int a = (int)rule->a.kind, b = (int)rule->b.kind;

	return a > b ? 3 * a + b : 3 * b + a;
}

struct pair_ruling pair_rules_apply(const struct machine *machine, const struct body *a, const struct body *b)
{
	struct pair_ruling ruling = {PAIR_DERIVED, NULL, -1};
	int check_rank = -1, clearance_rank = -1;

	for (size_t i = 0; i < machine->rule_count; i++) {
		const struct pair_rule *rule = &machine->rules[i];
		int r = rank(rule);

		if (!speaks_of(rule, a, b))
			continue;
		if (rule->check != PAIR_DERIVED &&
		    (r > check_rank || (r == check_rank && rule->check == PAIR_ALWAYS))) {
			ruling.check = rule->check;
			ruling.reason = rule->reason;
			check_rank = r;
		}
		if (rule->clearance >= 0 &&
		    (r > clearance_rank || (r == clearance_rank && rule->clearance > ruling.clearance))) {
			ruling.clearance = rule->clearance;
			clearance_rank = r;
		}
	}
	return ruling;
}
