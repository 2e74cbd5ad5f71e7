// @ts-check
// pyramid.js - the least and the greatest clearance of any stretch of time, without a walk over all intervals.

/** @typedef {import('./model.js').Clearance} Clearance */

/** The interval that contains a time, or -1. @param {Clearance} clearance @param {number} time */
export function leastOf({times, least}, time) {
	let low = 0, high = least.length;
	while (low < high) {
		const middle = low + high >> 1;
		if (times[middle] <= time) low = middle + 1;
		else high = middle;
	}
	return low - 1;
}

export class Pyramid {
	/** @param {Clearance} clearance */
	constructor(clearance) {
		this.clearance = clearance;
		/**
		 * Minima and maxima of one, two, four, ... intervals.
		 * @type {{low: Float64Array, high: Float64Array}[]}
		 */
		this.levels = [{low: clearance.least, high: clearance.most}];
		for (let below = this.levels[0]; below.low.length > 1; below = this.levels[this.levels.length - 1]) {
			const count = below.low.length + 1 >> 1;
			const low = new Float64Array(count), high = new Float64Array(count);
			for (let i = 0; i < count; i++) {
				const other = Math.min(2 * i + 1, below.low.length - 1);
				low[i] = Math.min(below.low[2 * i], below.low[other]);
				high[i] = Math.max(below.high[2 * i], below.high[other]);
			}
			this.levels.push({low, high});
		}
	}

	/** @param {number} from @param {number} to seconds @returns {[number, number]|null} mm */
	range(from, to) {
		const {clearance, levels} = this;
		if (!clearance.least.length) return null;
		let first = Math.max(0, leastOf(clearance, from)), last = Math.max(first, leastOf(clearance, to));
		let low = Infinity, high = -Infinity;
		const take = (/** @type {number} */ level, /** @type {number} */ i) => {
			low = Math.min(low, levels[level].low[i]);
			high = Math.max(high, levels[level].high[i]);
		};
		for (let level = 0; first <= last; level++) {
			if (first & 1) take(level, first++);
			if (!(last & 1)) take(level, last--);
			first >>= 1;
			last >>= 1;
		}
		return [low, high];
	}
}
