// @ts-check
/**
 * setup_form.js - the form for a job's setup: work offsets, part, fixtures, stock, tools. The check judges the file
 * that it writes like any other setup file.
 */
import {forgetFaults, meshField, moreFields, numberField, numbersAreRead, showUnit, tellFault, textField, vectorFields, vectorsAreWhole, watchNumbers, writtenFile} from './fields.js';
import {element} from './page.js';
import {axesIn, offsetsIn, toolsIn} from './setup_proposal.js';
import {setupXml, toolFault} from './setup_xml.js';

const AXES = ['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'];
/** The kinds of tools, and of the ends of their cutters. @type {[string, string][]} */
const KINDS = [['cutter', 'cutter'], ['probe', 'probe'], ['nozzle', 'nozzle'], ['laser', 'laser'], ['drag', 'drag knife']];
/** @type {[string, string][]} */
const TIPS = [['flat', 'flat'], ['ball', 'ball'], ['bull', 'bull-nose'], ['cone', 'cone (drill)']];

/** The question of some rows, by their kind. @type {Record<string, {title: string, field: string, missing: string}>} */
const ROWS = {
	offset: {title: 'Work offset', field: 'name', missing: 'a name is missing, such as G54'},
	tool: {title: 'Tool', field: 'number', missing: ''},
	table: {title: 'Tool library', field: 'href', missing: 'the file is missing'},
	register: {title: 'Length and radius of H and D', field: 'number', missing: ''},
	variable: {title: 'Variable', field: 'name', missing: 'a name is missing, such as #500, R5 or Q1600'},
};
/** The file names of libraries and tables of tools. */
const LIBRARIES = '.json,.csv,.tls,.tbl,.txt,.nc';

/** @param {string} text */
function noteOf(text) {
	return element('p', {className: 'note'}, text);
}

/** @param {string} name @param {string} label @param {[string, string][]} choices value and words */
function choiceField(name, label, choices) {
	return element('label', {}, label, element('select', {name}, ...choices.map(([value, words]) => element('option', {value}, words))));
}

/**
 * Fields that exist only with certain choices of their row; with any choice for *.
 * @param {string} choice @param {HTMLElement[]} fields
 */
function onlyIf(choice, ...fields) {
	fields.forEach((field) => field.dataset.if = choice);
	return fields;
}

/** The place of a solid. @param {string} row */
function placeFields(row) {
	return [...vectorFields(`${row}.location`, 'location', ['0', '0', '0'], false)];
}

/** @param {string} row @param {HTMLElement[]} others */
function moreOfSolid(row, ...others) {
	const turned = ['x', 'y', 'z'].map((letter) => numberField(`${row}.rotation.${letter}`, `rotation_${letter}, degrees`, '', false, '0'));
	turned.forEach((field) => /** @type {HTMLElement} */ (field.querySelector('input')).dataset.vector = `${row}.rotation`);
	return moreFields(others.length ? 'Rotation, allowances' : 'Rotation', ...turned, ...others);
}

/** @param {string} row @param {{number: string, name: string}} tool */
function toolFields(row, {number, name}) {
	const own = (/** @type {string} */ field, /** @type {string} */ label, required = true, like = '') => numberField(`${row}.${field}`, label, '', required, like);
	const nameField = textField(`${row}.name`, 'name', name);
	return [numberField(`${row}.number`, 'T number', number, true), nameField, choiceField(`${row}.kind`, 'kind', KINDS),
		own('length', 'length, gauge point to tip, mm', true, 'such as 120'),
		...onlyIf('holderMesh=', own('holderLength', 'holder: length, mm', true, 'such as 60'), own('holderDiameter', 'holder: diameter, mm', true, 'such as 50')),
		...onlyIf('cutterMesh=', own('cutterLength', 'cutter: length, mm', true, 'such as 40')), own('cutterDiameter', 'cutter: diameter, mm', true, 'such as 10'),
		...onlyIf('cutterMesh=', choiceField(`${row}.tip`, 'tip', TIPS)), ...onlyIf('tip=cone', own('angle', 'angle of the cone, degrees', true, 'such as 118')),
		...onlyIf('tip=bull', own('corner', 'corner radius, mm', true, 'such as 1'))];
}

/** @param {string} row @param {(found: [string, Blob][]) => void} add */
function moreOfTool(row, add) {
	const own = (/** @type {string} */ field, /** @type {string} */ label, like = '') => numberField(`${row}.${field}`, label, '', false, like);
	return moreFields('Forms of holder and shank, length offset, flutes, hand',
		...onlyIf('holderMesh=', own('holderEnd', 'holder: lower diameter, mm', 'as above'), own('collarLength', 'its second section: length, mm', 'none'),
			own('collarDiameter', 'second section: diameter, mm'), own('collarEnd', 'second section: lower diameter, mm', 'as above')),
		...onlyIf('cutterMesh=', own('shankDiameter', 'shank: diameter, mm', 'the cutter\u2019s'), own('flutes', 'flute length, mm', 'all')),
		own('lengthOffset', 'length offset H on the control, mm', 'the length'), choiceField(`${row}.hand`, 'hand', [['', 'not told'], ['right', 'right: cuts with M3'], ['left', 'left: cuts with M4']]),
		meshField(`${row}.holderMesh`, 'holder as a mesh (STL file)', false, add), meshField(`${row}.cutterMesh`, 'cutter as a mesh (STL file)', false, add));
}

export class SetupForm {
	/**
	 * @param {HTMLFormElement} form
	 * @param {(found: [string, Blob][]) => void} add takes the meshes that are chosen
	 * @param {(xml: string) => void} use the user wants to check with this setup
	 */
	constructor(form, add, use) {
		this.form = form;
		this.add = add;
		this.axes = ['X', 'Y', 'Z'];
		this.rows = 0;
		/** Values that the user has changed are no longer proposed. @type {Set<string>} */
		this.touched = new Set();
		this.addSolid('part');
		this.addSolid('fixture');
		this.part('#stock').append(...this.stockFields());
		watchNumbers(form);
		for (const kind of ['offset', 'fixture', 'tool', 'table', 'register', 'variable']) {
			this.part(`#${kind}s`).addEventListener('input', () => this.touched.add(kind));
			this.part(`#add-${kind}`).addEventListener('click', () => {
				this.touched.add(kind);
				this.addRow(kind).querySelector('input')?.focus();
			});
		}
		form.addEventListener('change', () => this.fit());
		form.addEventListener('submit', (event) => {
			event.preventDefault();
			this.write();
		});
		this.show = writtenFile(this.part('#setup-made'), use);
		this.propose('', []);
	}

	/** @param {string} selector */
	part(selector) {
		return /** @type {HTMLElement} */ (this.form.querySelector(selector));
	}

	/** The names of the rows of a kind. @param {string} kind */
	rowsOf(kind) {
		return /** @type {HTMLElement[]} */ ([...this.form.querySelectorAll(`[data-kind=${kind}]`)]).map(({dataset}) => dataset.row ?? '');
	}

	/** The values of a field in all rows of a kind. @param {string} kind @param {string} field */
	valuesOf(kind, field) {
		return this.rowsOf(kind).map((row) => /** @type {HTMLInputElement} */ (this.part(`[name="${row}.${field}"]`)).value.trim());
	}

	/**
	 * Adapts the form to the machine, to the calls in the programs, and to the tool libraries.
	 * @param {string} machine @param {string[]} programs @param {string[]} libraries
	 */
	propose(machine, programs, libraries = []) {
		this.axes = axesIn(machine);
		const tools = toolsIn(programs), numbers = libraries.length ? [] : tools.length ? tools : [{number: '1', name: ''}];
		/** @type {[string, () => void][]} */
		const proposals = [['offset', () => offsetsIn(machine, programs).forEach((name) => this.addOffset(name))], ['tool', () => numbers.forEach((tool) => this.addTool(tool))],
			['table', () => libraries.forEach((path) => this.addTable(path))]];
		for (const [kind, add] of proposals) {
			if (this.touched.has(kind))
				continue;
			this.part(`#${kind}s`).replaceChildren();
			add();
		}
		/** @type {HTMLDetailsElement} */ (this.part('#more-setup')).open ||= libraries.length > 0;
		this.fit();
	}

	/** Shows the fields that apply. */
	fit() {
		for (const axis of AXES)
			this.form.querySelectorAll(`[name^="offset-"][name$=".${axis}"]`).forEach((field) => /** @type {HTMLElement} */ (field.closest('label')).hidden = !this.axes.includes(axis));
		for (const field of /** @type {NodeListOf<HTMLElement>} */ (this.form.querySelectorAll('[data-if]'))) {
			const [name, value] = (field.dataset.if ?? '').split('='), row = /** @type {HTMLElement} */ (field.closest('[data-row]'));
			const choice = /** @type {HTMLInputElement} */ (row.querySelector(`[name="${row.dataset.row}.${name}"]`)), there = !choice.closest('[hidden]');
			field.hidden = value === '*' ? choice.value === '' : choice.value.trim() !== value || (value !== '' && !there);
		}
		showUnit(this.form, /** @type {HTMLSelectElement} */ (this.part('[name="setup.units"]')).value);
	}

	/**
	 * A row of the form, with a button that removes it.
	 * @param {string} kind @param {string} row @param {string} title @param {HTMLElement[]} fields
	 */
	row(kind, row, title, ...fields) {
		const remove = element('button', {type: 'button', ariaLabel: `Remove: ${title}`}, 'Remove');
		const part = element('fieldset', {className: 'axis', dataset: {row, kind}}, element('legend', {}, title), ...fields, element('p', {className: 'fault', role: 'alert'}));
		if (kind !== 'part')
			part.insertBefore(remove, part.querySelector('.more, .fault'));
		remove.addEventListener('click', () => {
			this.touched.add(kind);
			const button = /** @type {HTMLElement} */ (kind === 'edge' ? part.closest('.more')?.querySelector('.add-edge') : this.part(`#add-${kind}`));
			part.remove();
			button.focus();
		});
		this.form.querySelector(`#${kind}s`)?.append(part);
		return part;
	}

	/** An empty row. @param {string} kind */
	addRow(kind) {
		const next = () => ({number: String(Math.max(0, ...this.valuesOf('tool', 'number').map(Number)) + 1), name: ''});
		const part = {offset: () => this.addOffset(''), tool: () => this.addTool(next()), fixture: () => this.addSolid('fixture'), table: () => this.addTable(''),
			register: () => this.addRegister(), variable: () => this.addVariable()}[kind]?.() ?? this.addSolid('fixture');
		this.fit();
		return part;
	}

	/** @param {string} path */
	addTable(path) {
		const row = `table-${this.rows++}`, part = this.row('table', row, ROWS.table.title, meshField(`${row}.href`, 'tools.json, tools.csv, tool.tbl, \u2026', false, this.add, LIBRARIES),
			choiceField(`${row}.units`, 'its unit', [['', 'as it says, or as above'], ['mm', 'mm'], ['inch', 'inch']]), textField(`${row}.numbers`, 'tools to take, such as 1 3 10-20'));
		/** @type {HTMLInputElement} */ (part.querySelector(`[name="${row}.href"]`)).value = path;
		/** @type {HTMLInputElement} */ (part.querySelector(`[name="${row}.numbers"]`)).placeholder = 'all';
		return part;
	}

	addRegister() {
		const row = `register-${this.rows++}`;
		return this.row('register', row, ROWS.register.title, noteOf('For programs whose H is not the number of the tool, and for G41 and G42 with D.'), numberField(`${row}.number`, 'number of H and D', '', true),
			numberField(`${row}.length`, 'length of H, mm', '', false, 'none'), numberField(`${row}.radius`, 'radius of D with its wear, mm', '', false, 'none'));
	}

	addVariable() {
		const row = `variable-${this.rows++}`;
		return this.row('variable', row, ROWS.variable.title, noteOf('What the control holds when a program begins.'), textField(`${row}.name`, 'name, such as #500, R5 or Q1600'), textField(`${row}.value`, 'value'),
			choiceField(`${row}.type`, 'type, of a GUD of Sinumerik', [['', 'none'], ...['REAL', 'INT', 'BOOL', 'CHAR', 'STRING', 'AXIS'].map((name) => /** @type {[string, string]} */ ([name, name]))]),
			textField(`${row}.size`, 'size of an array'));
	}

	/** A cutting edge (D) of a tool of Sinumerik. @param {HTMLElement} place @param {string} tool */
	addEdge(place, tool) {
		const row = `edge-${this.rows++}`, part = this.row('edge', row, 'Edge', numberField(`${row}.number`, 'D number', String(2 + place.childElementCount), true),
			numberField(`${row}.length`, 'length, mm', '', true), numberField(`${row}.diameter`, 'diameter, mm', '', false, 'the tool\u2019s'));
		part.dataset.of = tool;
		place.append(part);
		return part;
	}

	/** @param {string} name */
	addOffset(name) {
		const row = `offset-${this.rows++}`;
		return this.row('offset', row, ROWS.offset.title, noteOf('Where the program\u2019s zero is, as on the control\u2019s page of offsets.'), textField(`${row}.name`, 'name', name),
			...AXES.map((axis) => numberField(`${row}.${axis}`, `${axis}, ${'ABC'.includes(axis) ? 'degrees' : 'mm'}`, '', 'XYZ'.includes(axis), 'XYZ'.includes(axis) ? '' : '0')));
	}

	/** @param {'part' | 'fixture'} kind */
	addSolid(kind) {
		const row = `${kind}-${this.rows++}`, [title, label] = kind === 'part' ? ['Part', 'the finished part (STL file)'] : ['Fixtures', 'fixtures at one place (STL files)'];
		const allowances = kind === 'part' ? [numberField(`${row}.rapidAllowance`, 'depth allowed at rapid, mm', '', false, '0.1'), numberField(`${row}.gouge`, 'gouge deeper than, mm', '', false, 'not checked')] : [];
		return this.row(kind, row, title, meshField(`${row}.mesh`, label, kind === 'fixture', this.add), ...placeFields(row), moreOfSolid(row, ...allowances));
	}

	stockFields() {
		return [noteOf('The blank that the cutters cut. A box or a cylinder stands with the middle of its lower face on the location.'), choiceField('stock.form', 'form', [['', 'no stock'], ['box', 'box'], ['cylinder', 'cylinder'], ['mesh', 'STL file']]),
			...onlyIf('form=box', ...vectorFields('stock.size', 'size', ['100', '80', '50'])),
			...onlyIf('form=cylinder', numberField('stock.diameter', 'diameter, mm', '', true, 'such as 100'), numberField('stock.height', 'height, mm', '', true, 'such as 50')),
			...onlyIf('form=mesh', meshField('stock.mesh', 'the blank (STL file)', false, this.add)), ...onlyIf('form=*', ...placeFields('stock'),
			moreOfSolid('stock', numberField('stock.uncertainty', 'may be larger by, mm', '', false, '0'), numberField('stock.excess', 'may be smaller by, mm', '', false, '0'), numberField('stock.rapidAllowance', 'depth allowed at rapid, mm', '', false, '0.25'))),
			element('p', {className: 'fault', role: 'alert'})];
	}

	/** @param {{number: string, name: string}} tool */
	addTool(tool) {
		const row = `tool-${this.rows++}`, more = moreOfTool(row, this.add), edges = element('div', {}), button = element('button', {type: 'button', className: 'add-edge'}, 'Add an edge (D of Sinumerik)');
		button.addEventListener('click', () => this.addEdge(edges, row).querySelector('input')?.focus());
		more.append(edges, button);
		return this.row('tool', row, ROWS.tool.title, ...toolFields(row, tool), more);
	}

	/** The names of the rows of a tool's edges. @param {string} tool */
	edgesOf(tool) {
		return /** @type {HTMLElement[]} */ ([...this.form.querySelectorAll(`[data-of="${tool}"]`)]).map(({dataset}) => dataset.row ?? '');
	}

	/** Reports faults of tools, and names that are missing or used twice. @param {FormData} data */
	rowsAreRight(data) {
		const faults = this.rowsOf('tool').map((row) => [row, toolFault(data, row)]);
		for (const [kind, {field, missing}] of Object.entries(ROWS)) {
			const all = this.valuesOf(kind, field);
			this.rowsOf(kind).forEach((row, i) => faults.push([row, all[i] === '' ? missing : all.indexOf(all[i]) < i ? `${all[i]} is there twice` : '']));
		}
		for (const row of this.rowsOf('register'))
			faults.push([row, ['length', 'radius'].some((name) => String(data.get(`${row}.${name}`)).trim()) ? '' : 'give a length or a radius']);
		for (const tool of this.rowsOf('tool')) {
			const edges = this.edgesOf(tool), all = edges.map((row) => Number(data.get(`${row}.number`)));
			edges.forEach((row, i) => faults.push([row, all[i] < 2 ? 'D1 is the tool itself: the number of an edge is 2 or more' : all.indexOf(all[i]) < i ? `D${all[i]} is there twice` : '']));
		}
		faults.push(['stock', data.get('stock.form') === 'mesh' && !String(data.get('stock.mesh')).trim() ? 'the file of the blank is missing' : '']);
		const wrong = faults.filter(([, text]) => text !== '');
		for (const [row, text] of wrong)
			tellFault(this.part(`[data-row=${row}]`), text);
		return wrong.length === 0;
	}

	write() {
		forgetFaults(this.form);
		const data = new FormData(this.form), right = numbersAreRead(this.form) && vectorsAreWhole(this.form) && this.rowsAreRight(data);
		const rows = Object.fromEntries(['offset', 'part', 'fixture', 'tool', 'table', 'register', 'variable'].map((kind) => [kind, this.rowsOf(kind)]));
		const xml = right ? setupXml(data, this.axes, rows, (tool) => this.edgesOf(tool)) : '';
		this.show(xml);
		document.dispatchEvent(new Event('setup-written'));
	}
}
