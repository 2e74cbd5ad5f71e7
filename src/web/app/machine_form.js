// @ts-check
/**
 * machine_form.js - the form with a machine's parameters. `fivecheck init` makes the XML of it and judges what was entered; each
 * of its errors stands at the field that it is about.
 */
import {forgetFaults, meshField, namesIn, numberField, numbersAreRead, readNumber, showFile, tellFault, textField, watchNumbers} from './fields.js';
import {element} from './page.js';

/** Which axes a family has in the form, at first. */
const AXES = ['X', 'Y', 'Z', 'A', 'B', 'C'];
const ROTARY = 'ABC';

/** What the fields hold at first: the machine of the paper, a table that tilts and turns. */
const FIRST = {
	X: {min: '-300', max: '300'}, Y: {min: '-250', max: '250'}, Z: {min: '-400', max: '0'},
	A: {min: '-120', max: '30', location: '0,0,120'}, B: {min: '', max: '', location: '0,0,0'}, C: {min: '', max: '', location: '0,0,120'},
};

/**
 * @param {HTMLElement} form
 * @param {(found: [string, Blob][]) => void} add takes meshes
 */
function axisRows(form, add) {
	const rows = /** @type {HTMLElement} */ (form.querySelector('#axes'));
	for (const axis of AXES) {
		const first = /** @type {any} */ (FIRST)[axis], rotary = ROTARY.includes(axis);
		const unit = rotary ? 'degrees' : 'mm';
		rows.append(element('fieldset', {className: 'axis', dataset: {axis}},
			element('legend', {}, `Axis ${axis}`), textField(`${axis}.title`, 'title'),
			numberField(`${axis}.min`, `limit_min, ${unit}`, first.min), numberField(`${axis}.max`, `limit_max, ${unit}`, first.max),
			...(rotary ? ['x', 'y', 'z'].map((letter, i) => numberField(`${axis}.location_${letter}`, `location_${letter}, mm`, first.location.split(',')[i], true))
				: [element('label', {className: 'tick'}, element('input', {type: 'checkbox', name: `${axis}.table`}), 'moves the table')]),
			meshField(`${axis}.body`, 'bodies (STL files)', true, add), element('p', {className: 'fault', role: 'alert'})));
	}
}

/**
 * The arguments of `fivecheck init` for what is entered.
 * @param {FormData} data
 */
export function initArguments(data) {
	/** @param {string} name */
	const value = (name) => String(data.get(name) ?? '').trim();
	/** @param {string} name */
	const number = (name) => readNumber(value(name)).number;
	const rotary = value('rotary').split(',');
	const args = [value('family'), `--rotary=${rotary.join(',')}`];
	const table = ['X', 'Y', 'Z'].filter((axis) => data.get(`${axis}.table`));
	if (table.length)
		args.push(`--table=${table.join(',')}`);
	for (const axis of ['X', 'Y', 'Z', ...rotary]) {
		const min = number(`${axis}.min`), max = number(`${axis}.max`);
		args.push(`--limits=${axis}=${min === '' && max === '' ? 'none' : `${min}:${max}`}`);
		if (value(`${axis}.title`))
			args.push(`--title=${axis}=${value(`${axis}.title`)}`);
		if (rotary.includes(axis))
			args.push(`--location=${axis}=${['x', 'y', 'z'].map((letter) => number(`${axis}.location_${letter}`)).join(',')}`);
		args.push(...namesIn(value(`${axis}.body`)).map((mesh) => `--body=${axis}=${mesh}`));
	}
	args.push(`--spindle=${['x', 'y', 'z'].map((letter) => number(`spindle.${letter}`)).join(',')}`);
	args.push(...namesIn(value('base.body')).map((mesh) => `--body=base=${mesh}`));
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
	 * @param {(found: [string, Blob][]) => void} add takes the meshes that are chosen
	 * @param {(xml: string) => void} use the user wants to check with this machine
	 */
	constructor(form, client, add, use) {
		this.form = form;
		this.client = client;
		this.xml = '';
		this.part('#base-body').append(meshField('base.body', 'bodies of the base (STL files)', true, add));
		axisRows(form, add);
		watchNumbers(form);
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
		forgetFaults(this.form);
		this.xml = numbersAreRead(this.form) && this.limitsAreRight() ? await this.written() : '';
		showFile(this.part('#machine-made'), this.xml);
		document.dispatchEvent(new CustomEvent('machine-written'));
	}

	/** Tells where a travel has one end alone, or ends before it begins. */
	limitsAreRight() {
		const data = new FormData(this.form);
		const wrong = AXES.filter((axis) => {
			const part = this.part(`[data-axis=${axis}]`);
			const [min, max] = ['min', 'max'].map((end) => readNumber(String(data.get(`${axis}.${end}`))).number);
			const text = (min === '') !== (max === '') ? 'the travel has one end alone; leave both empty if it has none'
				: min !== '' && Number(min) >= Number(max) ? 'limit_min is to be less than limit_max' : '';
			if (text && !part.hidden)
				tellFault(part, text);
			return text && !part.hidden;
		});
		return wrong.length === 0;
	}

	/** The machine file, or '' where `fivecheck init` says what is wrong. */
	async written() {
		const {status, out, err} = await this.client.run(['init', ...initArguments(new FormData(this.form))]);
		for (const line of err.split('\n').filter((text) => text.includes('error: '))) {
			const field = fieldOf(line);
			tellFault(this.part(field ? `[data-axis=${field}]` : '#form-fault'), line.replace(/^.*error: /, ''));
		}
		return status === 0 ? out : '';
	}
}
