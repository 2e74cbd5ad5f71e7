// @ts-check
// proof.js - the proof made visible: the plane half-way between the nearest triangles of the nearest two bodies.

import {cross, multiply, place, scale, translation, turn, unit} from './vec.js';

/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {import('./placed_bodies.js').PlacedBodies} PlacedBodies */

/** The row that is valid at a time, or -1: nothing is near. @param {Model} model @param {number} time */
function rowAt({planes}, time) {
	if (!planes) return -1;
	let low = 0, high = planes.time.length;
	while (low < high) {
		const middle = low + high >> 1;
		if (planes.time[middle] <= time + 1e-9) low = middle + 1;
		else high = middle;
	}
	return low && planes.pair[low - 1] >= 0 ? low - 1 : -1;
}

/**
 * The current place of the plane, and the bodies that it separates.
 * @param {Model} model
 * @param {number} time
 * @param {PlacedBodies} placed
 * @returns {{bodies: [number, number], point: Vec3, normal: Vec3, size: number}|null}
 */
export function planeAt(model, time, placed) {
	const row = rowAt(model, time);
	if (row < 0 || !model.planes) return null;
	const {a, b} = model.pairs[model.planes.pair[row]];
	const at = (/** @type {Float64Array[]} */ columns) => /** @type {Vec3} */ (columns.map((column) => column[row]));
	const point = place(placed.matrix(a), at(model.planes.point)), normal = unit(turn(placed.matrix(a), at(model.planes.normal)));
	return {bodies: [a, b], point, normal, size: Math.max(20, 1.5 * Math.min(placed.sphere(a).radius, placed.sphere(b).radius))};
}

/** The plane as a square with a grid. @param {NonNullable<ReturnType<planeAt>>} plane @param {Vec3} colour @returns {import('./scene.js').Extra} */
export function planeExtra({point, normal, size}, colour) {
	const u = scale(unit(cross(normal, Math.abs(normal[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0])), size);
	const square = multiply(translation(point), [...u, 0, ...cross(normal, u), 0, ...normal, 0, 0, 0, 0, 1]);
	const corners = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0];
	return {positions: Float32Array.from(corners), matrix: square, colour, kind: 'plane'};
}

/** The meaning of the plane, in words. @param {Model} model @param {number} time */
export function proofSentence(model, time) {
	const row = rowAt(model, time);
	if (row < 0 || !model.planes) return 'Proof: no bodies are near each other here; each pair is farther apart than is measured.';
	const pair = model.pairs[model.planes.pair[row]];
	const name = (/** @type {number} */ body) => model.bodies[body].name;
	return `Proof: ${name(pair.a)} and ${name(pair.b)} have the smallest clearance that is proved here; their nearest triangles were ${model.planes.distance[row].toFixed(3)} mm ` +
		`apart at ${model.planes.time[row].toFixed(2)} s. This plane lies half-way between them and moves with ${name(pair.a)}.`;
}
