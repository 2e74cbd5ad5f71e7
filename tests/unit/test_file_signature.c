/* test_file_signature.c - archives, documents and encodings are recognised by their first bytes; text stays text. */
#include "base/file_signature.h"

#include <string.h>

#include "suite.h"

#define UTF16 "this file is in UTF-16: save it as UTF-8 (a text editor does)"
#define UTF32 "this file is in UTF-32: save it as UTF-8 (a text editor does)"

static void expect(const char *bytes, size_t length, const char *advice)
{
	const char *found = file_signature_advice(bytes, length);

	if (advice)
		ck_assert_str_eq(found, advice);
	else
		ck_assert_ptr_null(found);
}

/* "G1\n" as text editors of Windows save it, with and without the mark. */
START_TEST(encodings)
{
	expect("\xff\xfeG\0" "1\0\n\0", 8, UTF16);
	expect("\xfe\xff\0G\0" "1\0\n", 8, UTF16);
	expect("G\0" "1\0\n\0", 6, UTF16);
	expect("\0G\0" "1\0\n", 6, UTF16);
	expect("\xff\xfe\0\0G\0\0\0", 8, UTF32);
	expect("\0\0\xfe\xff\0\0\0G", 8, UTF32);
}
END_TEST

START_TEST(packed_files)
{
	expect("\x1f\x8b\x08\0", 4, "this file is compressed by gzip: unpack it first");
	expect("PK\003\004\x14\0\0\0", 8,
	       "this is a zip archive, or a document of a word processor or spreadsheet: unpack it first, or save the "
	       "document as plain text");
	expect("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", 8, "this is an office document: save it as plain text");
}
END_TEST

/* Programs, machines, the blank feed of a tape, a byte that is NUL by mistake, and files that end early. */
START_TEST(plain_text)
{
	static const char *const texts[] = {"%\nO0001\n", "<machine version=\"1\">", "\xef\xbb\xbfG0 X1", "%PPF", "PK", ""};

	for (size_t i = 0; i < sizeof(texts) / sizeof(*texts); i++)
		expect(texts[i], strlen(texts[i]), NULL);
	expect("G1\0X1\n", 6, NULL);
	expect("\0\0\0\0%\n", 6, NULL);
	expect("G\0" "1", 3, NULL);
	expect("\0\0", 2, NULL);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {encodings, packed_files, plain_text};

	return RUN_TESTS("file_signature", tests);
}
