// @ts-check
// kinematics.js - where the links stand when the axes are at given values.

import {identity, multiply, rotation, scale, translation} from './vec.js';

/** @typedef {import('./model.js').Axis} Axis */

/**
 * @param {Axis[]} axes	a carrying axis before what it carries
 * @param {number[]} values	mm and degrees
 * @returns {number[][]} by link, what takes its geometry at the zero pose to where it stands
 */
export function linkPoses(axes, values) {
	const poses = [identity()];
	axes.forEach((axis, i) => {
		const own = axis.rotary
			? rotation(axis.direction, axis.location, values[i] * Math.PI / 180)
			: translation(scale(axis.direction, values[i]));
		poses.push(multiply(poses[axis.parent], own));
	});
	return poses;
}
