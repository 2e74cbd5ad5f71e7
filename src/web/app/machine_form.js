// @ts-check
/**
 * machine_form.js - the form with a machine's parameters. `fivecheck init` makes the XML of it and judges what was entered; each
 * of its errors stands at the field that it is about.
 */
import {element} from './page.js';

/** Which axes a family has in the form, at first. */
const AXES = ['X', 'Y', 'Z', 'A', 'B', 'C'];
const ROTARY = 'ABC';

/** What the fields hold at first: the machine of the paper, a table that tilts and turns. */
const FIRST = {
	X: {min: '-300', max: '300'}, Y: {min: '-250', max: '250'}, Z: {min: '-400', max: '0'},
	A: {min: '-120', max: '30', location: '0,0,120'}, B: {min: '', max: '', location: '0,0,0'}, C: {min: '', max: '', location: '0,0,120'},
};

/** @param {HTMLElement} form */
function axisRows(form) {
	const rows = /** @type {HTMLElement} */ (form.querySelector('#axes'));
	for (const axis of AXES) {
		const first = /** @type {any} */ (FIRST)[axis], rotary = ROTARY.includes(axis);
		const unit = rotary ? 'degrees' : 'mm';
		/** @param {string} name @param {string} label @param {string} value */
		const field = (name, label, value) => element('label', {}, label,
			element('input', {name: `${axis}.${name}`, value, autocomplete: 'off', ...(name === 'title' ? {} : {inputMode: 'text'})}));
		rows.append(element('fieldset', {className: 'axis', dataset: {axis}},
			element('legend', {}, `Axis ${axis}`),
			field('title', 'title', ''), field('min', `limit_min, ${unit}`, first.min), field('max', `limit_max, ${unit}`, first.max),
			...(rotary ? ['x', 'y', 'z'].map((letter, i) => field(`location_${letter}`, `location_${letter}, mm`, first.location.split(',')[i]))
				: [element('label', {className: 'tick'}, element('input', {type: 'checkbox', name: `${axis}.table`}), 'moves the table')]),
			field('body', 'body (STL file)', ''), element('p', {className: 'fault', role: 'alert'})));
	}
}

/**
 * The arguments of `fivecheck init` for what is entered.
 * @param {FormData} data
 */
export function initArguments(data) {
	/** @param {string} name */
	const value = (name) => String(data.get(name) ?? '').trim();
	const rotary = value('rotary').split(',');
	const args = [value('family'), `--rotary=${rotary.join(',')}`];
	const table = ['X', 'Y', 'Z'].filter((axis) => data.get(`${axis}.table`));
	if (table.length)
		args.push(`--table=${table.join(',')}`);
	for (const axis of ['X', 'Y', 'Z', ...rotary]) {
		const min = value(`${axis}.min`), max = value(`${axis}.max`);
		args.push(`--limits=${axis}=${min === '' && max === '' ? 'none' : `${min}:${max}`}`);
		if (value(`${axis}.title`))
			args.push(`--title=${axis}=${value(`${axis}.title`)}`);
		if (rotary.includes(axis))
			args.push(`--location=${axis}=${['x', 'y', 'z'].map((letter) => value(`${axis}.location_${letter}`)).join(',')}`);
		if (value(`${axis}.body`))
			args.push(`--body=${axis}=${value(`${axis}.body`)}`);
	}
	args.push(`--spindle=${['x', 'y', 'z'].map((letter) => value(`spindle.${letter}`)).join(',')}`);
	if (value('base.body'))
		args.push(`--body=base=${value('base.body')}`);
	if (value('name'))
		args.push(`--name=${value('name')}`);
	args.push(`--dialect=${value('dialect')}`);
	return args;
}

/**
 * Which field a message of `fivecheck init` is about: that of an axis, of the spindle, or none.
 * @param {string} message
 */
export function fieldOf(message) {
	const missing = message.match(/missing: (?:([XYZABC]): )?.*like --([a-z-]+)/);
	const wrong = message.match(/--([a-z-]+): '(?:(base|[XYZABC])=)?/);
	const [option, axis] = missing ? [missing[2], missing[1]] : wrong ? [wrong[1], wrong[2]] : [];
	return axis && axis !== 'base' ? axis : option === 'spindle' ? 'spindle' : '';
}

export class MachineForm {
	/**
	 * @param {HTMLFormElement} form
	 * @param {import('./client.js').Client} client
	 * @param {(xml: string) => void} use the user wants to check with this machine
	 */
	constructor(form, client, use) {
		this.form = form;
		this.client = client;
		this.xml = '';
		axisRows(form);
		form.addEventListener('submit', (event) => {
			event.preventDefault();
			this.write();
		});
		form.addEventListener('change', () => this.showAxes());
		this.part('#use-machine').addEventListener('click', () => use(this.xml));
		this.showAxes();
	}

	/** @param {string} selector */
	part(selector) {
		return /** @type {HTMLElement} */ (this.form.querySelector(selector));
	}

	/** Only the two rotary axes that the machine has. */
	showAxes() {
		const rotary = String(new FormData(this.form).get('rotary'));
		for (const axis of ROTARY)
			this.part(`[data-axis=${axis}]`).hidden = !rotary.includes(axis);
	}

	async write() {
		const {status, out, err} = await this.client.run(['init', ...initArguments(new FormData(this.form))]);
		this.form.querySelectorAll('.fault').forEach((fault) => fault.textContent = '');
		this.form.querySelectorAll('[aria-invalid]').forEach((field) => field.removeAttribute('aria-invalid'));
		for (const line of err.split('\n').filter((text) => text.includes('error: '))) {
			const field = fieldOf(line), place = this.part(field ? `[data-axis=${field}]` : '#form-fault');
			const fault = /** @type {HTMLElement} */ (field ? place.querySelector('.fault') : place);
			fault.textContent += line.replace(/^.*error: /, '') + '\n';
			if (field) place.setAttribute('aria-invalid', 'true');
		}
		this.xml = status === 0 ? out : '';
		this.part('#machine-xml').textContent = this.xml;
		this.part('#machine-made').hidden = status !== 0;
		const link = /** @type {HTMLAnchorElement} */ (this.part('#download-machine'));
		URL.revokeObjectURL(link.href);
		link.href = URL.createObjectURL(new Blob([this.xml], {type: 'application/xml'}));
		document.dispatchEvent(new CustomEvent('machine-written', {detail: status}));
	}
}
