// @ts-check
/** jog.js - a slider for each axis; the bodies move with it, and the nearest pair is shown. */
import {JogStage} from './jog_stage.js';
import {element, reveal} from './page.js';
import {Newest} from './session_client.js';
import {State} from './viewer/state.js';

/** @typedef {import('./viewer/model.js').Model} Model */
/** @typedef {import('./fivecheck.js').Pose} Pose */

/** How far an axis without limits can be moved: degrees, mm. */
const TURN = 180, WAY = 500;
/** mm: bodies within this distance may count as a contact in a verdict (--tolerance). */
const TOLERANCE = 0.001;

/** @param {Pose} pose @returns {Pose} with the nearest bodies among those that meet if a check may say so */
function withTolerance(pose) {
	const {nearest, meets} = pose;
	return nearest && nearest.distance <= TOLERANCE ? {...pose, meets: [...meets, [nearest.a, nearest.b]]} : pose;
}

/** @param {Pose} pose */
export function wordsOf({meets, near, unknown, nearest, pairs}) {
	const name = (/** @type {[string, string][]} */ list) => list.map(([a, b]) => `${a} meets ${b}`).join(', ');
	if (meets.length)
		return {state: 'found', text: `Collision: ${name(meets)}.`};
	if (unknown.length)
		return {state: 'incomplete', text: `Not decided: ${unknown.map((pair) => pair.join(' and ')).join(', ')}.`};
	if (near.length)
		return {state: 'found', text: `Nearer than their clearance: ${near.map((pair) => pair.join(' and ')).join(', ')}.`};
	if (!nearest)
		return {state: 'clear', text: 'No bodies have to stay apart here.'};
	return {state: 'clear', text: `Nearest of ${pairs} pairs: ${nearest.a} and ${nearest.b}, ${nearest.distance.toFixed(3)} mm.`};
}

export class Jog {
	/**
	 * @param {Model} model
	 * @param {import('./session_client.js').SessionClient} session
	 * @param {{number: number, name: string}[]} tools
	 */
	constructor(model, session, tools) {
		this.model = model;
		this.session = session;
		this.state = new State(model);
		this.stage = new JogStage(this.state);
		this.newest = new Newest(() => this.ask());
		this.verdict = element('p', {className: 'verdict', role: 'status'});
		this.tool = /** @type {HTMLSelectElement} */ (element('select', {}, element('option', {value: '0'}, 'no tool'),
			...tools.map(({number, name}) => element('option', {value: String(number)}, `T${number} ${name}`))));
		this.tool.selectedIndex = tools.length ? 1 : 0;
		this.tool.addEventListener('change', () => this.moved());
		this.sliders = model.axes.map((axis, i) => this.slider(axis, model.path.pose(0).values[i]));
		this.plane = element('button', {type: 'button', ariaPressed: 'false'}, 'Plane between the nearest');
		this.plane.addEventListener('click', () => this.showPlane(!this.stage.proof));
		const home = element('button', {type: 'button'}, 'Home');
		home.addEventListener('click', () => this.moveTo({}));
		this.element = element('div', {className: 'jog'}, this.stage.element, this.verdict,
			element('div', {className: 'axes'}, ...this.sliders.map(({row}) => row)),
			element('p', {className: 'row'}, element('label', {}, 'tool', this.tool), home, this.plane));
	}

	/** @param {import('./viewer/model.js').Axis} axis @param {number} home */
	slider(axis, home) {
		const far = axis.rotary ? TURN : WAY, unit = axis.rotary ? '°' : 'mm', min = axis.min ?? -far, max = axis.max ?? far;
		const id = `jog-${axis.letter}`, name = `${axis.letter}${axis.title ? ` (${axis.title})` : ''}`;
		const range = /** @type {HTMLInputElement} */ (element('input', {type: 'range', id, min, max, step: axis.rotary ? 0.1 : 0.5, value: home}));
		const number = /** @type {HTMLInputElement} */ (element('input', {type: 'number', min, max, step: 'any', value: home, ariaLabel: `${name}, ${unit}`}));
		range.addEventListener('input', () => {
			number.value = range.value;
			this.moved();
		});
		number.addEventListener('input', () => {
			if (!number.validity.valid || number.value === '')
				return;
			range.value = number.value;
			this.moved();
		});
		const label = element('label', {htmlFor: id}, name);
		return {axis, range, number, home, row: element('div', {className: 'axis-row'}, label, range, number, element('span', {className: 'unit'}, unit))};
	}

	values() {
		return Object.fromEntries(this.sliders.map(({axis, number}) => [axis.letter, Number(number.value)]));
	}

	/** Moves the axes; the others go home. @param {Record<string, number>} axes @param {number} [tool] */
	moveTo(axes, tool) {
		for (const {axis, range, number, home} of this.sliders)
			range.value = number.value = String(axes[axis.letter] ?? home);
		if (tool !== undefined)
			this.tool.value = String(tool);
		this.moved();
	}

	/**
	 * The pose of a finding, with its tool; another one would make no difference.
	 * @param {Record<string, any>} event
	 */
	showFinding({a, b, axes}) {
		const tool = this.model.bodies.find(({name, tool: of}) => of && (name === a || name === b))?.tool;
		this.moveTo(axes, tool);
	}

	/** The plane between the nearest bodies, or none. @param {boolean} shown */
	showPlane(shown) {
		this.setShown([], shown);
		if (shown)
			this.stage.lookAtFocus();
		else
			this.stage.fit();
	}

	/** Shows two links in colours and the rest faint; or none. @param {number[]} links */
	showLinks(links) {
		this.setShown(links, false);
		this.stage.fit();
	}

	/** @param {number[]} links @param {boolean} plane */
	setShown(links, plane) {
		this.stage.links = links;
		this.stage.proof = plane;
		this.plane.ariaPressed = String(plane);
		document.dispatchEvent(new CustomEvent('links-shown', {detail: links}));
		reveal(this.stage.element);
	}

	moved() {
		const pose = this.state.pose = {...this.state.pose, values: this.sliders.map(({number}) => Number(number.value)), tool: Number(this.tool.value)};
		this.stage.placed.moveTo(pose.values, pose.tool);
		this.state.tell('time');
		this.newest.put(true);
	}

	async ask() {
		try {
			const pose = withTolerance(await this.session.pose(this.values(), Number(this.tool.value)));
			const {state, text} = wordsOf(pose);
			this.stage.tell(pose);
			this.verdict.dataset.verdict = state;
			this.verdict.textContent = text;
		} catch (error) {
			this.stage.tell(null);
			this.verdict.dataset.verdict = 'incomplete';
			this.verdict.textContent = String(error);
		}
		document.dispatchEvent(new Event('posed'));
	}

	/** @param {HTMLElement} parent @param {Record<string, number>} [start] axes that do not stand at home */
	show(parent, start = {}) {
		parent.replaceChildren(this.element);
		this.stage.placed.moveTo(this.state.pose.values, Number(this.tool.value));
		this.stage.fit();
		this.stage.standard('corner');
		this.moveTo(start);
	}
}
