// @ts-check
// tables.js - the pairs of bodies with their status and reason; setup, files and statistics.

import {fixed, grouped, h, table} from './elements.js';

/** @typedef {import('./model.js').Model} Model */

const FIRST_ROWS = 200;
/** The meaning, for first-time readers. @type {Object<string, string>} */
const STATUS = {
	checked: 'proved apart, or found', rigid: 'no joint between them', adjacent: 'neighbours: excused, not proved',
	'out of reach': 'proved apart over the whole travel', waived: 'excused by the machine file or setup', cutting: 'the cutter may touch the part',
};

/** @param {Model} model */
export function pairsView(model) {
	const counts = new Map();
	for (const {status} of model.pairs) counts.set(status, (counts.get(status) || 0) + 1);
	const body = h('div');
	const name = /** @type {HTMLInputElement} */ (h('input', {type: 'search', placeholder: 'body', 'aria-label': 'Only pairs with this body', oninput: () => fill(FIRST_ROWS)}));
	const status = /** @type {HTMLSelectElement} */ (h('select', {'aria-label': 'Only pairs of this status', onchange: () => fill(FIRST_ROWS)},
		h('option', {value: ''}, `all ${grouped(model.pairs.length)} pairs`),
		...[...counts].map(([key, count]) => h('option', {value: key}, `${key}: ${count}`))));

	// Checked pairs come first.
	const sorted = [...model.pairs].sort((p, q) => Number(q.status === 'checked') - Number(p.status === 'checked'));
	const fill = (/** @type {number} */ most) => {
		const word = name.value.toLowerCase();
		const named = sorted.map((pair) => ({...pair, names: [pair.a, pair.b].map((i) => model.bodies[i].name)}));
		const rows = named.filter((pair) => (!status.value || pair.status === status.value) && (!word || pair.names.some((text) => text.toLowerCase().includes(word))));
		const cells = rows.slice(0, most).map((pair) => [pair.names.join(' \u2013 '), h('div', {}, h('b', {}, pair.status),
			pair.clearance ? `, keeps ${fixed(pair.clearance, 3)} mm` : '', h('br'), pair.reason || STATUS[pair.status] || '')]);
		const more = rows.length > most && h('button.more', {onclick: () => fill(Infinity)}, `Show all ${grouped(rows.length)}`);
		body.replaceChildren(table(['Pair', 'Status and why'], cells), ...(more ? [more] : []));
	};
	fill(FIRST_ROWS);
	return h('div.pairs', {}, h('div.filter', {}, name, status), body);
}

/** @param {Model} model */
export function setupView(model) {
	const files = model.files.map(({kind, file, sha256}) => [kind, file, h('code.digest', {title: sha256 || ''}, sha256 ? `${sha256.slice(0, 12)}\u2026` : 'not known')]);
	return h('div.setup', {},
		h('h2', {}, 'Setup'), table(['What', 'Value'], model.setup),
		h('h2', {}, 'Files'), table(['Kind', 'File', 'SHA-256'], files));
}

/** @param {Model} model */
export function statisticsView(model) {
	return h('div.statistics', {}, h('h2', {}, 'Statistics'), table(['What', 'Value'], model.statistics),
		h('p.note', {}, `fivecheck ${model.version}`));
}
