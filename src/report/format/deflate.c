#include "report/format/deflate.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <zlib.h>

#include "base/mem.h"

static void *allocate(void *context, unsigned count, unsigned size)
{
	(void)context;
	/* Not zeroed: zlib expects no more than from malloc. */
	return mem_alloc((size_t)count * size);
}

static void release(void *context, void *block)
{
	(void)context;
	free(block);
}

void deflate_add(struct strbuf *out, const void *bytes, size_t count, enum deflate_level level)
{
	z_stream stream = {.zalloc = allocate, .zfree = release};
	unsigned char piece[16384];
	int state = deflateInit(&stream, (int)level);
	const unsigned char *next = bytes;

	/* The allocation cannot fail, and the version is the one that was compiled against. */
	assert(state == Z_OK);
	stream.next_in = (z_const Bytef *)next;
	do {
		const size_t rest = count - (size_t)(stream.next_in - next);

		stream.avail_in = rest > INT_MAX ? INT_MAX : (unsigned)rest;
		stream.next_out = piece;
		stream.avail_out = sizeof(piece);
		state = deflate(&stream, stream.avail_in == rest ? Z_FINISH : Z_NO_FLUSH);
		strbuf_add(out, (const char *)piece, sizeof(piece) - stream.avail_out);
	} while (state != Z_STREAM_END);
	deflateEnd(&stream);
}
