// @ts-check
// report.js - the model of a report: what the page carries, unpacked (src/report/html/report_data.h).

import {fixed} from './elements.js';
import {joinColumns, Levels} from './levels.js';
import {operations, toolChanges} from './marks.js';
import {inflate, sevenBit, unpackMesh, unpackTable} from './pack.js';
import {ReportPath} from './path.js';
import {turnedMesh} from './turned.js';

/** @typedef {import('./model.js').Model} Model */

const VERSION = 1;
/** A clearance table up to this length is unpacked as a whole. */
const WHOLE = 1 << 17;

/** @param {number} blob */
function blobBytes(blob) {
	const element = document.getElementById(`blob-${blob}`);
	if (!element) throw new Error(`blob ${blob} is missing`);
	return sevenBit(element.textContent || '');
}

/** @param {number} blob */
function fetchBlob(blob) {
	return inflate(blobBytes(blob));
}

/** @returns {Promise<Model>} */
export async function readReport() {
	const text = await inflate(sevenBit(document.getElementById('fivecheck-head')?.textContent || ''));
	const head = JSON.parse(new TextDecoder().decode(text));
	if (head.report !== VERSION) throw new Error('this report is of another version');
	const [bodies, path, clearance, planes, sources] = await Promise.all([
		head.bodies.map(readBody), readPath(head), readClearance(head.clearance), readPlanes(head.planes), readCode(head),
	]);
	/** @type {Model} */
	const model = {
		version: head.fivecheck, machine: head.machine.name, program: head.program,
		verdict: head.verdict.word, sentence: head.verdict.sentence, failing: head.verdict.failing, cautions: head.verdict.cautions, doubts: head.verdict.doubts,
		errors: head.errors, files: head.files,
		axes: head.machine.axes.map((/** @type {any} */ axis) => ({
			letter: axis.name, title: axis.title, rotary: axis.type === 'rotary', parent: axis.parent, direction: axis.direction,
			location: axis.location, min: axis.limit_min, max: axis.limit_max,
		})),
		links: head.machine.links, spindle: head.machine.spindle, workholding: head.machine.workholding,
		lengths: new Map((head.tools || []).map((/** @type {any} */ {number, length}) => [number, length])), readOut: head.read_out, bodies, pairs: head.pairs, findings: head.findings, leftOut: head.findings_left_out || 0,
		path, sources, clearance, planes, tools: [], operations: [], setup: readSetup(head), statistics: head.statistics || [], sensitivity: head.sensitivity || [], accuracy: head.accuracy,
	};
	model.tools = toolChanges(path, head.tools || []);
	model.operations = operations(path, sources);
	return model;
}

/** @param {any} body @returns {import('./model.js').Body} */
function readBody({name, role, link, tool, mesh}) {
	const shape = !mesh ? {positions: new Float32Array(0), indices: new Uint32Array(0)}
		: mesh.profile ? turnedMesh(mesh) : unpackMesh(blobBytes(mesh.blob), mesh);
	return {name, role, link, tool, mesh: shape};
}

/** @param {any} head @returns {Promise<ReportPath>} */
async function readPath({path, machine}) {
	const letters = machine.axes.map((/** @type {any} */ axis) => axis.name);
	if (path) return new ReportPath(await Levels.open(path, fetchBlob), letters, path.end, path.checked, path.modes);
	// Nothing moves: one row, at home.
	const columns = ['time', 'block', 'line', 'file', 'tool', 'class', 'modes', 'feed', ...letters];
	const home = columns.map((name) => Float64Array.of(machine.axes[letters.indexOf(name)]?.home || 0));
	const rows = {columns, scale: [], rows: 1, coarse: {blob: -1, rows: 1}, chunks: [], complete: true};
	return new ReportPath(new Levels(rows, fetchBlob, home), letters, 0, 0, []);
}

/** @param {any} head @returns {Promise<import('./model.js').Clearance|null>} */
async function readClearance(head) {
	if (!head) return null;
	const levels = await Levels.open(head, fetchBlob);
	const whole = levels.head.chunks.length && head.complete && head.rows <= WHOLE;
	const columns = whole ? joinColumns(await Promise.all(head.chunks.map((/** @type {any} */ _, /** @type {number} */ i) => levels.load(i)))) : levels.coarse;
	const column = (/** @type {string} */ name) => columns[levels.column(name)];
	return {
		cap: head.cap, bound: head.bound, smallest: head.smallest, times: Float64Array.of(head.start, ...column('time')), least: column('least'), most: column('most'), pair: column('pair'),
	};
}

/** @param {any} head @returns {Promise<import('./model.js').Planes|null>} */
async function readPlanes(head) {
	if (!head) return null;
	const columns = unpackTable(await fetchBlob(head.blob), head.rows, head.scale);
	const column = (/** @type {string} */ name) => columns[head.columns.indexOf(name)];
	return {
		time: column('time'), pair: column('pair'), distance: column('distance'),
		point: ['x', 'y', 'z'].map(column), normal: ['nx', 'ny', 'nz'].map(column),
	};
}

/** @param {any} head @returns {Promise<import('./model.js').Source[]>} */
function readCode({code}) {
	return Promise.all((code?.files || []).map(async (/** @type {any} */ file) => ({
		name: file.name, sha256: file.sha256, lines: Math.max(0, file.lines),
		windows: await Promise.all(file.windows.map(async (/** @type {any} */ window) => (
			{first: window.first, lines: new TextDecoder().decode(await fetchBlob(window.blob)).split('\n')}))),
	})));
}

/** @param {any} head @returns {[string, string][]} */
function readSetup({machine, tools, offsets, options, accuracy, stock}) {
	/** @type {[string, string][]} */
	const rows = [['Machine', machine.name || machine.file]];
	for (const axis of machine.axes) {
		const unit = axis.type === 'rotary' ? '\u00b0' : ' mm';
		const travel = axis.limit_min === null && axis.limit_max === null ? 'unlimited'
			: `${axis.limit_min ?? 'unlimited'} to ${axis.limit_max ?? 'unlimited'}${unit}`;
		rows.push([`Axis ${axis.name}${axis.title ? ` (${axis.title})` : ''}`, travel]);
	}
	for (const {name, axes} of offsets || []) rows.push([name, Object.entries(axes).map(([letter, value]) => `${letter} ${fixed(Number(value), 3)}`).join('  ')]);
	for (const {number, name, length} of tools || []) rows.push([`Tool ${number}${name ? ` (${name})` : ''}`, `length ${fixed(length, 3)} mm`]);
	for (const key of ['method', 'clearance', 'tolerance', 'dialect']) {
		if (options?.[key] !== undefined && options[key] !== null) rows.push([key[0].toUpperCase() + key.slice(1), `${options[key]}${typeof options[key] === 'number' ? ' mm' : ''}`]);
	}
	if (accuracy !== null && accuracy !== undefined) rows.push(['Picture', `drawn to ${accuracy} mm; proved on the numbers of the STL files`]);
	if (stock) rows.push(['Stock', stockText(stock)]);
	return rows;
}

/** @param {{when: string, excess: number}} stock */
function stockText({when, excess}) {
	if (when === 'start') return 'drawn before the first cut';
	return `drawn as it remains at the ${when === 'end' ? 'end' : 'first finding'}: all that is left; what lies deeper than ${excess.toPrecision(2)} mm below its surface is certainly there`;
}
