// @ts-check
// overlay.js - what is drawn over the picture: the ring at a contact, names with a line to their body, measures, directions.

import {h, svg} from './elements.js';

/** @typedef {import('./camera.js').Camera} Camera */

/** The names are between the buttons and the axes' positions. */
const EDGE = 46;

export class Overlay {
	constructor() {
		this.drawing = svg('svg', {'aria-hidden': 'true', class: 'overlay'});
		this.labels = h('div', {class: 'labels', 'aria-hidden': 'true'});
		this.width = this.height = 1;
		this.top = EDGE;
	}

	/** @param {number} width @param {number} height */
	clear(width, height) {
		this.width = width;
		this.height = height;
		// On a phone the axes' positions are as wide as the picture.
		const positions = /** @type {HTMLElement|null|undefined} */ (this.labels.parentElement?.querySelector('.readout'));
		this.top = positions && positions.offsetWidth > 0.6 * width ? positions.offsetTop + positions.offsetHeight + 4 : EDGE;
		this.drawing.replaceChildren();
		this.labels.replaceChildren();
	}

	/** @param {number} x @param {number} y */
	ring(x, y) {
		this.drawing.append(
			svg('circle', {cx: x, cy: y, r: 22, class: 'ring-halo'}),
			svg('circle', {cx: x, cy: y, r: 22, class: 'ring'}));
	}

	/** @param {string} kind class of its style @param {number[]} from @param {number[]} to */
	line(kind, from, to) {
		this.drawing.append(svg('line', {x1: from[0], y1: from[1], x2: to[0], y2: to[1], class: kind}));
	}

	/** @param {string} kind @param {number} x @param {number} y @param {number} r */
	dot(kind, x, y, r = 4) {
		this.drawing.append(svg('circle', {cx: x, cy: y, r, class: kind}));
	}

	/** A box of text beside a point; it stays within the picture. @param {string} kind @param {string} text @param {number} x @param {number} y */
	label(kind, text, x, y) {
		const label = h(`span.label.${kind}`, {}, text);
		this.labels.append(label);
		const w = label.offsetWidth, tall = label.offsetHeight;
		const left = Math.max(4, Math.min(this.width - w - 4, x - w / 2)), top = Math.max(this.top, Math.min(this.height - tall - EDGE, y - tall / 2));
		label.style.left = `${left}px`;
		label.style.top = `${top}px`;
		return {left, top, right: left + w, bottom: top + tall};
	}

	/** The directions of the machine in the corner. @param {Camera} camera */
	triad(camera) {
		const x = 44, y = this.height - 44;
		const r = camera.right(), u = camera.up();
		['X', 'Y', 'Z'].forEach((name, k) => {
			const dx = r[k], dy = -u[k];
			this.line(`triad triad-${name}`, [x, y], [x + 26 * dx, y + 26 * dy]);
			const text = svg('text', {x: x + 35 * dx, y: y + 35 * dy + 4, class: `triad-name triad-${name}`});
			text.textContent = name;
			this.drawing.append(text);
		});
	}
}
