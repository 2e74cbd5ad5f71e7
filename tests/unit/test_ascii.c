/* Letters, digits and blanks: every byte against the C library, which is in the C locale here. */
#include <ctype.h>
#include <strings.h>

#include "base/ascii.h"
#include "suite.h"

START_TEST(test_classes)
{
	for (int i = 0; i < 256; i++) {
		const char byte = (char)i;

		ck_assert_int_eq(ascii_is_digit(byte), isdigit(i) != 0);
		ck_assert_int_eq(ascii_is_letter(byte), isalpha(i) != 0);
		ck_assert_int_eq(ascii_is_alphanumeric(byte), isalnum(i) != 0);
		ck_assert_int_eq(ascii_is_space(byte), isspace(i) != 0);
		ck_assert_int_eq((unsigned char)ascii_upper(byte), toupper(i));
		ck_assert_int_eq((unsigned char)ascii_lower(byte), tolower(i));
	}
}
END_TEST

START_TEST(test_same)
{
	static const char *const texts[] = {"", "A", "a", "ab", "aB", "AB", "b", "a1", "\xe4", "\xc4", "[", "{"};

	for (int i = 0; i < COUNT(texts); i++) {
		for (int k = 0; k < COUNT(texts); k++) {
			ck_assert_int_eq(ascii_same(texts[i], texts[k]), strcasecmp(texts[i], texts[k]) == 0);
			for (size_t n = 0; n < 4; n++)
				ck_assert_int_eq(ascii_same_start(texts[i], texts[k], n),
						 strncasecmp(texts[i], texts[k], n) == 0);
		}
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {test_classes, test_same};

	return RUN_TESTS("ascii", tests);
}
