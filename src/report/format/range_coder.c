#include "report/format/range_coder.h"

enum { LEAST = 32, GREATEST = 65536 - LEAST, SLOWEST = 5, SEEN_MAX = 16 };

void range_coder_init(struct range_coder *coder, struct strbuf *out)
{
	*coder = (struct range_coder){.out = out, .range = UINT32_MAX, .held_back = 1};
}

/* Writes the highest byte of `low`. A byte is held back until no carry can change it. */
static void shift_out(struct range_coder *coder)
{
	if (coder->low < UINT32_C(0xff000000) || coder->low > UINT32_MAX) {
		const uint8_t carry = (uint8_t)(coder->low >> 32);
		uint8_t byte = coder->held;

		for (; coder->held_back; coder->held_back--) {
			const char text = (char)(uint8_t)(byte + carry);

			strbuf_add(coder->out, &text, 1);
			byte = 255;
		}
		coder->held = (uint8_t)(coder->low >> 24);
	}
	coder->held_back++;
	coder->low = (coder->low & 0xffffff) << 8;
}

/* For each number of bits seen: the number of bits of that number plus 1, up to SLOWEST. */
static const uint8_t shifts[SEEN_MAX + 1] = {1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, SLOWEST, SLOWEST};

static void learn(struct bit_model *model, uint32_t p, bool bit)
{
	const int shift = shifts[model->seen];

	p = bit ? p + ((65536 - p) >> shift) : p - (p >> shift);
	p = p < LEAST ? LEAST : p > GREATEST ? GREATEST : p;
	model->learnt = (uint16_t)(p - 32768);
	model->seen = model->seen < SEEN_MAX ? model->seen + 1 : SEEN_MAX;
}

void range_coder_bit(struct range_coder *coder, struct bit_model *model, bool bit)
{
	const uint32_t p = (uint16_t)(model->learnt + 32768), bound = (coder->range >> 16) * p;

	if (bit) {
		coder->range = bound;
	} else {
		coder->low += bound;
		coder->range -= bound;
	}
	for (; coder->range < UINT32_C(1) << 24; coder->range <<= 8)
		shift_out(coder);
	learn(model, p, bit);
}

void range_coder_number(struct range_coder *coder, struct number_model *model, uint32_t value)
{
	const uint64_t number = (uint64_t)value + 1;
	int length = 0;

	while (number >> length)
		length++;
	for (int i = 1; i < length; i++)
		range_coder_bit(coder, &model->length[i], true);
	range_coder_bit(coder, &model->length[length], false);
	for (int i = length - 2; i >= 0; i--) {
		const bool bit = number >> i & 1;
		struct bit_model even = {0};

		range_coder_bit(coder,
				i == length - 2	  ? &model->top[length][0]
				: i == length - 3 ? &model->top[length][1 + (number >> (i + 1) & 1)]
						  : &even,
				bit);
	}
}

void range_coder_finish(struct range_coder *coder)
{
	for (int i = 0; i < 5; i++)
		shift_out(coder);
}
