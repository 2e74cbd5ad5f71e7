// @ts-check
// tool_path.js - the way of the tool's tip as the workpiece sees it: lines that turn with the table.

import {linkPoses} from './kinematics.js';
import {add, norm, place, placeBack, scale, sub} from './vec.js';

/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {{feed: Float32Array, rapid: Float32Array, link: number}} Trace */

/** Points of the whole program: as many as are visible. */
const POINTS = 6000;
/** The largest ratio of a picture of the whole path to one of the feeds alone. */
const MOST_RAPID = 3;

/** @param {Model} model @returns {Trace|null} null: no tool moves */
export function toolTrace({path, axes, spindle, workholding, lengths}) {
	/** @type {number[][]} */
	const [feed, rapid] = [[], []];
	/** @type {Vec3|null} */
	let last = null;
	let lastTool = -1;
	for (const time of path.duration ? path.instants(POINTS) : []) {
		const {values, tool, motion} = path.pose(time);
		const length = lengths.get(tool);
		if (length === undefined) {
			last = null;
			continue;
		}
		const links = linkPoses(axes, values);
		const tip = place(links[spindle.link], add(spindle.location, scale(spindle.direction, length)));
		const point = placeBack(links[workholding], tip);
		if (last && tool === lastTool) (motion === 1 || motion === 4 ? rapid : feed).push(...last, ...point);
		last = point;
		lastTool = tool;
	}
	return feed.length || rapid.length ? {feed: Float32Array.from(feed), rapid: Float32Array.from(rapid), link: workholding} : null;
}

/** A sphere around points: the middle and half the diagonal of their box. @param {Float32Array[]} lists @returns {{centre: Vec3, radius: number}} */
function sphereAround(...lists) {
	/** @type {Vec3[]} */
	const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
	for (const points of lists) {
		points.forEach((value, i) => {
			low[i % 3] = Math.min(low[i % 3], value);
			high[i % 3] = Math.max(high[i % 3], value);
		});
	}
	return {centre: scale(add(low, high), 0.5), radius: norm(sub(high, low)) / 2};
}

/**
 * The part of a path to look at, in the frame of the work: all of it, or only the feeds if long rapids would make these
 * small.
 * @param {Trace} trace
 */
export function whereItWorks({feed, rapid}) {
	const whole = sphereAround(feed, rapid);
	const fed = feed.length ? sphereAround(feed) : whole;
	return whole.radius > MOST_RAPID * fed.radius ? fed : whole;
}
