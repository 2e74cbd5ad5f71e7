#include "report/format/digest.h"

#include <errno.h>
#include <nettle/sha2.h>
#include <nettle/version.h>
#include <stdint.h>
#include <stdio.h>

#include "base/mem.h"

static void write_digest(char digest[DIGEST_SIZE], struct sha256_ctx *context)
{
	static const char digits[] = "0123456789abcdef";
	uint8_t bytes[SHA256_DIGEST_SIZE];

#if NETTLE_VERSION_MAJOR >= 4
	sha256_digest(context, bytes);
#else
	sha256_digest(context, sizeof(bytes), bytes);
#endif
	for (size_t i = 0; i < sizeof(bytes); i++) {
		digest[2 * i] = digits[bytes[i] >> 4];
		digest[2 * i + 1] = digits[bytes[i] & 15];
	}
	digest[2 * sizeof(bytes)] = '\0';
}

void digest_bytes(char digest[DIGEST_SIZE], const char *bytes, size_t count)
{
	struct sha256_ctx context;

	sha256_init(&context);
	sha256_update(&context, count, (const uint8_t *)bytes);
	write_digest(digest, &context);
}

bool digest_file(char digest[DIGEST_SIZE], const char *path, const struct cancel *cancel)
{
	struct sha256_ctx context;
	uint8_t bytes[16384];
	FILE *in = fopen(path, "rb");
	size_t count;
	int error;

	if (!in && errno == ENOMEM)
		mem_exhausted();
	if (!in)
		return false;
	sha256_init(&context);
	errno = 0;
	while (!cancel_asked(cancel) && (count = fread(bytes, 1, sizeof(bytes), in)) > 0)
		sha256_update(&context, count, bytes);
	if (ferror(in))
		error = errno ? errno : EIO;
	else
		error = cancel_asked(cancel) ? ECANCELED : 0;
	fclose(in);
	errno = error;
	if (!error)
		write_digest(digest, &context);
	return !error;
}
