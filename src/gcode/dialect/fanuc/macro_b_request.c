#include "gcode/dialect/fanuc/macro_b_request.h"

#include <math.h>
#include <string.h>

#include "gcode/dialect/fanuc/macro_b_expr.h"

/* B-63944EN, argument specification I; Haas, alphabetic addressing: 0 is none. */
static int argument_of(char letter)
{
	static const char numbers[26] = {1,  2,	 3, 7, 8,  9,  0,  11, 4,  5,  6,  0,  13,
					 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

	return numbers[letter - 'A'];
}

/*
 * I, J and K by argument specification II: sets of three variables from #4 on. A letter that does not follow the letter
 * before in this order starts a new set (Haas: alternate addressing).
 */
static int argument_of_set(char letter, int *set, char *last)
{
	if (*last && letter <= *last)
		++*set;
	*last = letter;
	return 4 + 3 * *set + (letter - 'I');
}

/*
 * B-63944EN, macro calls, units of arguments: without a decimal point a value counts increments of its address. These
 * increments differ for E and F, and in inches for A, B and C, which need not be axes.
 */
static bool scale_argument(struct interp *interp, const struct word *word, double *value)
{
	double increment = interp->config->controller.least_input;

	if (word->point || fpclassify(*value) == FP_ZERO || strchr("DHMST", word->letter))
		return true;
	if (!(increment > 0))
		return dialect_refuse_whole_number(&interp->at, word->column, word->letter, *value);
	if (!(increment < 1))
		return true;
	if (strchr(interp->state.scale > 1 ? "ABCEF" : "EF", word->letter))
		return fault(&interp->at, word->column,
			     "%c%.15g: the unit of this argument without a decimal point is not known; write the point",
			     word->letter, *value);
	*value *= interp->state.scale > 1 ? increment / 10 : increment;
	return true;
}

static bool read_argument(struct interp *interp, const struct word *word, struct macro_b_request *request, int *set,
			  char *last)
{
	double value = word->vacant ? macro_b_vacant() : word->value;
	int number = argument_of(word->letter);

	if (number == 0)
		return fault(&interp->at, word->column, "a macro has no argument %c", word->letter);
	if (word->letter >= 'I' && word->letter <= 'K')
		number = argument_of_set(word->letter, set, last);
	if (number > MACRO_B_LOCALS)
		return fault(&interp->at, word->column, "more than ten sets of I, J and K");
	if (!word->vacant && !scale_argument(interp, word, &value))
		return false;
	/* In a mixture the later argument is valid (B-63944EN, mixture of argument specifications I and II). */
	request->arguments[number] = value;
	return true;
}

static bool read_count(struct interp *interp, const struct word *word, int most, int *value)
{
	if (word->vacant || word->value < 1 || word->value > most || floor(word->value) < word->value)
		return fault(&interp->at, word->column, "%c must be a whole number from 1 to %d", word->letter,
			     most);
	*value = (int)word->value;
	return true;
}

bool macro_b_request_read(struct interp *interp, struct lexer *lexer, int column, int number,
			  struct macro_b_request *request)
{
	enum lexer_result result;
	struct word word;
	int set = 0;
	char last = 0;

	*request = (struct macro_b_request){.number = number, .repeats = 1};
	for (int i = 0; i <= MACRO_B_LOCALS; i++)
		request->arguments[i] = macro_b_vacant();
	lexer->rules = macro_b_argument_rules(interp);
	while ((result = lexer_next(lexer, &word)) == LEXER_WORD) {
		if (word.letter == 'P' && number == 0 ? !read_count(interp, &word, 99999999, &request->number)
		    : word.letter == 'L'
			? !read_count(interp, &word, 9999, &request->repeats)
			: !read_argument(interp, &word, request, &set, &last))
			return false;
	}
	if (result == LEXER_FAULT)
		return false;
	if (request->number == 0)
		return fault(&interp->at, column, "a macro call needs P (program number)");
	return true;
}
