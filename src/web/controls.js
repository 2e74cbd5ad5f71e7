// @ts-check
// controls.js - the buttons around the picture: views, section, measure, bodies; play and speed; the positions of the axes.

import {SPEEDS} from './state.js';
import {axisValue} from './findings.js';
import {duration, grouped, h} from './elements.js';
import {proofSentence} from './proof.js';

/** @typedef {import('./stage.js').Stage} Stage */
/** @typedef {import('./state.js').State} State */

const MOTION = ['', 'rapid', 'feed', 'feed, spindle at rest', 'rapid, way not known'];

/**
 * The position of an axis in work coordinates; '' if offsets alone do not determine it.
 * @param {import('./model.js').Modes|null} modes @param {string} letter @param {number} value
 */
export function workValue(modes, letter, value) {
	if (!modes?.work_offset || modes.turned || (modes.tcp && 'XYZUVW'.includes(letter))) return '';
	return axisValue(value - (modes.work[letter] ?? 0) - (modes.shift[letter] ?? 0) - (letter === 'Z' ? modes.length : 0));
}

/** @param {import('./model.js').Modes} modes */
function originText({work_offset, shift, tcp, turned}) {
	const shifted = Object.values(shift).some((value) => value) ? ', shifted' : '';
	return `work: ${work_offset}${shifted}${tcp ? ', TCP' : ''}${turned ? ', turned' : ''}`;
}

/** Axis positions as on a control. @param {State} state */
export function readOut(state) {
	const {model} = state;
	const rows = model.readOut.map((letter) => {
		const value = h('dd'), work = h('dd.work');
		return {letter, index: model.axes.findIndex((axis) => axis.letter === letter), value, work, row: h('div', {}, h('dt', {}, letter), value, work)};
	});
	const heads = h('div.heads', {'aria-hidden': 'true'}, h('dd', {}, 'machine'), h('dd.work', {}, 'work'));
	const tool = h('span'), time = h('span'), motion = h('span'), spindle = h('span'), origin = h('p.origin');
	const show = () => {
		const {pose} = state;
		const {modes} = pose;
		let offset = false;
		for (const {letter, index, value, work} of rows) {
			value.textContent = axisValue(pose.values[index]);
			work.textContent = workValue(modes, letter, pose.values[index]);
			offset ||= work.textContent !== '';
			const {min, max} = model.axes[index];
			value.classList.toggle('beyond', pose.values[index] < (min ?? -Infinity) - 1e-3 || pose.values[index] > (max ?? Infinity) + 1e-3);
		}
		/** @type {HTMLElement} */ (heads.lastChild).hidden = !offset;
		tool.textContent = pose.tool ? `T${pose.tool}` : 'no tool';
		time.textContent = duration(state.time);
		motion.textContent = (MOTION[pose.motion] || '') + (pose.feed ? ` ${grouped(Math.round(pose.feed))} mm/min` : '');
		spindle.textContent = modes?.spindle ? `S${grouped(Math.round(Math.abs(modes.spindle)))}${modes.spindle < 0 ? ' (M4)' : ''}` : '';
		origin.textContent = modes?.work_offset ? originText(modes) : '';
	};
	state.watch(show);
	show();
	return h('div.readout', {'aria-label': 'Axis positions in machine coordinates, and beside them in work coordinates'},
		h('dl', {}, heads, ...rows.map(({row}) => row)), origin, h('p', {}, tool, time), h('p', {}, motion, spindle));
}

/** @param {string} text @param {string} title @param {() => void} act @param {Object<string, any>} [more] */
const button = (text, title, act, more = {}) => h('button', {title, onclick: act, ...more}, text);

/** @param {Stage} stage */
export function viewButtons(stage) {
	/** A button that stays pressed. @param {string} text @param {string} title @param {() => boolean} is @param {() => void} act */
	const toggle = (text, title, is, act) => {
		const element = button(text, title, act, {'aria-pressed': String(is())});
		stage.onselect.push(() => element.setAttribute('aria-pressed', String(is())));
		return element;
	};
	const {model} = stage;
	const views = h('div.views', {role: 'toolbar', 'aria-label': 'View'},
		model.findings.length ? button('Contact', 'Look at the contact (C)', () => stage.lookAtFocus()) : null,
		button('Fit', 'Everything (F)', () => stage.fit()),
		standardViews(stage),
		// On a phone the rest is shown on request.
		h('button.more-views', {'aria-label': 'More', 'aria-expanded': 'false', onclick: (/** @type {MouseEvent} */ e) => {
			const open = views.classList.toggle('open');
			/** @type {HTMLElement} */ (e.currentTarget).setAttribute('aria-expanded', String(open));
		}}, '\u22ef'),
		toggle('Section', 'Cut the machine open (S)', () => !!stage.section, () => toggleSection(stage)),
		toggle('Measure', 'Distance between two points: click both (M)', () => stage.measuring, () => toggleMeasure(stage)),
		toggle('X-ray', 'Make faint what is in the way (X)', () => stage.xray, () => toggleXray(stage)),
		toggle('Path', 'Show the way of the tool (T)', () => stage.trace, () => toggleTrace(stage)),
		model.planes ? toggle('Proof', 'Show the separating plane (P)', () => stage.proof, () => toggleProof(stage)) : null);
	return views;
}

/** @param {Stage} stage */
function standardViews(stage) {
	const names = {front: 'Front (1)', right: 'Right (2)', top: 'Top (3)', corner: 'Corner (4)', back: 'Back (5)', left: 'Left (6)'};
	const select = /** @type {HTMLSelectElement} */ (h('select', {'aria-label': 'Standard view', onchange: () => {
		stage.standard(select.value);
		// The same view can be chosen again.
		select.value = '';
	}}, h('option', {value: '', selected: true}, 'View'), ...Object.entries(names).map(([value, text]) => h('option', {value}, text))));
	return select;
}

/** @param {Stage} stage */
function told(stage) {
	stage.change();
	for (const listener of stage.onselect) listener();
}

/** @param {Stage} stage */
export function toggleSection(stage) {
	const {point} = stage.focus();
	stage.section = stage.section ? null : {axis: 1, at: Math.round(point[1]), sign: -1};
	told(stage);
}

/** @param {Stage} stage */
export function toggleMeasure(stage) {
	stage.measuring = !stage.measuring;
	stage.measure = [];
	told(stage);
}

/** @param {Stage} stage */
export function toggleXray(stage) {
	stage.xray = !stage.xray;
	told(stage);
}

/** @param {Stage} stage */
export function toggleTrace(stage) {
	stage.trace = !stage.trace;
	told(stage);
}

/** @param {Stage} stage */
export function toggleProof(stage) {
	if (!stage.model.planes) return;
	stage.proof = !stage.proof;
	told(stage);
	stage.lookAtFocus();
}

/** The selection and the measurement, the section's position, and the text of the proof. @param {Stage} stage */
export function hintBar(stage) {
	const {state, model} = stage;
	const bar = h('div.hints', {role: 'status'});
	/** @type {string} */
	let shown = '';
	const show = () => {
		const {selected, section, measuring, measure, proof} = stage;
		const hidden = stage.placed.hidden.size;
		const proofText = proof ? proofSentence(model, state.time) : '';
		const now = JSON.stringify([selected, section?.axis, section?.sign, measuring, measure.length, proofText, hidden]);
		if (now === shown) return;
		shown = now;
		bar.replaceChildren();
		if (selected >= 0) {
			const {name, link} = model.bodies[selected];
			bar.append(h('div', {}, h('b', {}, name), link ? ` moves with ${model.links[link]} ` : ' stands still ',
				button('Hide', 'Hide it (H)', () => stage.showBodies('hide')), button('Alone', 'Show it alone (I)', () => stage.showBodies('isolate'))));
		}
		if (hidden) bar.append(h('div', {}, `${hidden} hidden `, button('Show all', 'Show all bodies (A)', () => stage.showBodies('all'))));
		if (section) bar.append(sectionBar(stage, section));
		if (measuring && measure.length < 2) bar.append(h('div', {}, measure.length ? 'Click the second point.' : 'Click the first point.'));
		if (proofText) bar.append(h('div', {}, proofText));
	};
	stage.onselect.push(show);
	state.watch(show);
	return bar;
}

/** @param {Stage} stage @param {{axis: number, at: number, sign: number}} section */
function sectionBar(stage, section) {
	const {min, max} = stage.extent(section.axis);
	const slider = /** @type {HTMLInputElement} */ (h('input', {type: 'range', min: Math.floor(min), max: Math.ceil(max), value: section.at, 'aria-label': 'Place of the section, mm'}));
	slider.addEventListener('input', () => {
		section.at = Number(slider.value);
		stage.change();
	});
	const axes = ['X', 'Y', 'Z'].map((name, axis) => button(name, `Square to ${name}`, () => {
		Object.assign(section, {axis, at: Math.round(stage.focus().point[axis]), sign: axis === 1 ? -1 : 1});
		told(stage);
	}, {'aria-pressed': String(axis === section.axis)}));
	return h('div', {}, ...axes, slider, button('\u21c4', 'The other side', () => {
		section.sign = -section.sign;
		told(stage);
	}));
}

/** @param {State} state */
export function playButtons(state) {
	const {model} = state;
	const play = button('\u25b6', 'Play (space)', () => state.toggle());
	const speed = /** @type {HTMLSelectElement} */ (h('select', {'aria-label': 'Speed', title: 'Speed ([ and ])', onchange: () => {
		state.speed = Number(speed.value);
	}}, ...SPEEDS.map((value) => h('option', {value}, `${value}\u00d7`))));
	const show = () => {
		play.textContent = state.playing ? '\u275a\u275a' : '\u25b6';
		play.setAttribute('aria-label', state.playing ? 'Pause' : 'Play');
		speed.value = String(state.speed);
	};
	state.watch((what) => {
		if (what === 'playing') show();
	});
	show();
	return h('div.play', {role: 'toolbar', 'aria-label': 'Time'},
		button('\u2039 Block', 'Block before (,)', () => state.step(-1)), play,
		button('Block \u203a', 'Next block (.)', () => state.step(1)), speed,
		model.findings.length ? button('\u22122 s', 'Two seconds before the finding (B)', () => state.beforeFinding()) : null);
}
