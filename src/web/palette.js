// @ts-check
// palette.js - the colours of the scene, as the style sheet names them: --scene-part: #d9b26f.

/** @typedef {import('./model.js').Vec3} Vec3 */

/** @param {string} text #rrggbb @returns {Vec3} */
export function rgb(text) {
	const n = parseInt(text.trim().slice(1), 16);
	return [(n >> 16 & 255) / 255, (n >> 8 & 255) / 255, (n & 255) / 255];
}

/** @param {string} name @returns {Vec3} */
export const sceneColour = (name) => rgb(cssColour(`scene-${name}`));

/** @param {string} name @returns {string} */
export const cssColour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim() || '#808080';

/** @param {Vec3} a @param {Vec3} b @param {number} share of b @returns {Vec3} */
export const mix = (a, b, share) => [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share];
