#include "gcode/dialect/sinumerik/builder/sinumerik_gud.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "control/control_variable.h"
#include "gcode/dialect/sinumerik/values/sinumerik_functions.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_codes.h"
#include "gcode/eval/expr.h"

/* 840D sl, system variables: of the program ($P_), of axes ($AA_, $VA_) and of the channel ($AC_) while it runs. */
static bool changes(const char *name)
{
	static const char *const running[] = {"$P_", "$AA_", "$VA_", "$AC_"};

	for (size_t i = 0; i < sizeof(running) / sizeof(running[0]); i++) {
		if (!strncmp(name, running[i], strlen(running[i])))
			return true;
	}
	return false;
}

/* -------------------------------------------------------------- the machine file's */

static bool set_value(struct interp *interp, struct sinumerik_variable *variable, size_t element,
		      const struct control_variable *from)
{
	if (variable->type == SINUMERIK_STRING) {
		if (strlen(from->text) > (size_t)(variable->length ? variable->length : SINUMERIK_TEXT))
			return fault(&interp->at, 0, "%s: the text of its <variable> is too long for it", from->name);
		strcpy(variable->texts[element].bytes, from->text);
		variable->given[element] = true;
		return true;
	}
	if (variable->type == SINUMERIK_AXIS) {
		const int slot = from->text[0] && !from->text[1] ? slot_of_letter(from->text[0]) : -1;

		if (slot < 0 || !interp->config->has_axis[slot])
			return fault(&interp->at, 0, "%s: the value of its <variable> is no axis of the machine",
				     from->name);
		variable->numbers[element] = slot;
		variable->given[element] = true;
		return true;
	}
	if (isnan(from->number))
		return fault(&interp->at, 0, "%s: the value of its <variable> is no number", from->name);
	return sinumerik_variables_set(interp, variable, element, from->number, 0);
}

/* 840D sl, job planning, "Definition of user variables": a name begins with two letters, and means nothing else. */
static bool may_be_variable(const char *name)
{
	struct sinumerik_word word;

	return sinumerik_starts_name(name[0]) && sinumerik_starts_name(name[1]) && !sinumerik_codes_word(name, &word) &&
	       !sinumerik_functions_is(name);
}

/* NULL: there is no room, which was reported. */
static struct sinumerik_variable *add(struct interp *interp, const struct sinumerik_variable *made)
{
	struct sinumerik_variable *variable = sinumerik_variables_add(interp, made, 0);

	if (variable) {
		variable->level = SINUMERIK_LEVEL_OF_CONTROL;
		variable->given = mem_zalloc(variable->count, sizeof(*variable->given));
	}
	return variable;
}

static bool make_one(struct interp *interp, const struct control_variable *from)
{
	static const enum sinumerik_type types[] = {
		[CONTROL_REAL] = SINUMERIK_REAL, [CONTROL_INT] = SINUMERIK_INT,	      [CONTROL_BOOL] = SINUMERIK_BOOL,
		[CONTROL_CHAR] = SINUMERIK_CHAR, [CONTROL_STRING] = SINUMERIK_STRING, [CONTROL_AXIS] = SINUMERIK_AXIS,
	};
	struct sinumerik_variable made = {.type = types[from->type], .dimensions = from->dimensions, .refers_to = -1};
	const size_t length = strlen(from->name);
	struct sinumerik_variable *variable;

	if (length > SINUMERIK_NAME || !may_be_variable(from->name) ||
	    strspn(from->name, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") != length)
		return fault(&interp->at, 0,
			     "<variable name=\"%s\" type=\"\">: a variable has a name of two letters "
			     "or more, _ and digits, at most %d, which means nothing else; size=\"\" says how many "
			     "elements it has",
			     from->name, SINUMERIK_NAME);
	memcpy(made.name, from->name, length + 1);
	memcpy(made.size, from->size, sizeof(made.size));
	variable = add(interp, &made);
	if (!variable)
		return false;
	for (size_t i = 0; i < variable->count && from->text; i++) {
		if (!set_value(interp, variable, i, from))
			return false;
	}
	return true;
}

/*
 * 840D sl, measuring cycles, "Parameter description": every control has the parameters of its measuring cycles. Their
 * values are not known before the program assigns them. Those that the machine file has keep its type.
 */
static bool make_measuring(struct interp *interp)
{
	/* Behind a number is a blank, behind a text $, behind an array [, and behind an array of INT ]. */
	static const char names[] = "_CALNUM _CORA _CPA _CPO _EVNUM _FA _ID _INCA _K _KNUM _MA _MD _MVAR _NMSP _OVI]"
				    "_OVR[_PRNUM "
				    "_RA _RF _SETV[_SETVAL _STA1 _SZA _SZO _TDIF _TLL _TMV _TNAME$_TNUM _TSA _TUL _TZL "
				    "_VMS ";

	for (const char *name = names, *end; *name; name = end + 1) {
		struct sinumerik_variable made = {.size = {32}, .refers_to = -1};

		end = name + strcspn(name, " $[]");
		made.type = *end == '$' ? SINUMERIK_STRING : *end == ']' ? SINUMERIK_INT : SINUMERIK_REAL;
		made.dimensions = *end == '[' || *end == ']';
		memcpy(made.name, name, (size_t)(end - name));
		if (sinumerik_variables_find(sinumerik_of(interp), made.name) < 0 && !add(interp, &made))
			return false;
	}
	return true;
}

/* "2,0]": the element, in one spelling. False: the array has no such element. */
static bool find_element(const struct sinumerik_variable *variable, const char *text, size_t *element)
{
	*element = 0;
	for (int i = 0; i < variable->dimensions; i++) {
		char *end;
		const long index = strtol(text, &end, 10);

		if (*text < '0' || *text > '9' || (*text == '0' && end > text + 1) || index < 0 ||
		    index >= variable->size[i] || *end != (i + 1 < variable->dimensions ? ',' : ']'))
			return false;
		*element = *element * (size_t)variable->size[i] + (size_t)index;
		text = end + 1;
	}
	return variable->dimensions > 0 && *text == '\0';
}

/* <variable name="NAME[2,0]" value=""/>, or the value of a variable that has its type in another element. */
static bool set_element(struct interp *interp, const struct control_variable *from)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const size_t length = strcspn(from->name, "[");
	char name[SINUMERIK_NAME + 1];
	size_t element = 0;
	bool whole;
	int found = -1;

	if (length <= SINUMERIK_NAME) {
		snprintf(name, sizeof(name), "%.*s", (int)length, from->name);
		found = sinumerik_variables_find(sinumerik, name);
	}
	if (found < 0)
		return fault(&interp->at, 0,
			     "<variable name=\"%s\">: its type is missing, type=\"REAL\" and the like",
			     from->name);
	whole = !from->name[length] && sinumerik->variables.items[found].dimensions == 0;
	if (!whole && (!from->name[length] ||
		       !find_element(&sinumerik->variables.items[found], from->name + length + 1, &element)))
		return fault(&interp->at, 0, "<variable name=\"%s\"> is no element of that array",
			     from->name);
	/* Without a value, the program has to assign one first. */
	if (!from->text)
		sinumerik->variables.items[found].given[element] = false;
	return !from->text || set_value(interp, &sinumerik->variables.items[found], element, from);
}

static bool is_parameter(const char *name)
{
	return name[0] == 'R' && name[1] && name[1 + strspn(name + 1, "0123456789")] == '\0';
}

static bool check_parameter(struct interp *interp, const struct control_variable *from)
{
	if (from->name[1] == '0' && from->name[2])
		return fault(&interp->at, 0, "<variable name=\"%s\">: write it without leading zeros",
			     from->name);
	return !from->text || !isnan(from->number) ||
	       fault(&interp->at, 0, "%s: the value of its <variable> is no number", from->name);
}

/*
 * Tool lengths, radii, and work offsets ($P_UIFR) come from the setup; the other variables change while the program
 * runs.
 */
static bool check_system(struct interp *interp, const char *name)
{
	const bool of_tool = !strncmp(name, "$TC_DP3[", 8) || !strncmp(name, "$TC_DP6[", 8);

	return (!of_tool && !changes(name)) ||
	       fault(&interp->at, 0,
		     "<variable name=\"%s\">: the offsets and tools of the setup, or the program, determine its value",
		     name);
}

/* Names that need no type: elements, R parameters and system variables. */
static bool set_untyped(struct interp *interp, const struct control_variable *variable)
{
	if (variable->name[0] == '$')
		return check_system(interp, variable->name);
	return is_parameter(variable->name) ? check_parameter(interp, variable) : set_element(interp, variable);
}

bool sinumerik_gud_make(struct interp *interp)
{
	const struct controller *controller = &interp->config->controller;
	const struct line_place program = interp->at;
	bool good = true;

	/*
	 * Elements of the machine file with a type make the variables; those without a type give values to their
	 * elements.
	 */
	for (int typed = 1; typed >= 0; typed--) {
		if (!typed && good)
			good = make_measuring(interp);
		for (size_t i = 0; i < controller->variable_count && good; i++) {
			const struct control_variable *variable = &controller->variables[i];

			if (variable->typed != typed)
				continue;
			interp->at = fault_place(&program, variable->at);
			good = typed ? make_one(interp, variable) : set_untyped(interp, variable);
			interp->at = program;
		}
	}
	return good;
}

double sinumerik_gud_r(const struct interp *interp, int number)
{
	const struct control_variable *variable;
	char name[16];

	snprintf(name, sizeof(name), "R%d", number);
	variable = control_variable_find(&interp->config->controller, name);
	return variable && variable->text ? variable->number : NAN;
}

/* -------------------------------------------------------------- what is missing */

/* A text after '=', '==', '<>' or '<<' shows that the variable is a text. */
static const char *type_of(struct lexer *lexer)
{
	const char *text = lexer->at->text + lexer->position;

	text += *text == '[' ? strcspn(text, "];") : 0;
	text += *text == ']';
	text += strspn(text, " \t");
	if (text[0] == '<' && text[1] == '<')
		return "STRING";
	if (*text == '=' || (text[0] == '<' && text[1] == '>'))
		text += strspn(text, "=<> \t");
	return *text == '"' ? "STRING" : "";
}

/* The number of dimensions of the array whose indices come next; 0: there are none. */
static int dimensions_of(struct lexer *lexer)
{
	const char *text = lexer->at->text + lexer->position;
	int depth = 0, count = 1;

	if (lexer_peek(lexer) != '[')
		return 0;
	for (; *text && *text != ';'; text++) {
		depth += *text == '[' || *text == '(';
		depth -= *text == ']' || *text == ')';
		if (depth == 0 && *text == ']')
			break;
		count += depth == 1 && *text == ',';
	}
	return count < SINUMERIK_DIMENSIONS ? count : SINUMERIK_DIMENSIONS;
}

bool sinumerik_gud_ask(struct lexer *lexer, const char *name, bool reads, int column)
{
	static const char *const sizes[] = {"", " size=\"\"", " size=\",\"", " size=\",,\""};
	const int dimensions = dimensions_of(lexer);

	if (!may_be_variable(name))
		return fault(lexer->at, column, "%s is neither an axis of the machine nor a variable of this program",
			     name);
	return fault(lexer->at, column,
		     "%s is neither an axis of the machine nor a variable of this program; if the "
		     "machine's maker or a user has defined it (GUD), set <variable name=\"%s\" type=\"%s\"%s%s/> "
		     "in the machine file's <controller>",
		     name, name, type_of(lexer), sizes[dimensions],
		     reads && dimensions == 0 ? " value=\"\"" : "");
}

bool sinumerik_gud_system(struct interp *interp, const char *name, int column, double *value)
{
	const struct control_variable *variable = control_variable_find(&interp->config->controller, name);

	if (changes(name))
		return fault(&interp->at, column, "the value of %s is known to the control alone", name);
	if (!variable || !variable->text)
		return fault(&interp->at, column,
			     "the value of %s is known to the control alone; if it stays the same while the "
			     "program runs, set <variable name=\"%s\" value=\"\"/> in the machine file's "
			     "<controller>",
			     name, name);
	*value = variable->number;
	return !isnan(*value) || fault(&interp->at, column, "%s: the value of its <variable> is no number", name);
}
