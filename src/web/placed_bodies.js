// @ts-check
// placed_bodies.js - the bodies as they stand at one pose: which are there, what a ray meets first, how large they are.

import {linkPoses} from './kinematics.js';
import {MeshTree} from './mesh_tree.js';
import {add, norm, place, placeBack, scale, sub, turnBack} from './vec.js';

/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {{body: number, distance: number, point: Vec3, triangle: number}} Hit */

export class PlacedBodies {
	/** @param {Model} model */
	constructor(model) {
		this.model = model;
		this.bodies = model.bodies;
		/** @type {(MeshTree|undefined)[]} */
		this.trees = [];
		this.spheres = this.bodies.map((body) => sphereOf(body.mesh.positions));
		this.links = linkPoses(model.axes, model.axes.map(() => 0));
		this.tool = -1;
		/** Bodies that the user has hidden. @type {Set<number>} */
		this.hidden = new Set();
	}

	/** @param {number[]} values of the axes @param {number} tool number of the tool in the spindle */
	moveTo(values, tool) {
		this.links = linkPoses(this.model.axes, values);
		this.tool = tool;
	}

	/** @param {number} body */
	matrix(body) {
		return this.links[this.bodies[body].link];
	}

	/** Is the body on the machine now, and not hidden? @param {number} body */
	shown(body) {
		const {tool} = this.bodies[body];
		return !this.hidden.has(body) && (!tool || tool === this.tool);
	}

	/** @returns {number[]} */
	all() {
		return this.bodies.map((_, i) => i).filter((i) => this.shown(i));
	}

	/** @param {number} body @returns {{centre: Vec3, radius: number}} */
	sphere(body) {
		const {centre, radius} = this.spheres[body];
		return {centre: place(this.matrix(body), centre), radius};
	}

	/** A sphere around some bodies. @param {number[]} bodies @returns {{centre: Vec3, radius: number}} */
	around(bodies) {
		const spheres = bodies.map((i) => this.sphere(i)).filter((s) => s.radius > 0);
		if (!spheres.length) return {centre: [0, 0, 0], radius: 100};
		/** @type {Vec3[]} */
		const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
		for (const {centre, radius} of spheres) {
			for (let k = 0; k < 3; k++) {
				low[k] = Math.min(low[k], centre[k] - radius);
				high[k] = Math.max(high[k], centre[k] + radius);
			}
		}
		const centre = scale(add(low, high), 0.5);
		return {centre, radius: Math.max(...spheres.map((s) => norm(sub(s.centre, centre)) + s.radius))};
	}

	/**
	 * The first hit of a ray.
	 * @param {Vec3} origin @param {Vec3} direction unit @param {number} limit @param {number[]} bodies @returns {Hit|null}
	 */
	hit(origin, direction, limit, bodies = this.all()) {
		/** @type {Hit|null} */
		let best = null;
		for (const body of bodies) {
			const {centre, radius} = this.sphere(body);
			const to = sub(centre, origin);
			const along = to[0] * direction[0] + to[1] * direction[1] + to[2] * direction[2];
			if (norm(sub(to, scale(direction, along))) > radius) continue;
			const tree = this.trees[body] ||= new MeshTree(this.bodies[body].mesh);
			const matrix = this.matrix(body);
			const found = tree.hit(placeBack(matrix, origin), turnBack(matrix, direction), limit);
			if (!found) continue;
			limit = found.distance;
			best = {body, ...found, point: add(origin, scale(direction, found.distance))};
		}
		return best;
	}
}

/** The middle of the box around the points, and their largest distance from it. @param {Float32Array} p */
function sphereOf(p) {
	/** @type {Vec3[]} */
	const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
	for (let i = 0; i < p.length; i++) {
		low[i % 3] = Math.min(low[i % 3], p[i]);
		high[i % 3] = Math.max(high[i % 3], p[i]);
	}
	/** @type {Vec3} */
	const centre = p.length ? scale(add(low, high), 0.5) : [0, 0, 0];
	let radius = 0;
	for (let i = 0; i < p.length; i += 3) radius = Math.max(radius, Math.hypot(p[i] - centre[0], p[i + 1] - centre[1], p[i + 2] - centre[2]));
	return {centre, radius};
}
