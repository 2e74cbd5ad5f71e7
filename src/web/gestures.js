// @ts-check
// gestures.js - mouse, touch and pen on a canvas: turn, move, zoom, tap.

/**
 * @typedef {Object} Moves
 * @property {(dx: number, dy: number) => void} turn pixels
 * @property {(dx: number, dy: number) => void} move pixels
 * @property {(factor: number, x: number, y: number) => void} zoom
 * @property {(x: number, y: number) => void} tap
 * @property {(x: number, y: number) => void} twice
 */

const STILL = 5;

/**
 * One finger or the left button rotates; two fingers, the other buttons or shift move.
 * @param {HTMLElement} element @param {Moves} moves
 */
export function watchGestures(element, moves) {
	/** @type {Map<number, {x: number, y: number}>} */
	const down = new Map();
	let travelled = 0;
	let lastTap = {time: -Infinity, x: 0, y: 0};

	const local = (/** @type {MouseEvent} */ e) => {
		const box = element.getBoundingClientRect();
		return {x: e.clientX - box.left, y: e.clientY - box.top};
	};
	const spread = () => {
		const [a, b] = [...down.values()];
		return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, size: Math.hypot(a.x - b.x, a.y - b.y) || 1};
	};

	element.addEventListener('pointerdown', (e) => {
		element.setPointerCapture(e.pointerId);
		if (!down.size) travelled = 0;
		down.set(e.pointerId, local(e));
	});
	element.addEventListener('pointermove', (e) => {
		const before = down.get(e.pointerId);
		if (!before) return;
		const now = local(e);
		const dx = now.x - before.x, dy = now.y - before.y;
		travelled += Math.hypot(dx, dy);
		if (down.size === 2) {
			const old = spread();
			down.set(e.pointerId, now);
			const next = spread();
			moves.move(next.x - old.x, next.y - old.y);
			moves.zoom(old.size / next.size, next.x, next.y);
			return;
		}
		down.set(e.pointerId, now);
		if (travelled < STILL) return;
		if (e.shiftKey || e.buttons & 6) moves.move(dx, dy);
		else moves.turn(dx, dy);
	});
	element.addEventListener('pointerup', (e) => {
		const {x, y} = local(e);
		const single = down.delete(e.pointerId) && !down.size && travelled < STILL && e.button === 0;
		if (!single) return;
		if (e.timeStamp - lastTap.time < 350 && Math.hypot(x - lastTap.x, y - lastTap.y) < 12) moves.twice(x, y);
		else moves.tap(x, y);
		lastTap = {time: e.timeStamp, x, y};
	});
	element.addEventListener('pointercancel', (e) => down.delete(e.pointerId));
	element.addEventListener('contextmenu', (e) => e.preventDefault());
	element.addEventListener('wheel', (e) => {
		e.preventDefault();
		const {x, y} = local(e);
		moves.zoom(Math.exp(e.deltaY * (e.deltaMode ? 0.05 : 0.0015)), x, y);
	}, {passive: false});
}
