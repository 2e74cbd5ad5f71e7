// @ts-check
/**
 * setup_form.js - the form for a job's setup: work offset, part, fixtures, tools with a holder. What it writes is judged by the
 * check, as any other setup file is.
 */
import {forgetFaults, meshField, namesIn, numberField, numbersAreRead, readNumber, showFile, tellFault, textField, watchNumbers} from './fields.js';
import {element} from './page.js';

const AXES = ['X', 'Y', 'Z', 'A', 'B', 'C'];
/** The fields of a tool, with values of some tool, which are shown as long as nothing is entered: mm. */
const TOOL = [['length', 'length from the gauge point to the tip, mm', '120'], ['holderLength', 'holder: length, mm', '60'], ['holderDiameter', 'holder: diameter, mm', '50'],
	['cutterLength', 'cutter: length, mm', '40'], ['cutterDiameter', 'cutter and shank: diameter, mm', '10']];
/** The tools of a program that has more than this are not proposed one by one. */
const MOST_TOOLS = 40;

/** The axes that a machine file has. @param {string} machine */
export function axesIn(machine) {
	const letters = [...machine.matchAll(/<axis\s[^>]*?\bname=["']([A-Z])["']/g)].map(([, letter]) => letter);
	return AXES.filter((axis) => letters.length === 0 ? 'XYZ'.includes(axis) : letters.includes(axis));
}

/** The numbers of the tools that programs call. @param {string[]} programs */
export function toolsIn(programs) {
	const code = programs.map((text) => text.replace(/\([^)\n]*\)|;.*/g, ' ')).join('\n');
	const found = [...code.matchAll(/(?<![A-Z0-9_#<"])T(?:OOL CALL)?\s*0*([1-9]\d*)/gi)].map(([, number]) => number);
	return [...new Set(found)].sort((a, b) => Number(a) - Number(b)).slice(0, MOST_TOOLS);
}

/** @param {string} text */
function escaped(text) {
	return text.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);
}

/**
 * An element of XML in a line of its own; attributes without a value are left out.
 * @param {string} name
 * @param {Record<string, string>} attributes
 * @param {string[]} children
 */
function line(name, attributes, ...children) {
	const words = Object.entries(attributes).filter(([, value]) => value !== '').map(([key, value]) => ` ${key}="${escaped(value)}"`).join('');
	return children.length ? `<${name}${words}>\n${children.join('').replace(/^/gm, '  ').trimEnd()}\n</${name}>\n` : `<${name}${words}/>\n`;
}

/** @param {FormData} data */
function reader(data) {
	/** @param {string} name */
	const text = (name) => String(data.get(name) ?? '').trim();
	return {text, number: (/** @type {string} */ name) => readNumber(text(name)).number};
}

/** A tool's shank: what is left of its length between holder and cutter, mm. @param {FormData} data @param {string} row */
function shankOf(data, row) {
	const {number} = reader(data), [length, holder, cutter] = ['length', 'holderLength', 'cutterLength'].map((name) => Number(number(`${row}.${name}`)));
	return Number((length - holder - cutter).toFixed(6));
}

/** @param {FormData} data @param {string} row */
function toolLine(data, row) {
	const {text, number} = reader(data), shank = shankOf(data, row), of = (/** @type {string} */ name) => number(`${row}.${name}`);
	const section = (/** @type {string} */ length, /** @type {string} */ diameter) => line('section', {length, diameter});
	return line('tool', {number: of('number'), name: text(`${row}.name`), length: of('length')},
		...(Number(of('holderLength')) !== 0 ? [line('holder', {}, section(of('holderLength'), of('holderDiameter')))] : []),
		...(shank > 0 ? [line('shank', {}, section(String(shank), of('cutterDiameter')))] : []),
		line('cutter', {tip: text(`${row}.tip`)}, section(of('cutterLength'), of('cutterDiameter'))));
}

/**
 * The setup file for what is entered.
 * @param {FormData} data @param {string[]} axes of the machine @param {string[]} rows of tools
 */
export function setupXml(data, axes, rows) {
	const {text, number} = reader(data);
	/** @param {'part' | 'fixture'} kind */
	const solids = (kind) => namesIn(text(`${kind}.mesh`)).map((mesh) => line(kind, {name: mesh.replace(/^.*\/|\.[^.]*$/g, ''), mesh,
		location: ['x', 'y', 'z'].map((letter) => number(`${kind}.${letter}`) || '0').join(' ')}));
	const offset = {name: text('offset.name'), ...Object.fromEntries(axes.map((axis) => [axis, number(`offset.${axis}`)]))};
	return `<?xml version="1.0" encoding="UTF-8"?>\n${line('setup', {version: '1', units: 'mm'}, line('work_offset', offset), ...solids('fixture'), ...solids('part'),
		...rows.map((row) => toolLine(data, row)))}`;
}

export class SetupForm {
	/**
	 * @param {HTMLFormElement} form
	 * @param {(found: [string, Blob][]) => void} add takes the meshes that are chosen
	 * @param {(xml: string) => void} use the user wants to check with this setup
	 */
	constructor(form, add, use) {
		this.form = form;
		this.xml = '';
		this.axes = ['X', 'Y', 'Z'];
		this.rows = 0;
		/** A person has changed the tools: they are no longer proposed. */
		this.touched = false;
		this.part('#offset-axes').append(...AXES.map((axis) => numberField(`offset.${axis}`, `${axis}, ${'ABC'.includes(axis) ? 'degrees' : 'mm'}`, '', 'XYZ'.includes(axis))));
		for (const [kind, label] of [['part', 'the finished part (STL file)'], ['fixture', 'fixtures (STL files)']])
			this.part(`[data-solid=${kind}]`).append(meshField(`${kind}.mesh`, label, kind === 'fixture', add),
				...['x', 'y', 'z'].map((letter) => numberField(`${kind}.${letter}`, `location_${letter}, mm`, '0')), element('p', {className: 'fault', role: 'alert'}));
		watchNumbers(form);
		this.part('#tools').addEventListener('input', () => this.touched = true);
		this.part('#add-tool').addEventListener('click', () => {
			this.touched = true;
			this.addTool(String(this.toolRows().length + 1)).querySelector('input')?.focus();
		});
		form.addEventListener('submit', (event) => {
			event.preventDefault();
			this.write();
		});
		this.part('#use-setup').addEventListener('click', () => use(this.xml));
		this.propose('', []);
	}

	/** @param {string} selector */
	part(selector) {
		return /** @type {HTMLElement} */ (this.form.querySelector(selector));
	}

	toolRows() {
		return /** @type {HTMLElement[]} */ ([...this.form.querySelectorAll('#tools > fieldset')]);
	}

	/** Fits the form to the machine, and to the tools that the programs call. @param {string} machine @param {string[]} programs */
	propose(machine, programs) {
		this.axes = axesIn(machine);
		for (const axis of AXES)
			/** @type {HTMLElement} */ (this.part(`[name="offset.${axis}"]`).closest('label')).hidden = !this.axes.includes(axis);
		if (this.touched)
			return;
		const tools = toolsIn(programs);
		this.part('#tools').replaceChildren();
		for (const number of tools.length ? tools : ['1'])
			this.addTool(number);
	}

	/** @param {string} number */
	addTool(number) {
		const row = `tool-${this.rows++}`, remove = element('button', {type: 'button', ariaLabel: `Remove tool ${number}`}, 'Remove');
		const part = element('fieldset', {className: 'axis', dataset: {row}}, element('legend', {}, 'Tool'), numberField(`${row}.number`, 'T number', number, true),
			textField(`${row}.name`, 'name'), ...TOOL.map(([name, label, like]) => numberField(`${row}.${name}`, label, '', true, like)),
			element('label', {}, 'tip', element('select', {name: `${row}.tip`}, element('option', {}, 'flat'), element('option', {}, 'ball'))), remove,
			element('p', {className: 'fault', role: 'alert'}));
		remove.addEventListener('click', () => {
			this.touched = true;
			part.remove();
			this.part('#add-tool').focus();
		});
		this.part('#tools').append(part);
		return part;
	}

	write() {
		forgetFaults(this.form);
		const data = new FormData(this.form), read = numbersAreRead(this.form);
		const long = read ? this.toolRows().filter((part) => shankOf(data, part.dataset.row ?? '') < 0) : [];
		for (const part of long)
			tellFault(part, 'holder and cutter together are longer than the tool');
		this.xml = read && long.length === 0 ? setupXml(data, this.axes, this.toolRows().map((part) => part.dataset.row ?? '')) : '';
		showFile(this.part('#setup-made'), this.xml);
		document.dispatchEvent(new Event('setup-written'));
	}
}
