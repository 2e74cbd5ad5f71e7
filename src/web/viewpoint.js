// @ts-check
// viewpoint.js - from where a contact can be seen, and which bodies stand in the way.

import {add, cross, dot, norm, scale, sub, unit} from './vec.js';

/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {import('./placed_bodies.js').PlacedBodies} PlacedBodies */

const FAR = 1e6;

/** Two directions perpendicular to d. @param {Vec3} d @returns {[Vec3, Vec3]} */
function across(d) {
	const u = unit(cross(d, Math.abs(d[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
	return [u, cross(d, u)];
}

/**
 * The direction from a contact to the eye. The two bodies in contact must not hide it; others may, because they can be
 * made faint. A view along the touching surfaces shows more than one perpendicular to them.
 * @param {PlacedBodies} placed
 * @param {Vec3} point
 * @param {number[]} focus the bodies in contact
 * @param {Vec3|null} normal of the surface at the contact
 * @returns {Vec3}
 */
export function bestDirection(placed, point, focus, normal) {
	const others = placed.all().filter((body) => !focus.includes(body));
	/** @type {Vec3} */
	let best = [0, -1, 0];
	let bestScore = -Infinity;
	for (let pitch = 8; pitch <= 68; pitch += 15) {
		for (let yaw = -180; yaw < 180; yaw += 24) {
			const c = Math.cos(pitch * Math.PI / 180);
			/** @type {Vec3} */
			const d = [Math.sin(yaw * Math.PI / 180) * c, -Math.cos(yaw * Math.PI / 180) * c, Math.sin(pitch * Math.PI / 180)];
			const [u, v] = across(d);
			let score = 0.5 * Math.cos((yaw - 25) * Math.PI / 180) + 0.6 * Math.cos((pitch - 28) * Math.PI / 90);
			if (normal) score -= 0.8 * Math.abs(dot(d, normal));
			for (const side of [[0, 0], [4, 0], [-4, 0], [0, 4], [0, -4]]) {
				const from = add(point, add(scale(d, 1), add(scale(u, side[0]), scale(v, side[1]))));
				if (!placed.hit(from, d, FAR, focus)) score += 0.6;
			}
			if (placed.hit(add(point, d), d, FAR, others)) score -= 0.15;
			if (score > bestScore) {
				bestScore = score;
				best = d;
			}
		}
	}
	return best;
}

/** The normal of a triangle of nine numbers; null if it has none. @param {number[]|undefined} t @returns {Vec3|null} */
export function normalOf(t) {
	const square = t ? cross([t[3] - t[0], t[4] - t[1], t[5] - t[2]], [t[6] - t[0], t[7] - t[1], t[8] - t[2]]) : null;
	return square && norm(square) > 0 ? unit(square) : null;
}

/**
 * The bodies between the eye and the point with a circle around it.
 * @param {PlacedBodies} placed
 * @param {Vec3} eye
 * @param {Vec3} point
 * @param {number} radius of the circle, mm
 * @param {number[]} focus never in the way
 * @returns {Set<number>}
 */
export function inTheWay(placed, eye, point, radius, focus) {
	const others = placed.all().filter((body) => !focus.includes(body));
	const [u, v] = across(unit(sub(point, eye)));
	/** @type {Set<number>} */
	const found = new Set();
	for (let k = 0; k <= 8; k++) {
		const r = k === 8 ? 0 : radius;
		const goal = add(point, add(scale(u, r * Math.cos(k * Math.PI / 4)), scale(v, r * Math.sin(k * Math.PI / 4))));
		const to = sub(goal, eye);
		for (const body of others) {
			// Bodies just behind the touched surface do not hide it.
			if (!found.has(body) && placed.hit(eye, unit(to), norm(to) - 3, [body])) found.add(body);
		}
	}
	return found;
}
