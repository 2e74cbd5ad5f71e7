// @ts-check
/** jog_stage.js - the picture of a machine whose axes are moved by hand: what meets is red, the nearest bodies are named. */
import {Stage} from './viewer/stage.js';
import {add, norm, scale, sub, unit} from './viewer/vec.js';

/** @typedef {import('./fivecheck.js').Pose} Pose */
/** @typedef {import('./viewer/model.js').Vec3} Vec3 */

export class JogStage extends Stage {
	/** @param {import('./viewer/state.js').State} state */
	constructor(state) {
		super(state);
		this.trace = false;
		this.proof = false;
		/** @type {Pose | null} */
		this.known = null;
	}

	/** @param {Pose | null} pose */
	tell(pose) {
		this.known = pose;
		this.change();
	}

	/** The bodies of a name that are on the machine now. @param {string} name */
	body(name) {
		return this.model.bodies.findIndex((body, i) => body.name === name && this.placed.shown(i));
	}

	/** What meets, as the viewer shows a finding. @returns {any} */
	finding() {
		const met = this.known?.meets[0] ?? this.known?.near[0];
		return met ? {kind: 'collision', bodies: met.map((name) => this.body(name)), point: null, triangles: null} : null;
	}

	/** The plane half-way between the nearest bodies. */
	plane() {
		const nearest = this.known?.nearest;
		if (!this.proof || !nearest || this.finding())
			return null;
		const a = /** @type {Vec3} */ (nearest.on_a), b = /** @type {Vec3} */ (nearest.on_b), bodies = [this.body(nearest.a), this.body(nearest.b)];
		const sizes = bodies.map((body) => this.placed.sphere(body).radius);
		return {bodies: /** @type {[number, number]} */ (bodies), point: scale(add(a, b), 0.5), normal: unit(sub(b, a)),
			size: Math.max(20, 1.2 * Math.min(...sizes))};
	}

	/** All bodies that meet, or else the nearest ones: nothing makes these faint. */
	involved() {
		const pairs = [...this.known?.meets ?? [], ...this.known?.near ?? []], nearest = this.known?.nearest;
		return (pairs.length ? pairs.flat() : nearest ? [nearest.a, nearest.b] : []).map((name) => this.body(name)).filter((body) => body >= 0);
	}

	/** What hides the contact is made faint; the camera stays where the user has put it. */
	focus() {
		const bodies = this.involved(), finding = this.finding();
		this.xray = !!finding || this.proof;
		const smallest = bodies.map((body) => this.placed.sphere(body)).sort((p, q) => p.radius - q.radius)[0];
		const {centre, radius} = smallest ?? this.placed.around(this.placed.all()), nearest = this.known?.nearest;
		return {bodies, point: !finding && nearest ? /** @type {Vec3} */ (nearest.on_a) : centre, radius};
	}

	/** All that meets is red, not one pair alone. @param {number} body @param {any} finding @param {[number, number] | undefined} apart */
	item(body, finding, apart) {
		const meets = finding && this.involved().includes(body);
		return super.item(body, meets ? {...finding, bodies: [body, -1]} : finding, apart);
	}

	/** The shortest way between the nearest bodies, with its length. @param {any} finding @param {number} width @param {number} height */
	annotate(finding, width, height) {
		super.annotate(finding, width, height);
		const nearest = this.known?.nearest;
		if (!nearest || finding)
			return;
		const a = /** @type {Vec3} */ (nearest.on_a), b = /** @type {Vec3} */ (nearest.on_b);
		const [from, to] = [a, b].map((point) => this.camera.project(point, width, height));
		this.overlay.line('measure', from, to);
		this.overlay.dot('measure-end', from[0], from[1]);
		this.overlay.dot('measure-end', to[0], to[1]);
		this.overlay.label('measure-label', `${norm(sub(b, a)).toFixed(3)} mm`, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2 - 18);
	}
}
