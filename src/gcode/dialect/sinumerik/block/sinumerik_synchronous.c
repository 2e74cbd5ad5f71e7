#include "gcode/dialect/sinumerik/block/sinumerik_synchronous.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"

static bool is_one_of(const char *name, const char *const *names, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (!strcmp(name, names[i]))
			return true;
	}
	return false;
}

#define IS_ONE_OF(name, names) is_one_of(name, names, sizeof(names) / sizeof((names)[0]))

/* The index of the word DO from `at` on, outside of strings; or the end. */
static size_t find_do(const char *text, size_t at)
{
	bool quoted = false;

	for (; text[at] && (quoted || text[at] != ';'); at++) {
		quoted = quoted != (text[at] == '"');
		if (!quoted && !sinumerik_is_name(text[at - 1]) && ascii_upper(text[at]) == 'D' &&
		    ascii_upper(text[at + 1]) == 'O' && !sinumerik_is_name(text[at + 2]))
			return at;
	}
	return at;
}

static bool is_operator(char byte)
{
	return byte != '\0' && strchr("+-*/<>=,", byte);
}

/* The '=' of an assignment, not that of ==, <= or >=. */
static bool assigns(const char *text, size_t at)
{
	return text[at] == '=' && text[at + 1] != '=' && !strchr("<>=", text[at - 1]);
}

/*
 * The end of a value: a blank that is beside no operator and inside no bracket; or the end of the block; or the '='
 * of a further action that follows directly ("1POS[X]=5").
 */
static size_t skip_value(const char *text, size_t at)
{
	bool quoted = false;
	int depth = 0;

	for (at = sinumerik_skip_blanks(text, at); text[at] && (quoted || text[at] != ';'); at++) {
		quoted = quoted != (text[at] == '"');
		depth += quoted ? 0 : strchr("([", text[at]) ? 1 : strchr(")]", text[at]) ? -1 : 0;
		if (!quoted && depth == 0 && assigns(text, at))
			return at;
		if (quoted || depth > 0 || (text[at + 1] != ' ' && text[at + 1] != '\t'))
			continue;
		if (!is_operator(text[at]) && !is_operator(text[sinumerik_skip_blanks(text, at + 1)]))
			return at + 1;
	}
	return at;
}

/* M-codes of coolant and gears, and those that the machine file declares to move nothing. */
static bool is_idle_m(const struct interp *interp, const char *name)
{
	const struct controller *controller = &interp->config->controller;
	const long number = strtol(name + 1, NULL, 10);
	const struct code *code;

	if (name[0] != 'M' || !name[1] || name[1 + strspn(name + 1, "0123456789")] || number > 99999999)
		return false;
	for (size_t i = 0; i < controller->mcode_count; i++) {
		if (controller->mcodes[i].number == number)
			return controller->mcodes[i].action == MCODE_IGNORE;
	}
	code = code_find(interp->config->dialect->m_codes, (int)number);
	return code && code->state == CODE_IGNORED;
}

/* One action: an output, an override, a timer, an alarm, a stop of reading, or coolant. False: reported. */
static bool take_action(struct interp *interp, struct lexer *lexer)
{
	static const char *const written[] = {"$A_OUT", "$A_OUTA", "$A_DBB", "$A_DBW", "$A_DBD", "$A_DBR", "$AC_OVR",
					      "$AA_OVR", "$AC_VC", "$AC_TIMER", "$AC_MARKER", "$AC_PARAM"};
	static const char *const plain[] = {"STOPREOF", "RDISABLE"};
	const char *text = lexer->at->text;
	const int column = lexer_next_column(lexer);
	char name[SINUMERIK_NAME + 1] = "";

	sinumerik_name_read(lexer, name);
	if (IS_ONE_OF(name, plain) || is_idle_m(interp, name))
		return true;
	if (!strcmp(name, "SETAL"))
		return sinumerik_name_step_over_call(lexer);
	if (IS_ONE_OF(name, written)) {
		if (lexer_peek(lexer) == '[')
			lexer->position += strcspn(text + lexer->position, "]") +
					   (strchr(text + lexer->position, ']') != NULL);
		if (!sinumerik_name_need(lexer, '=', name))
			return false;
		lexer->position = skip_value(text, lexer->position);
		return true;
	}
	return fault(lexer->at, column,
		     "a synchronous action that may move an axis or change the program is not supported; behind DO "
		     "stand outputs ($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes "
		     "that move no axis");
}

bool sinumerik_synchronous_take(struct interp *interp, struct lexer *lexer, const char *name, bool *is)
{
	static const char *const conditions[] = {"WHEN", "WHENEVER", "EVERY", "DO"};
	static const char *const numbers[] = {"ID", "IDS"};
	const char next = lexer_peek(lexer);
	const int column = lexer_next_column(lexer);

	*is = next == '=' ? IS_ONE_OF(name, numbers) : IS_ONE_OF(name, conditions);
	if (!*is)
		return true;
	if (strcmp(name, "DO") != 0) {
		lexer->position = find_do(lexer->at->text, lexer->position);
		if (!sinumerik_name_take(lexer, "DO"))
			return fault(lexer->at, column, "a synchronous action needs DO and what it does");
	}
	do {
		if (!take_action(interp, lexer))
			return false;
	} while (lexer_peek(lexer) != '\0' && lexer_peek(lexer) != ';');
	return true;
}
