#include "gcode/code_list.h"

#include <limits.h>
#include <stdlib.h>

#include "base/ascii.h"

const char *code_state_name(enum code_state state)
{
	static const char *const names[] = {
	    [CODE_READ] = "read", [CODE_IGNORED] = "ignored", [CODE_BOUNDED] = "bounded", [CODE_REFUSED] = "refused"};

	return names[state];
}

static const char *state_meaning(enum code_state state)
{
	static const char *const meanings[] = {
		[CODE_READ] = "executed as the manual says",
		[CODE_IGNORED] = "moves no axis and changes nothing that the check depends on",
		[CODE_BOUNDED] = "not one known motion, but a set of possible motions; all of them are proved",
		[CODE_REFUSED] = "an error where it is used; the exit status is then 2",
	};

	return meanings[state];
}

static void add_name(struct strbuf *out, char letter, int number)
{
	if (letter == 'M')
		strbuf_addf(out, "M%d", number);
	else if (number % 10)
		strbuf_addf(out, "G%d.%d", number / 10, number % 10);
	else
		strbuf_addf(out, "G%d", number / 10);
}

/* Merges all sets in the order of their numbers: each step takes the least number above the last one. */
static void add_codes(struct strbuf *out, char letter, const struct code_set *const sets[CODE_SETS_MAX])
{
	for (int last = -1;;) {
		const struct code *next = NULL;

		for (int i = 0; i < CODE_SETS_MAX && sets[i]; i++) {
			for (size_t k = 0; k < sets[i]->count; k++) {
				const struct code *code = &sets[i]->rows[k];

				if (code->number > last && (!next || code->number < next->number))
					next = code;
			}
		}
		if (!next)
			return;
		last = next->number;
		add_name(out, letter, next->number);
		strbuf_addf(out, "\t%s\t%s\n", code_state_name(next->state), next->what);
	}
}

void code_list_add(struct strbuf *out, const struct dialect *dialect)
{
	add_codes(out, 'G', dialect->g_codes);
	add_codes(out, 'M', dialect->m_codes);
	for (int i = 0; i < CODE_SETS_MAX && dialect->words[i]; i++) {
		for (size_t k = 0; k < dialect->words[i]->count; k++) {
			const struct code_word *word = &dialect->words[i]->rows[k];

			strbuf_addf(out, "%s\t%s\t%s\n", word->word, code_state_name(word->state), word->what);
		}
	}
}

/* Compares without regard to case and blanks. */
static bool is_same_word(const char *a, const char *b)
{
	for (;; a++, b++) {
		while (*a == ' ')
			a++;
		while (*b == ' ')
			b++;
		if (ascii_upper(*a) != ascii_upper(*b))
			return false;
		if (*a == '\0')
			return true;
	}
}

/* The number of the rows in the tables: "G043.40" is 434. -1: the name is no such code. */
static int find_number(const char *name, bool tenths)
{
	long number;
	char *rest;

	if (!ascii_is_digit(name[0]))
		return -1;
	number = strtol(name, &rest, 10);
	if (number > SHRT_MAX)
		return -1;
	number *= tenths ? 10 : 1;
	if (tenths && rest[0] == '.' && ascii_is_digit(rest[1])) {
		number += rest[1] - '0';
		rest += 2;
	}
	return *rest == '\0' ? (int)number : -1;
}

/* `manual`: NULL for that of the dialect. */
static void explain(struct strbuf *out, const struct dialect *dialect, enum code_state state, const char *what,
		    const char *manual)
{
	strbuf_addf(out, " in the %s dialect: %s\n    %s: %s\n    source: %s\n", dialect->name, what,
		    code_state_name(state), state_meaning(state), manual ? manual : dialect->manual);
}

bool code_list_explain(struct strbuf *out, const struct dialect *dialect, const char *name)
{
	char letter = ascii_upper(name[0]);
	int number = letter == 'G' || letter == 'M' ? find_number(name + 1, letter == 'G') : -1;
	const struct code_set *const *sets = letter == 'G' ? dialect->g_codes : dialect->m_codes;

	for (int i = 0; number >= 0 && i < CODE_SETS_MAX && sets[i]; i++) {
		const struct code *code = code_find((const struct code_set *const[CODE_SETS_MAX]){sets[i]}, number);

		if (!code)
			continue;
		add_name(out, letter, number);
		explain(out, dialect, code->state, code->what, sets[i]->manual);
		return true;
	}
	for (int i = 0; i < CODE_SETS_MAX && dialect->words[i]; i++) {
		for (size_t k = 0; k < dialect->words[i]->count; k++) {
			const struct code_word *word = &dialect->words[i]->rows[k];

			if (!is_same_word(name, word->word))
				continue;
			strbuf_addf(out, "%s", word->word);
			explain(out, dialect, word->state, word->what, NULL);
			return true;
		}
	}
	return false;
}
