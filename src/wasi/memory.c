/*
 * memory.c - copies and fills short blocks of memory.
 *
 * WebAssembly has instructions that copy and fill blocks of memory, but browsers execute them as calls of some 7 ns,
 * whatever the size. Each NC block copies dozens of short structs, which takes less than half of that time here. Only
 * this file is compiled for these instructions: elsewhere the compiler would use them for every struct.
 */
#include <stdint.h>
#include <string.h>

#include "base/axes.h"

enum { WORD = 8, SHORT = 8 * WORD, AXES = sizeof(axis_values) };

/* A word at any address. */
struct __attribute__((packed, may_alias)) word {
	uint64_t bits;
};

static const uint64_t EACH_BYTE = 0x0101010101010101;

/* Inlined with a known count. */
static inline void copy_words(char *to, const char *from, size_t count)
{
	for (size_t i = 0; i < count; i++)
		((struct word *)to)[i] = ((const struct word *)from)[i];
}

static inline void set_words(char *to, struct word word, size_t count)
{
	for (size_t i = 0; i < count; i++)
		((struct word *)to)[i] = word;
}

/* Copies two halves, which may overlap. */
static inline void copy_ends(char *to, const char *from, size_t size, size_t words)
{
	copy_words(to, from, words);
	copy_words(to + size - words * WORD, from + size - words * WORD, words);
}

void *memcpy(void *restrict to, const void *restrict from, size_t size)
{
	char *target = to;
	const char *source = from;

	if (size == AXES)
		copy_words(target, source, AXES / WORD);
	else if (size > SHORT)
		__builtin_memcpy(to, from, size);
	else if (size >= 4 * WORD)
		copy_ends(target, source, size, 4);
	else if (size >= 2 * WORD)
		copy_ends(target, source, size, 2);
	else if (size >= WORD)
		copy_ends(target, source, size, 1);
	else
		for (size_t i = 0; i < size; i++)
			target[i] = source[i];
	return to;
}

void *memset(void *to, int value, size_t size)
{
	const struct word word = {EACH_BYTE * (unsigned char)value};
	char *target = to;

	if (size == AXES) {
		set_words(target, word, AXES / WORD);
	} else if (size > SHORT) {
		__builtin_memset(to, value, size);
	} else if (size >= WORD) {
		for (size_t i = 0; i + WORD < size; i += WORD)
			set_words(target + i, word, 1);
		set_words(target + size - WORD, word, 1);
	} else {
		for (size_t i = 0; i < size; i++)
			target[i] = (char)value;
	}
	return to;
}

void *memmove(void *to, const void *from, size_t size)
{
	__builtin_memmove(to, from, size);
	return to;
}

int memcmp(const void *left, const void *right, size_t size)
{
	const unsigned char *a = left, *b = right;

	for (; size >= WORD && ((const struct word *)a)->bits == ((const struct word *)b)->bits; size -= WORD) {
		a += WORD;
		b += WORD;
	}
	for (; size > 0 && *a == *b; size--) {
		a++;
		b++;
	}
	return size ? *a - *b : 0;
}

void *memchr(const void *from, int value, size_t size)
{
	const uint64_t wanted = EACH_BYTE * (unsigned char)value;
	const unsigned char *at = from;

	for (; size >= WORD; at += WORD, size -= WORD) {
		const uint64_t rest = ((const struct word *)at)->bits ^ wanted;
		/* The lowest bit of `zero` is in the first zero byte of the rest. */
		const uint64_t zero = (rest - EACH_BYTE) & ~rest & EACH_BYTE << 7;

		if (zero)
			return (void *)(at + __builtin_ctzll(zero) / WORD);
	}
	for (; size > 0; at++, size--)
		if (*at == (unsigned char)value)
			return (void *)at;
	return NULL;
}
