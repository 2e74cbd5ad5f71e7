// @ts-check
/** setup_xml.js - the setup file for the entries of the form: plain functions of the form's data. */
import {namesIn, readNumber, vectorIn} from './fields.js';

/** @param {string} text */
function escaped(text) {
	return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
}

/**
 * An element of XML on a separate line; attributes without a value are left out.
 * @param {string} name
 * @param {Record<string, string>} attributes
 * @param {string[]} children
 */
function line(name, attributes, ...children) {
	const words = Object.entries(attributes).filter(([, value]) => value !== '').map(([key, value]) => ` ${key}="${escaped(value)}"`).join('');
	return children.length ? `<${name}${words}>\n${children.join('').replace(/^/gm, '  ').trimEnd()}\n</${name}>\n` : `<${name}${words}/>\n`;
}

/** @param {FormData} data @param {string} row */
function reader(data, row) {
	const text = (/** @type {string} */ name) => String(data.get(`${row}.${name}`) ?? '').trim();
	const vector = (/** @type {string} */ name) => vectorIn(data, `${row}.${name}`).replaceAll(',', ' ');
	return {text, vector, number: (/** @type {string} */ name) => readNumber(text(name)).number};
}

/**
 * The length of a tool's shank: the length that remains besides holder and cutter, in the setup's unit.
 * @param {FormData} data @param {string} row
 */
export function shankOf(data, row) {
	const {text, number} = reader(data, row), sum = ['holder', 'collar', 'cutter'].map((name) => Number(number(`${name}Length`)));
	return text('holderMesh') || text('cutterMesh') ? 0 : Number(sum.reduce((left, length) => left - length, Number(number('length'))).toFixed(6));
}

/** The fault in the solids of a tool, or ''. @param {FormData} data @param {string} row */
export function toolFault(data, row) {
	const {text, number} = reader(data, row), of = (/** @type {string} */ name) => Number(number(name)), radius = of('cutterDiameter') / 2;
	const high = {flat: 0, ball: radius, cone: radius / Math.tan(of('angle') * Math.PI / 360), bull: of('corner')}[text('tip')] ?? 0;
	if (shankOf(data, row) < 0)
		return 'holder and cutter together are longer than the tool';
	if (text('cutterMesh'))
		return '';
	if (text('tip') === 'cone' && !(of('angle') >= 1 && of('angle') <= 179))
		return 'the angle of a cone is 1 to 179 degrees';
	if (text('tip') === 'bull' && !(of('corner') > 0 && of('corner') <= radius))
		return 'the corner radius is more than 0 and at most half the diameter';
	if (high > of('cutterLength') + 1e-9)
		return `the tip is ${Number(high.toFixed(3))} high, the cutter only ${of('cutterLength')} long`;
	return number('flutes') !== '' && (of('flutes') < high || of('flutes') > of('cutterLength')) ? 'the flutes are at least as long as the tip is high, and at most as long as the cutter' : '';
}

/** @param {FormData} data @param {string} row */
function holderLine(data, row) {
	const {text, number} = reader(data, row);
	if (text('holderMesh'))
		return [line('holder', {mesh: text('holderMesh')})];
	const sections = ['holder', 'collar'].filter((name) => Number(number(`${name}Length`)) !== 0)
		.map((name) => line('section', {length: number(`${name}Length`), diameter: number(`${name}Diameter`), diameter_end: number(`${name}End`)}));
	return sections.length ? [line('holder', {}, ...sections)] : [];
}

/** @param {FormData} data @param {string} row */
function cutterLine(data, row) {
	const {text, number} = reader(data, row), tip = text('tip');
	if (text('cutterMesh'))
		return line('cutter', {mesh: text('cutterMesh')});
	const form = {tip: tip === 'flat' ? '' : tip, angle: tip === 'cone' ? number('angle') : '', corner: tip === 'bull' ? number('corner') : '', flute_length: number('flutes')};
	return line('cutter', form, line('section', {length: number('cutterLength'), diameter: number('cutterDiameter')}));
}

/** @param {FormData} data @param {string} row @param {string[]} edges */
function toolLine(data, row, edges) {
	const {text, number} = reader(data, row), shank = shankOf(data, row), kind = text('kind');
	const own = {number: number('number'), name: text('name'), length: number('length'), length_offset: number('lengthOffset'),
		diameter: text('cutterMesh') ? number('cutterDiameter') : '', kind: kind === 'cutter' ? '' : kind, hand: text('hand')};
	return line('tool', own, ...holderLine(data, row),
		...(shank > 0 ? [line('shank', {}, line('section', {length: String(shank), diameter: number('shankDiameter') || number('cutterDiameter')}))] : []), cutterLine(data, row),
		...edges.map((edge) => rowLine(data, 'edge', edge, {}, ['number', 'length', 'diameter'])));
}

/**
 * A row that becomes one element with its fields.
 * @param {FormData} data @param {string} name @param {string} row @param {Record<string, string>} texts @param {string[]} numbers
 */
function rowLine(data, name, row, texts, numbers) {
	return line(name, {...texts, ...Object.fromEntries(numbers.map((field) => [field, reader(data, row).number(field)]))});
}

/** @param {FormData} data @param {string} name @param {string} row @param {string[]} fields */
function textLine(data, name, row, fields) {
	return rowLine(data, name, row, Object.fromEntries(fields.map((field) => [field, reader(data, row).text(field)])), []);
}

/** Names that have another meaning in a pair of a machine file. */
const RESERVED = /^([ABCUVWXYZ]|base|holder|shank|cutter|fixture|part|stock)$/;

/**
 * The name of a body is that of its file, with a number if that name is taken or has another meaning.
 * @param {string} mesh @param {Set<string>} taken
 */
function bodyName(mesh, taken) {
	const name = mesh.replace(/^.*\/|\.[^.]*$/g, '');
	let own = name;
	for (let i = 1; taken.has(own) || RESERVED.test(own); i++)
		own = `${name} ${i}`;
	taken.add(own);
	return own;
}

/**
 * Parts and fixtures: several files in one row have the same place.
 * @param {FormData} data @param {string} row @param {'part' | 'fixture'} kind @param {Set<string>} taken names of bodies
 */
function solidLines(data, row, kind, taken) {
	const {text, vector, number} = reader(data, row);
	return namesIn(text('mesh')).map((mesh) => line(kind, {name: bodyName(mesh, taken), mesh, location: vector('location'), rotation: vector('rotation'),
		...(kind === 'part' ? {rapid_allowance: number('rapidAllowance'), gouge: number('gouge')} : {})}));
}

/** @param {FormData} data */
function stockLine(data) {
	const {text, vector, number} = reader(data, 'stock'), form = text('form');
	const shape = {box: {box: vector('size')}, cylinder: {cylinder: `${number('diameter')} ${number('height')}`}, mesh: {mesh: text('mesh')}}[form];
	return shape ? [line('stock', {...shape, location: vector('location'), rotation: vector('rotation'), uncertainty: number('uncertainty'), excess: number('excess'), rapid_allowance: number('rapidAllowance')})] : [];
}

/**
 * The setup file for the entries.
 * @param {FormData} data @param {string[]} axes of the machine
 * @param {Record<string, string[]>} rows the names of the rows of each kind: offset, part, fixture, tool, table, register, variable
 * @param {(tool: string) => string[]} [edgesOf] the rows of the edges of a tool
 */
export function setupXml(data, axes, rows, edgesOf = () => []) {
	const of = (/** @type {string} */ kind) => rows[kind] ?? [];
	const offsets = of('offset').map((row) => {
		const {text, number} = reader(data, row);
		return line('work_offset', {name: text('name'), ...Object.fromEntries(axes.map((axis) => [axis, number(axis)]))});
	});
	const {number, text} = reader(data, 'setup'), taken = new Set();
	return `<?xml version="1.0" encoding="UTF-8"?>\n${line('setup', {version: '1', units: text('units') || 'mm', initial_tool: number('initialTool')}, ...offsets,
		...of('register').map((row) => rowLine(data, 'offset', row, {}, ['number', 'length', 'radius'])),
		...of('fixture').flatMap((row) => solidLines(data, row, 'fixture', taken)), ...of('part').flatMap((row) => solidLines(data, row, 'part', taken)), ...stockLine(data),
		...of('tool').map((row) => toolLine(data, row, edgesOf(row))), ...of('table').map((row) => textLine(data, 'tools', row, ['href', 'units', 'numbers'])),
		...of('variable').map((row) => textLine(data, 'variable', row, ['name', 'value', 'type', 'size'])))}`;
}
