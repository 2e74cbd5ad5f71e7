// @ts-check
// vec.js - vectors of three numbers and 4x4 matrices, column after column as WebGL wants them.

/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {number[]} Mat4 */

/** @param {Vec3} a @param {Vec3} b @returns {Vec3} */
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/** @param {Vec3} a @param {Vec3} b @returns {Vec3} */
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** @param {Vec3} a @param {number} s @returns {Vec3} */
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
/** @param {Vec3} a @param {Vec3} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Vec3} a @param {Vec3} b @returns {Vec3} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {Vec3} a */
export const norm = (a) => Math.hypot(a[0], a[1], a[2]);
/** @param {Vec3} a @returns {Vec3} the zero vector stays */
export const unit = (a) => scale(a, 1 / (norm(a) || 1));

/** @returns {Mat4} */
export const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** @param {Mat4} a @param {Mat4} b @returns {Mat4} */
export function multiply(a, b) {
	const out = new Array(16);
	for (let col = 0; col < 4; col++) {
		for (let row = 0; row < 4; row++) {
			let sum = 0;
			for (let k = 0; k < 4; k++) sum += a[k * 4 + row] * b[col * 4 + k];
			out[col * 4 + row] = sum;
		}
	}
	return out;
}

/** @param {Vec3} v @returns {Mat4} */
export const translation = (v) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, v[0], v[1], v[2], 1];

/**
 * A right-handed rotation about the unit vector u through the point p.
 * @param {Vec3} u @param {Vec3} p @param {number} radians @returns {Mat4}
 */
export function rotation(u, p, radians) {
	const c = Math.cos(radians), s = Math.sin(radians), k = 1 - c;
	const [x, y, z] = u;
	const m = [
		c + x * x * k, y * x * k + z * s, z * x * k - y * s, 0,
		x * y * k - z * s, c + y * y * k, z * y * k + x * s, 0,
		x * z * k + y * s, y * z * k - x * s, c + z * z * k, 0,
		0, 0, 0, 1,
	];
	const moved = turn(m, p);
	[m[12], m[13], m[14]] = sub(p, moved);
	return m;
}

/** A point. @param {Mat4} m @param {Vec3} p @returns {Vec3} */
export const place = (m, p) => add(turn(m, p), [m[12], m[13], m[14]]);

/** A direction. @param {Mat4} m @param {Vec3} d @returns {Vec3} */
export const turn = (m, d) => [
	m[0] * d[0] + m[4] * d[1] + m[8] * d[2],
	m[1] * d[0] + m[5] * d[1] + m[9] * d[2],
	m[2] * d[0] + m[6] * d[1] + m[10] * d[2],
];

/** A direction, transformed back. @param {Mat4} m rigid @param {Vec3} d @returns {Vec3} */
export const turnBack = (m, d) => [
	m[0] * d[0] + m[1] * d[1] + m[2] * d[2],
	m[4] * d[0] + m[5] * d[1] + m[6] * d[2],
	m[8] * d[0] + m[9] * d[1] + m[10] * d[2],
];

/** A point, transformed back. @param {Mat4} m rigid @param {Vec3} p @returns {Vec3} */
export const placeBack = (m, p) => turnBack(m, sub(p, [m[12], m[13], m[14]]));
