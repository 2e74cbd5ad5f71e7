// @ts-check
// numbers.js - small helpers for columns of numbers.

/**
 * The index of the first number of at least x; the length if there is none.
 * @param {ArrayLike<number>} column in order @param {number} x
 */
export function lowerBound(column, x) {
	let low = 0, high = column.length;
	while (low < high) {
		const middle = low + high >> 1;
		if (column[middle] < x) low = middle + 1;
		else high = middle;
	}
	return low;
}

/** @param {number} z @returns {number} 0, -1, 1, -2, 2 ... */
export const unzigzag = (z) => z % 2 ? -(z + 1) / 2 : z / 2;
