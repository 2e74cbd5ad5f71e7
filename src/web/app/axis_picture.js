// @ts-check
/**
 * axis_picture.js - explains separating axes: two polygons, a direction that can be rotated, and their shadows on it.
 */
import {element} from './page.js';

/** @typedef {[number, number]} Point */

/** @type {Point[]} */
const ONE = [[-92, -34], [-38, -52], [-12, -8], [-46, 44], [-88, 26]];
/** @type {Point[]} */
const OTHER = [[22, -6], [66, -44], [96, 2], [70, 46], [28, 40]];
/** The distance of the line with the shadows from the middle, outside the polygons. */
const BELOW = 118;

/**
 * The range that the polygon covers along a direction.
 * @param {Point[]} polygon @param {Point} direction
 * @returns {[number, number]}
 */
export function shadow(polygon, [x, y]) {
	const along = polygon.map(([px, py]) => px * x + py * y);
	return [Math.min(...along), Math.max(...along)];
}

/** The gap between the shadows along a direction (degrees); negative: they overlap. @param {number} degrees */
export function gapAt(degrees) {
	const angle = degrees * Math.PI / 180, direction = /** @type {Point} */ ([Math.cos(angle), Math.sin(angle)]);
	const a = shadow(ONE, direction), b = shadow(OTHER, direction);
	return Math.max(b[0] - a[1], a[0] - b[1]);
}

/** @param {string} tag @param {Record<string, string | number>} attributes */
function svg(tag, attributes) {
	const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
	for (const [name, value] of Object.entries(attributes))
		made.setAttribute(name, String(value));
	return made;
}

/** @returns {HTMLElement} */
export function axisPicture() {
	const drawing = svg('svg', {viewBox: '-215 -140 430 280', role: 'img', 'aria-label': 'Two polygons and their shadows on a turned axis'});
	const moved = svg('g', {}), told = element('p', {className: 'verdict', role: 'status'});
	const slider = /** @type {HTMLInputElement} */ (element('input', {type: 'range', id: 'axis-angle', min: -90, max: 90, step: 1, value: 55}));
	for (const [polygon, name] of /** @type {[Point[], string][]} */ ([[ONE, 'one'], [OTHER, 'other']]))
		drawing.append(svg('polygon', {points: polygon.join(' '), class: `solid ${name}`}));
	drawing.append(moved);
	const show = () => {
		const degrees = Number(slider.value), angle = degrees * Math.PI / 180, c = Math.cos(angle), s = Math.sin(angle);
		const gap = gapAt(degrees), a = shadow(ONE, [c, s]), b = shadow(OTHER, [c, s]);
		/**
		 * A point on the axis, which is beside the polygons.
		 * @param {number} t @param {number} off @returns {Point}
		 */
		const at = (t, off) => [t * c - off * s, t * s + off * c];
		const line = (/** @type {Point} */ p, /** @type {Point} */ q, /** @type {string} */ name) => svg('line', {x1: p[0], y1: p[1], x2: q[0], y2: q[1], class: name});
		const parts = [line(at(-140, BELOW), at(140, BELOW), 'axis'), line(at(a[0], BELOW - 3), at(a[1], BELOW - 3), 'shadow one'),
			line(at(b[0], BELOW + 3), at(b[1], BELOW + 3), 'shadow other')];
		// At the end of a shadow, a ray of the light touches the polygon.
		for (const [polygon, ends, name] of /** @type {[Point[], Point, string][]} */ ([[ONE, a, 'one'], [OTHER, b, 'other']])) {
			for (const end of ends) {
				const [x, y] = polygon.reduce((best, point) => Math.abs(point[0] * c + point[1] * s - end) < Math.abs(best[0] * c + best[1] * s - end) ? point : best);
				parts.push(line(at(end, -x * s + y * c), at(end, BELOW), `ray ${name}`));
			}
		}
		if (gap > 0) {
			const middle = a[1] < b[0] ? (a[1] + b[0]) / 2 : (b[1] + a[0]) / 2;
			parts.push(line(at(middle, -BELOW), at(middle, BELOW + 12), 'wall'));
		}
		moved.replaceChildren(...parts);
		told.dataset.verdict = gap > 0 ? 'clear' : 'incomplete';
		told.textContent = gap > 0 ? `The shadows are ${gap.toFixed(1)} mm apart: the solids are at least so far apart.`
			: 'The shadows overlap: this direction proves nothing.';
	};
	slider.addEventListener('input', show);
	show();
	return element('div', {className: 'axis-picture'}, drawing, element('label', {htmlFor: 'axis-angle'}, 'Turn the direction'), slider, told);
}
