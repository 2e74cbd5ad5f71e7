// @ts-check
// mesh_tree.js - which triangle of a mesh a ray meets first: a tree of boxes, split in the middle of the longest side.

/** @typedef {import('./model.js').Mesh} Mesh */
/** @typedef {import('./model.js').Vec3} Vec3 */

const LEAF = 8;

export class MeshTree {
	/** @param {Mesh} mesh */
	constructor(mesh) {
		this.mesh = mesh;
		const count = mesh.indices.length / 3;
		this.order = new Uint32Array(count);
		for (let t = 0; t < count; t++) this.order[t] = t;
		/** Six numbers for each node. @type {number[]} */
		this.boxes = [];
		/** First triangle, count; or count 0 and the second child (the first one follows). @type {number[]} */
		this.nodes = [];
		if (count) this.build(0, count, triangleBoxes(mesh));
	}

	/** @param {number} first @param {number} end @param {Float32Array} sides of the triangles' boxes @returns {number} */
	build(first, end, sides) {
		const node = this.nodes.length / 2;
		const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
		for (let i = first; i < end; i++) {
			const t = 6 * this.order[i];
			for (let k = 0; k < 3; k++) {
				if (sides[t + k] < low[k]) low[k] = sides[t + k];
				if (sides[t + 3 + k] > high[k]) high[k] = sides[t + 3 + k];
			}
		}
		this.boxes.push(...low, ...high);
		this.nodes.push(first, end - first);
		if (end - first <= LEAF) return node;
		let axis = 0;
		for (let k = 1; k < 3; k++) if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
		const twice = low[axis] + high[axis];
		let split = first;
		for (let i = first; i < end; i++) {
			const t = this.order[i];
			if (sides[6 * t + axis] + sides[6 * t + 3 + axis] >= twice) continue;
			this.order[i] = this.order[split];
			this.order[split++] = t;
		}
		if (split === first || split === end) split = first + end >> 1;
		this.build(first, split, sides);
		this.nodes[2 * node] = this.build(split, end, sides);
		this.nodes[2 * node + 1] = 0;
		return node;
	}

	/**
	 * @param {Vec3} o origin, in the mesh's frame
	 * @param {Vec3} d unit direction
	 * @param {number} limit only what is nearer counts
	 * @returns {{distance: number, triangle: number}|null}
	 */
	hit(o, d, limit) {
		if (!this.nodes.length) return null;
		let best = null;
		const stack = [0];
		while (stack.length) {
			const node = /** @type {number} */ (stack.pop());
			if (!this.meetsBox(node, o, d, limit)) continue;
			const first = this.nodes[2 * node], count = this.nodes[2 * node + 1];
			if (!count) stack.push(first, node + 1);
			for (let i = first; i < first + count; i++) {
				const distance = this.meetsTriangle(this.order[i], o, d);
				if (distance >= limit) continue;
				limit = distance;
				best = {distance, triangle: this.order[i]};
			}
		}
		return best;
	}

	/** @param {number} node @param {Vec3} o @param {Vec3} d @param {number} limit */
	meetsBox(node, o, d, limit) {
		let near = 0, far = limit;
		for (let k = 0; k < 3; k++) {
			const a = (this.boxes[6 * node + k] - o[k]) / d[k], b = (this.boxes[6 * node + 3 + k] - o[k]) / d[k];
			// Not a number if the ray is in the box's side: this counts as inside.
			if (Math.min(a, b) > near) near = Math.min(a, b);
			if (Math.max(a, b) < far) far = Math.max(a, b);
		}
		return near <= far;
	}

	/** Infinity: there is no hit. @param {number} t @param {Vec3} o @param {Vec3} d */
	meetsTriangle(t, o, d) {
		const {positions: p, indices: i} = this.mesh;
		const a = 3 * i[3 * t], b = 3 * i[3 * t + 1], c = 3 * i[3 * t + 2];
		const e1x = p[b] - p[a], e1y = p[b + 1] - p[a + 1], e1z = p[b + 2] - p[a + 2];
		const e2x = p[c] - p[a], e2y = p[c + 1] - p[a + 1], e2z = p[c + 2] - p[a + 2];
		const px = d[1] * e2z - d[2] * e2y, py = d[2] * e2x - d[0] * e2z, pz = d[0] * e2y - d[1] * e2x;
		const det = e1x * px + e1y * py + e1z * pz;
		if (Math.abs(det) < 1e-12) return Infinity;
		const sx = o[0] - p[a], sy = o[1] - p[a + 1], sz = o[2] - p[a + 2];
		const u = (sx * px + sy * py + sz * pz) / det;
		const qx = sy * e1z - sz * e1y, qy = sz * e1x - sx * e1z, qz = sx * e1y - sy * e1x;
		const v = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
		const s = (e2x * qx + e2y * qy + e2z * qz) / det;
		return u < 0 || v < 0 || u + v > 1 || s <= 0 ? Infinity : s;
	}
}

/** @param {Mesh} mesh @returns {Float32Array} for each triangle its least x, y, z and its greatest */
function triangleBoxes({positions, indices}) {
	const sides = new Float32Array(2 * indices.length);
	for (let i = 0; i < indices.length; i += 3) {
		const a = 3 * indices[i], b = 3 * indices[i + 1], c = 3 * indices[i + 2];
		for (let k = 0; k < 3; k++) {
			sides[2 * i + k] = Math.min(positions[a + k], positions[b + k], positions[c + k]);
			sides[2 * i + 3 + k] = Math.max(positions[a + k], positions[b + k], positions[c + k]);
		}
	}
	return sides;
}
