#include "scene/pair_rules.h"

#include "suite.h"

/* Links: 0 is the base, 1 is Z with the head, 2 is A with the cradle. Tool, fixture and part are bodies of a setup. */
static const struct body head = {.name = "head", .role = ROLE_MACHINE, .link = 1};
static const struct body cradle = {.name = "cradle", .role = ROLE_MACHINE, .link = 2};
static const struct body cover = {.name = "cover", .role = ROLE_MACHINE, .link = 2};
static const struct body holder = {.name = "tool 1 holder", .role = ROLE_HOLDER, .link = 1, .tool = 1};
static const struct body vise = {.name = "vise", .role = ROLE_FIXTURE, .link = 2};

static struct pair_name link_name(int link)
{
	return (struct pair_name){.kind = NAME_LINK, .link = link};
}

static struct pair_name role_name(enum body_role role)
{
	return (struct pair_name){.kind = NAME_ROLE, .role = role};
}

static struct pair_name body_name(const char *name)
{
	return (struct pair_name){.kind = NAME_BODY, .body = name};
}

static struct pair_rule rule(struct pair_name a, struct pair_name b, enum rule_check check, double clearance)
{
	return (struct pair_rule){a, b, check, clearance, check == PAIR_NEVER ? "because" : NULL, 1};
}

/* The order of the rules and of the bodies must not matter. */
static struct pair_ruling apply(const struct pair_rule *rules, size_t count, const struct body *a, const struct body *b)
{
	struct pair_rule reversed[8];
	struct machine machine = {.rules = NULL, .rule_count = count};
	struct pair_ruling one, two, three;

	for (size_t i = 0; i < count; i++)
		reversed[i] = rules[count - 1 - i];
	machine.rules = reversed;
	two = pair_rules_apply(&machine, a, b);
	for (size_t i = 0; i < count; i++)
		reversed[i] = rules[i];
	one = pair_rules_apply(&machine, a, b);
	three = pair_rules_apply(&machine, b, a);
	ck_assert_int_eq(one.check, two.check);
	ck_assert_int_eq(one.check, three.check);
	ck_assert_double_eq(one.clearance, two.clearance);
	ck_assert_double_eq(one.clearance, three.clearance);
	ck_assert((one.reason != NULL) == (one.check == PAIR_NEVER));
	return one;
}

static void expect(const struct pair_rule *rules, size_t count, const struct body *a, const struct body *b,
		   enum rule_check check, double clearance)
{
	struct pair_ruling ruling = apply(rules, count, a, b);

	ck_assert_int_eq(ruling.check, check);
	ck_assert_double_eq(ruling.clearance, clearance);
}

START_TEST(who_is_named)
{
	const struct pair_rule links[] = {rule(link_name(1), link_name(2), PAIR_NEVER, -1)};
	const struct pair_rule roles[] = {rule(role_name(ROLE_HOLDER), role_name(ROLE_FIXTURE), PAIR_ALWAYS, 3)};
	const struct pair_rule own[] = {rule(body_name("cradle"), link_name(1), PAIR_NEVER, -1)};

	expect(links, 1, &head, &cradle, PAIR_NEVER, -1);
	/* The name of a link stands for the machine's own bodies on it, not for those that are mounted there. */
	expect(links, 1, &holder, &cradle, PAIR_DERIVED, -1);
	expect(links, 1, &head, &vise, PAIR_DERIVED, -1);
	expect(roles, 1, &holder, &vise, PAIR_ALWAYS, 3);
	expect(roles, 1, &head, &vise, PAIR_DERIVED, -1);
	expect(own, 1, &head, &cradle, PAIR_NEVER, -1);
	expect(own, 1, &head, &cover, PAIR_DERIVED, -1);
	expect(own, 0, &head, &cradle, PAIR_DERIVED, -1);
	/* Two bodies of one link: each name must belong to one of them. */
	expect(links, 1, &cradle, &cover, PAIR_DERIVED, -1);
}
END_TEST

START_TEST(the_more_particular_wins)
{
	const struct pair_rule body_over_link[] = {rule(link_name(1), link_name(2), PAIR_ALWAYS, 2),
						   rule(link_name(1), body_name("cradle"), PAIR_NEVER, -1)};
	const struct pair_rule both_over_one[] = {rule(body_name("head"), link_name(2), PAIR_NEVER, 5),
						  rule(body_name("head"), body_name("cradle"), PAIR_ALWAYS, 1)};
	const struct pair_rule body_over_roles[] = {
	    rule(role_name(ROLE_HOLDER), role_name(ROLE_FIXTURE), PAIR_ALWAYS, -1),
	    rule(role_name(ROLE_HOLDER), body_name("vise"), PAIR_NEVER, -1)};
	const struct pair_rule role_over_link[] = {rule(role_name(ROLE_MACHINE), link_name(2), PAIR_ALWAYS, -1),
						   rule(link_name(1), link_name(2), PAIR_NEVER, -1)};

	expect(body_over_link, 2, &head, &cradle, PAIR_NEVER, 2);
	expect(body_over_link, 2, &head, &cover, PAIR_ALWAYS, 2);
	expect(both_over_one, 2, &head, &cradle, PAIR_ALWAYS, 1);
	expect(both_over_one, 2, &head, &cover, PAIR_NEVER, 5);
	expect(body_over_roles, 2, &holder, &vise, PAIR_NEVER, -1);
	expect(role_over_link, 2, &head, &cradle, PAIR_ALWAYS, -1);
}
END_TEST

START_TEST(among_equals)
{
	const struct pair_rule equals[] = {rule(body_name("head"), body_name("cradle"), PAIR_NEVER, 1),
					   rule(body_name("cradle"), body_name("head"), PAIR_ALWAYS, 4),
					   rule(body_name("head"), body_name("cradle"), PAIR_NEVER, 2)};
	/* A rule without a check, or without a clearance, leaves this to other rules. */
	const struct pair_rule halves[] = {rule(body_name("head"), body_name("cradle"), PAIR_DERIVED, 7),
					   rule(link_name(1), link_name(2), PAIR_NEVER, 1)};
	const struct pair_rule zero[] = {rule(body_name("head"), body_name("cradle"), PAIR_DERIVED, 0),
					 rule(link_name(1), link_name(2), PAIR_DERIVED, 9)};

	expect(equals, 3, &head, &cradle, PAIR_ALWAYS, 4);
	expect(halves, 2, &head, &cradle, PAIR_NEVER, 7);
	expect(halves, 2, &head, &cover, PAIR_NEVER, 1);
	expect(zero, 2, &head, &cradle, PAIR_DERIVED, 0);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("precedence");

	tcase_add_test(tcase, who_is_named);
	tcase_add_test(tcase, the_more_particular_wins);
	tcase_add_test(tcase, among_equals);
	return run_suite("rules", tcase);
}
