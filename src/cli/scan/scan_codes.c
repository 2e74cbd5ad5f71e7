#include "cli/scan/scan_codes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "gcode/code_list.h"
#include "gcode/text/line_shape.h"
#include "gcode/text/number.h"
#include "gcode/text/reader.h"

/* M-codes have up to five digits; a longer number is not a code. */
#define NUMBER_MAX 99999

void scan_codes_release(struct scan_codes *codes)
{
	free(codes->items);
	*codes = (struct scan_codes){0};
}

static void count_code(struct scan_codes *codes, char letter, int number, const struct code_word *word)
{
	struct scan_code *item = NULL;

	for (size_t i = 0; i < codes->count && !item; i++) {
		if (codes->items[i].letter == letter && codes->items[i].number == number &&
		    codes->items[i].word == word)
			item = &codes->items[i];
	}
	if (!item) {
		codes->items = mem_grow(codes->items, &codes->capacity, codes->count + 1, sizeof(*codes->items));
		item = &codes->items[codes->count++];
		*item = (struct scan_code){.letter = letter, .number = number, .word = word};
	}
	item->times++;
	item->programs += item->last_program != codes->programs;
	item->last_program = codes->programs;
}

/* Counts G and M with plain numbers, unless they are part of a longer word. */
static void count_codes(struct scan_codes *codes, const char *block)
{
	for (const char *at = block; *at; at++) {
		bool inside = at > block && (ascii_is_letter(at[-1]) || at[-1] == '_' || at[-1] == '<');
		size_t length = 0;
		double number;
		bool point;

		if ((*at != 'G' && *at != 'M') || inside || !ascii_is_digit(at[1]))
			continue;
		if (number_read(at + 1, &length, &number, &point) != NUMBER_OK)
			continue;
		if (number <= NUMBER_MAX && at[1 + length] != '=')
			count_code(codes, *at, (int)lround(*at == 'G' ? number * 10 : number), NULL);
		at += length;
	}
}

/*
 * Blanks are removed: a short word followed by two letters is the start of a longer one, such as PO of POCKET3 and
 * POS[X].
 */
#define SHORT_WORD 4

static bool is_start(const char *text, const char *behind)
{
	return strlen(text) < SHORT_WORD && ascii_is_letter(behind[0]) &&
	       (ascii_is_letter(behind[1]) || behind[1] == '[' || behind[1] == '(');
}

/* "B3=": without '=' it is an axis with its value, like B3.5. */
static bool is_coordinate(const char *text, char after)
{
	return ascii_is_letter(text[0]) && ascii_is_digit(text[1]) && !text[2] && after != '=';
}

static bool is_name_byte(char byte)
{
	return ascii_is_letter(byte) || byte == '_';
}

/* The text of a word without blanks, if it has only letters and digits. */
static bool is_plain(const struct code_word *word, char text[LINE_SHAPE_MAX])
{
	line_shape_squeeze(word->word, text);
	for (const char *at = text; *at; at++) {
		if (!ascii_is_alphanumeric(*at))
			return false;
	}
	return true;
}

/* Does the word begin here, without letters or digits directly before and after it? */
static bool stands_at(const char *block, const char *at, const char *text)
{
	const size_t length = strlen(text);

	return !strncmp(at, text, length) && !is_start(text, at + length) && !is_coordinate(text, at[length]) &&
	       (at == block || !is_name_byte(at[-1])) &&
	       !(ascii_is_digit(at[length]) && ascii_is_digit(text[length - 1]));
}

/* SETMS is not SETM: is there a longer word here that begins with this one? */
static bool longer_stands(const struct dialect *dialect, const char *block, const char *at, const char *text)
{
	char longer[LINE_SHAPE_MAX];

	for (int i = 0; i < CODE_SETS_MAX && dialect->words[i]; i++) {
		for (size_t k = 0; k < dialect->words[i]->count; k++) {
			if (is_plain(&dialect->words[i]->rows[k], longer) && strlen(longer) > strlen(text) &&
			    stands_at(block, at, longer))
				return true;
		}
	}
	return false;
}

/* Is a word of two letters or more, such as CP, only the start of longer names here, such as CPA? */
static bool only_starts(const char *line, const char *text)
{
	const size_t length = strlen(text);
	const char *at = strstr(line, text);

	if (!at || length < 2 || ascii_is_digit(text[length - 1]))
		return false;
	while (at && is_name_byte(at[length]))
		at = strstr(at + 1, text);
	return !at;
}

/* `line` has its blanks, `block` has none. */
static void count_word(struct scan_codes *codes, const char *line, const char *block, const struct code_word *word)
{
	char text[LINE_SHAPE_MAX];

	if (!is_plain(word, text) || only_starts(line, text))
		return;
	for (const char *at = strstr(block, text); at; at = strstr(at + 1, text)) {
		if (stands_at(block, at, text) && !longer_stands(codes->dialect, block, at, text)) {
			count_code(codes, 0, 0, word);
			return;
		}
	}
}

void scan_codes_read(struct scan_codes *codes, FILE *in)
{
	struct reader reader;
	const char *text;

	codes->programs++;
	reader_init(&reader, in);
	while (reader_next(&reader, &text) == READER_LINE) {
		char block[LINE_SHAPE_MAX], line[LINE_SHAPE_MAX];

		line_shape_squeeze(text, block);
		line_shape_fold(text, line);
		count_codes(codes, block);
		for (int i = 0; i < CODE_SETS_MAX && codes->dialect->words[i]; i++) {
			for (size_t k = 0; k < codes->dialect->words[i]->count; k++)
				count_word(codes, line, block, &codes->dialect->words[i]->rows[k]);
		}
	}
	reader_release(&reader);
}

static int in_order(const void *first, const void *second)
{
	const struct scan_code *a = first, *b = second;
	/* Words come last. */
	int letters = (a->letter ? a->letter : 'Z') - (b->letter ? b->letter : 'Z');

	if (letters != 0)
		return letters;
	if (a->number != b->number)
		return a->number < b->number ? -1 : 1;
	return a->word && b->word ? strcmp(a->word->word, b->word->word) : 0;
}

static void add_row(struct strbuf *out, const struct dialect *dialect, const struct scan_code *item)
{
	const struct code *code =
	    item->letter ? code_find(item->letter == 'G' ? dialect->g_codes : dialect->m_codes, item->number) : NULL;

	if (item->word)
		strbuf_addf(out, "%s", item->word->word);
	else if (item->letter == 'G' && item->number % 10)
		strbuf_addf(out, "G%d.%d", item->number / 10, item->number % 10);
	else
		strbuf_addf(out, "%c%d", item->letter, item->letter == 'G' ? item->number / 10 : item->number);
	strbuf_addf(out, "\t%ld\t%zu\t", item->times, item->programs);
	if (item->word)
		strbuf_addf(out, "%s\t%s\n", code_state_name(item->word->state), item->word->what);
	else if (code)
		strbuf_addf(out, "%s\t%s\n", code_state_name(code->state), code->what);
	else
		strbuf_addf(out, "unknown\tnot a code of the %s dialect\n", dialect->name);
}

void scan_codes_add(struct strbuf *out, struct scan_codes *codes)
{
	if (codes->count > 0)
		qsort(codes->items, codes->count, sizeof(*codes->items), in_order);
	strbuf_addf(out, "code\ttimes\tprograms\tstate\twhat\n");
	for (size_t i = 0; i < codes->count; i++)
		add_row(out, codes->dialect, &codes->items[i]);
}
