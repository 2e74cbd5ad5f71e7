// @ts-check
// tool_path.js - the way of the tool's tip as the workpiece sees it: lines that turn with the table.

import {linkPoses} from './kinematics.js';
import {dot, place, placeBack, sub} from './vec.js';

/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {{feed: Float32Array, rapid: Float32Array, link: number}} Trace */

/** Points of the whole program: as many as one sees. */
const POINTS = 6000;

/** The point of a tool that is farthest from its holder, and the link that carries it. @param {Model} model @param {number} tool */
function tipOf({bodies}, tool) {
	const parts = bodies.filter((body) => body.tool === tool && body.mesh.positions.length);
	const middle = (/** @type {Float32Array} */ p) => /** @type {Vec3} */ ([0, 1, 2].map((k) => {
		let low = Infinity, high = -Infinity;
		for (let i = k; i < p.length; i += 3) {
			low = Math.min(low, p[i]);
			high = Math.max(high, p[i]);
		}
		return (low + high) / 2;
	}));
	if (parts.length < 2) return null;
	const start = middle(parts[0].mesh.positions), end = middle(parts[parts.length - 1].mesh.positions);
	const along = sub(end, start);
	const {positions} = parts[parts.length - 1].mesh;
	let farthest = -Infinity;
	for (let i = 0; i < positions.length; i += 3) {
		farthest = Math.max(farthest, dot(along, sub([positions[i], positions[i + 1], positions[i + 2]], start)));
	}
	const share = farthest / (dot(along, along) || 1);
	/** @type {Vec3} */
	const tip = [start[0] + along[0] * share, start[1] + along[1] * share, start[2] + along[2] * share];
	return {tip, link: parts[0].link};
}

/** @param {Model} model @returns {Trace|null} null: there is no work, or no tool */
export function toolTrace(model) {
	const work = model.bodies.find((body) => body.role === 'part') || model.bodies.find((body) => body.role === 'fixture');
	if (!work || !model.path.duration) return null;
	const tips = new Map();
	const times = model.path.instants(POINTS);
	/** @type {number[][]} */
	const [feed, rapid] = [[], []];
	/** @type {Vec3|null} */
	let last = null;
	let lastTool = -1;
	for (const time of times) {
		const {values, tool, motion} = model.path.pose(time);
		if (!tips.has(tool)) tips.set(tool, tipOf(model, tool));
		const tip = tips.get(tool);
		if (!tip) {
			last = null;
			continue;
		}
		const links = linkPoses(model.axes, values);
		const point = placeBack(links[work.link], place(links[tip.link], tip.tip));
		if (last && tool === lastTool) (motion === 1 || motion === 4 ? rapid : feed).push(...last, ...point);
		last = point;
		lastTool = tool;
	}
	return {feed: Float32Array.from(feed), rapid: Float32Array.from(rapid), link: work.link};
}
