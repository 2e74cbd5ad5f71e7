#include "base/file_signature.h"

#include <stdbool.h>
#include <string.h>

#define SAVE_AS_UTF8 ": save it as UTF-8 (a text editor does)"
#define UNPACK ": unpack it first"

/* The first match is used: the mark of UTF-32 begins with that of UTF-16. */
static const struct signature {
	const char *bytes;
	size_t length;
	const char *advice;
} signatures[] = {
	{"\x1f\x8b", 2, "this file is compressed by gzip" UNPACK},
	{"BZh", 3, "this file is compressed by bzip2" UNPACK},
	{"\xfd" "7zXZ", 5, "this file is compressed by xz" UNPACK},
	{"\x28\xb5\x2f\xfd", 4, "this file is compressed by zstd" UNPACK},
	{"7z\xbc\xaf", 4, "this is a 7z archive" UNPACK},
	{"Rar!", 4, "this is a RAR archive" UNPACK},
	{"PK\003\004", 4, "this is a zip archive, or a document of a word processor or spreadsheet: unpack it first, "
			  "or save the document as plain text"},
	{"\xd0\xcf\x11\xe0", 4, "this is an office document: save it as plain text"},
	{"{\\rtf", 5, "this is a formatted document (RTF): save it as plain text"},
	{"%PDF-", 5, "this is a PDF document: give the file from which it was made"},
	{"\xff\xfe\0", 4, "this file is in UTF-32" SAVE_AS_UTF8},
	{"\0\0\xfe\xff", 4, "this file is in UTF-32" SAVE_AS_UTF8},
	{"\xff\xfe", 2, "this file is in UTF-16" SAVE_AS_UTF8},
	{"\xfe\xff", 2, "this file is in UTF-16" SAVE_AS_UTF8},
};

static bool is_ascii(char byte)
{
	return byte && !((unsigned char)byte & 0x80);
}

/* Two ASCII characters, each with a NUL before or after it: UTF-16 without a mark. */
static bool is_utf16(const char *bytes, size_t length)
{
	const bool swapped = length >= 4 && !bytes[0];

	return length >= 4 && is_ascii(bytes[swapped]) && is_ascii(bytes[2 + swapped]) && !bytes[!swapped] &&
	       !bytes[2 + !swapped];
}

const char *file_signature_advice(const char *bytes, size_t length)
{
	for (size_t i = 0; i < sizeof(signatures) / sizeof(*signatures); i++)
		if (length >= signatures[i].length && !memcmp(bytes, signatures[i].bytes, signatures[i].length))
			return signatures[i].advice;
	return is_utf16(bytes, length) ? "this file is in UTF-16" SAVE_AS_UTF8 : NULL;
}
