#include "gcode/text/line_shape.h"

#include <stddef.h>
#include <string.h>

#include "base/ascii.h"
#include "base/axes.h"

static void write_shape(const char *line, bool blanks, char out[LINE_SHAPE_MAX])
{
	size_t length = 0;
	bool comment = false;

	for (; *line && *line != ';' && length < LINE_SHAPE_MAX - 1; line++) {
		comment = comment ? *line != ')' : *line == '(';
		if (!comment && *line != ')' && (blanks || !ascii_is_space(*line)))
			out[length++] = ascii_upper(*line);
	}
	out[length] = '\0';
}

void line_shape_squeeze(const char *line, char out[LINE_SHAPE_MAX])
{
	write_shape(line, false, out);
}

void line_shape_fold(const char *line, char out[LINE_SHAPE_MAX])
{
	write_shape(line, true, out);
}

static bool starts_value(char byte)
{
	return ascii_is_digit(byte) || (byte != '\0' && strchr("+-.#[", byte));
}

bool line_shape_moves_axes(const char *line)
{
	for (const char *at = line; *at; at++)
		if (slot_of_letter(ascii_upper(*at)) >= 0 &&
		    starts_value(at[1 + strspn(at + 1, " \t")]) && (at == line || !ascii_is_letter(at[-1])))
			return true;
	return false;
}

bool line_shape_has_word(const char *block)
{
	for (const char *at = block; *at; at++)
		if (ascii_is_letter(*at) && starts_value(at[1]))
			return true;
	return false;
}

bool line_shape_is_block(const char *block)
{
	const char *at = block + (*block == '/');

	while (ascii_is_letter(*at)) {
		size_t sign = at[1] == '+' || at[1] == '-', digits = strspn(at + 1 + sign, "0123456789.");

		if (digits == 0)
			return false;
		at += 1 + sign + digits;
	}
	return at > block && *at == '\0';
}

bool line_shape_is_program_number(const char *block)
{
	size_t digits;

	if (*block != 'O' && *block != ':')
		return false;
	digits = strspn(block + 1, "0123456789");
	return digits > 0 && block[1 + digits] == '\0';
}
