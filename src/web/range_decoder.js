// @ts-check
// range_decoder.js - bits out of a range coder whose probabilities adapt (src/report/format/range_coder.h).

const LEAST = 32, SEEN_MAX = 16, NUMBER_BITS = 34, NUMBER_MODELS = NUMBER_BITS * 4;

/** The learning rate of a model, by the number of bits seen. */
const SHIFTS = Uint8Array.from({length: SEEN_MAX + 1}, (_, seen) => Math.min(5, 32 - Math.clz32(seen + 1)));

/** The predictions of bits: `count` models. */
export class BitModels {
	/** @param {number} count */
	constructor(count) {
		this.p = new Uint16Array(count).fill(32768);
		this.seen = new Uint8Array(count);
	}
}

export class RangeDecoder {
	/** @param {Uint8Array} bytes */
	constructor(bytes) {
		this.bytes = bytes;
		this.at = 5;
		this.range = 2 ** 32 - 1;
		this.code = new DataView(bytes.buffer, bytes.byteOffset).getUint32(1);
		this.even = new BitModels(1);
	}

	/** @param {BitModels} models @param {number} index @returns {0|1} */
	bit({p, seen}, index) {
		const bound = (this.range >>> 16) * p[index];
		const shift = SHIFTS[seen[index]];
		const one = this.code < bound;
		if (one) {
			this.range = bound;
			p[index] = Math.min(65536 - LEAST, p[index] + (65536 - p[index] >> shift));
		} else {
			this.code -= bound;
			this.range -= bound;
			p[index] = Math.max(LEAST, p[index] - (p[index] >> shift));
		}
		if (seen[index] < SEEN_MAX) seen[index]++;
		while (this.range < 2 ** 24) {
			this.range *= 256;
			this.code = this.code * 256 + (this.bytes[this.at++] || 0);
		}
		return one ? 1 : 0;
	}

	/** @param {BitModels} models from numberModels() @param {number} [which] @returns {number} a whole number from 0 on */
	number(models, which = 0) {
		const base = which * NUMBER_MODELS;
		let length = 1, value = 1;
		while (length < NUMBER_BITS && this.bit(models, base + length)) length++;
		for (let i = 0; i < length - 1; i++) {
			if (i < 2) {
				value = 2 * value + this.bit(models, base + NUMBER_BITS + 3 * length + (i ? 1 + value % 2 : 0));
			} else {
				this.even.p[0] = 32768;
				value = 2 * value + this.bit(this.even, 0);
			}
		}
		return value - 1;
	}
}

/** @param {number} count of kinds of numbers */
export function numberModels(count) {
	return new BitModels(count * NUMBER_MODELS);
}
