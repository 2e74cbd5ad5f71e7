// @ts-check
// keyboard.js - the keys that work everywhere on the page, and their list.

import {toggleMeasure, toggleProof, toggleSection, toggleTrace, toggleXray} from './controls.js';
import {h, table} from './elements.js';

/** @typedef {import('./stage.js').Stage} Stage */
/** @typedef {import('./state.js').State} State */

/** @type {[string, string, (state: State, stage: Stage) => void][]} */
const KEYS = [
	[' ', 'play, pause', (state) => state.toggle()],
	[',', 'block before', (state) => state.step(-1)],
	['.', 'next block', (state) => state.step(1)],
	['[', 'slower', (state) => state.faster(-1)],
	[']', 'faster', (state) => state.faster(1)],
	['n', 'next finding', (state) => state.otherFinding(1)],
	['N', 'finding before', (state) => state.otherFinding(-1)],
	['b', 'two seconds before the finding', (state) => state.beforeFinding()],
	['c', 'look at the contact', (_, stage) => stage.lookAtFocus()],
	['f', 'fit everything', (_, stage) => stage.fit()],
	['1', 'from the front', (_, stage) => stage.standard('front')],
	['2', 'from the right', (_, stage) => stage.standard('right')],
	['3', 'from above', (_, stage) => stage.standard('top')],
	['4', 'from a corner', (_, stage) => stage.standard('corner')],
	['5', 'from the back', (_, stage) => stage.standard('back')],
	['6', 'from the left', (_, stage) => stage.standard('left')],
	['s', 'section', (_, stage) => toggleSection(stage)],
	['m', 'measure', (_, stage) => toggleMeasure(stage)],
	['x', 'x-ray: make faint what is in the way', (_, stage) => toggleXray(stage)],
	['t', 'the way of the tool', (_, stage) => toggleTrace(stage)],
	['p', 'the separating plane of the proof', (_, stage) => toggleProof(stage)],
	['h', 'hide the selected body', (_, stage) => stage.showBodies('hide')],
	['i', 'show the selected body alone', (_, stage) => stage.showBodies('isolate')],
	['a', 'show all bodies', (_, stage) => stage.showBodies('all')],
];

/** @param {State} state @param {Stage} stage @param {HTMLDialogElement} help */
export function watchKeys(state, stage, help) {
	document.addEventListener('keydown', (e) => {
		const target = /** @type {HTMLElement} */ (e.target);
		if (e.ctrlKey || e.metaKey || e.altKey || help.open || target.closest('input, select, textarea')) return;
		// A button handles the space bar itself.
		if (e.key === ' ' && target.closest('button, summary')) return;
		if (e.key === '?') help.showModal();
		else if (e.key === 'Escape') {
			if (stage.measuring) toggleMeasure(stage);
			stage.select(-1);
		} else {
			const key = KEYS.find(([name]) => name === e.key);
			if (!key) return;
			key[2](state, stage);
		}
		e.preventDefault();
	});
}

export function helpView() {
	const rows = KEYS.map(([key, text]) => [h('kbd', {}, key === ' ' ? 'space' : key), text]);
	const close = () => dialog.close();
	const dialog = /** @type {HTMLDialogElement} */ (h('dialog.help', {'aria-label': 'Keys and help'},
		h('h2', {tabindex: -1, autofocus: true}, 'How to look around'),
		h('p', {}, 'Drag turns the machine; with Shift, the right button or two fingers it moves. The wheel or a pinch zooms; a double click centres. A click selects a body. ' +
			'A click on a line of the program shows where its block has led. Drag in the timeline to any moment; the wheel zooms it, a double click shows all of it. ' +
			'The curve is the smallest clearance of all pairs that is proven: the true one is at least that. ' +
			'In a long program only some blocks are measured (the upper edge of the curve); its lower edge is proven of every block up to there.'),
		table(['Key', 'What it does'], rows), h('button', {onclick: close}, 'Close')));
	return dialog;
}
