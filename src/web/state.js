// @ts-check
// state.js - what the user looks at: the time, the finding, what is selected. Views read it and are told of changes.

/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./model.js').Pose} Pose */

/** @typedef {'time'|'playing'|'look'|'read'} Change */

/** s: an approach to a finding is shown from this long before it. */
const LEAD = 2;
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 25, 50, 100];

export class State {
	/** @param {Model} model */
	constructor(model) {
		this.model = model;
		this.time = 0;
		/** The finding whose exact pose is shown, or -1. */
		this.finding = -1;
		/** The last finding that the user looked at. */
		this.lastFinding = model.findings.length ? 0 : -1;
		this.playing = false;
		this.speed = 1;
		/** The time at which to stop when played from before a finding. */
		this.stopAt = Infinity;
		/** A line to read, such as a call; it need not move anything. */
		this.read = {file: 0, line: 0};
		/** @type {((what: Change) => void)[]} */
		this.listeners = [];
		/** @type {Pose} */
		this.pose = model.path.pose(0);
	}

	/** @param {(what: Change) => void} listener */
	watch(listener) {
		this.listeners.push(listener);
	}

	/** @param {Change} what */
	tell(what) {
		for (const listener of this.listeners) listener(what);
	}

	/** @param {number} time */
	seek(time) {
		this.time = Math.max(0, Math.min(this.model.path.duration, time));
		this.finding = -1;
		this.refine();
	}

	/** Shows a finding at exactly the pose of the check. @param {number} index */
	showFinding(index) {
		const finding = this.model.findings[index];
		if (!finding) return;
		this.pause();
		this.time = finding.time;
		this.finding = this.lastFinding = index;
		this.refine();
		this.tell('look');
	}

	/** The pose at the current time; it is updated when finer data of the path arrives. */
	refine() {
		const {time, model} = this;
		this.pose = this.poseNow();
		this.tell('time');
		const loading = model.path.load(time);
		if (loading) {
			loading.then(() => {
				if (time === this.time) this.refine();
			});
		}
	}

	/** @returns {Pose} */
	poseNow() {
		const {model} = this;
		const pose = model.path.pose(this.time);
		const finding = model.findings[this.finding];
		if (!finding) return pose;
		// Exactly as in the check; the path is rounded.
		const file = model.sources.findIndex((source) => source.name === finding.file);
		return {
			...pose, line: finding.line, file: file < 0 ? pose.file : file, tool: finding.tool ?? pose.tool,
			values: model.axes.map((axis, i) => finding.axes[axis.letter] ?? pose.values[i]),
		};
	}
	/** @param {number} by 1: the next finding, -1: the one before */
	otherFinding(by) {
		const count = this.model.findings.length;
		if (count) this.showFinding((Math.max(this.lastFinding, 0) + by + count) % count);
	}

	/** Two seconds before the finding; play continues to the finding. */
	beforeFinding() {
		const finding = this.model.findings[this.lastFinding];
		if (!finding) return;
		this.seek(finding.time - LEAD);
		this.stopAt = finding.time;
	}

	/** Goes to the end of another block: the position after it. @param {number} by blocks */
	async step(by) {
		this.pause();
		this.seek(await this.model.path.blockEnd(this.time, by));
	}

	/** Goes to the end of the block of a line. @param {number} file @param {number} line */
	async showLine(file, line) {
		this.pause();
		const time = await this.model.path.timeOf(file, line);
		if (time >= 0) this.seek(time);
	}

	/** Shows a line of a file without moving the time. @param {string} name of the file @param {number} line */
	readLine(name, line) {
		const file = this.model.sources.findIndex((source) => source.name === name);
		if (file < 0) return;
		this.read = {file, line};
		this.tell('read');
	}

	/** @param {number} by places in SPEEDS */
	faster(by) {
		const at = SPEEDS.indexOf(this.speed) + by;
		this.speed = SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, at))];
		this.tell('playing');
	}

	pause() {
		if (!this.playing) return;
		this.playing = false;
		this.tell('playing');
	}

	toggle() {
		if (this.playing) {
			this.pause();
			return;
		}
		if (this.time >= this.model.path.duration) this.seek(0);
		if (this.stopAt <= this.time) this.stopAt = Infinity;
		this.playing = true;
		this.tell('playing');
		let last = performance.now();
		const run = (/** @type {number} */ now) => {
			if (!this.playing) return;
			const next = this.time + (now - last) / 1000 * this.speed;
			last = now;
			if (next >= this.stopAt) {
				this.stopAt = Infinity;
				this.showFinding(this.lastFinding);
				return;
			}
			this.seek(next);
			if (next >= this.model.path.duration) this.pause();
			else requestAnimationFrame(run);
		};
		requestAnimationFrame(run);
	}
}
