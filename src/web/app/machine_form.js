// @ts-check
/**
 * machine_form.js - the form with a machine's parameters. `fivecheck init` makes the XML and checks the entries; each
 * of its errors is shown at the field that it is about.
 */
import {attributeIn, offerControl} from './control_fields.js';
import {forgetFaults, meshField, moreFields, namesIn, numberField, numbersAreRead, readNumber, showUnit, tellFault, textField, vectorFields, vectorsAreWhole, watchNumbers, writtenFile} from './fields.js';
import {MORE, STATUS} from './fivecheck.js';
import {chainsOf, initArguments, LINEAR, orders} from './machine_arguments.js';
import {EXAMPLES, FAMILIES, ROTARY} from './machine_families.js';
import {element} from './page.js';

/**
 * The fields of an axis; `moves` and `stands` are those that linear and rotary axes alone have.
 * @param {string} axis
 * @param {(found: [string, Blob][]) => void} add takes meshes
 */
function axisFields(axis, add) {
	const rotary = ROTARY.includes(axis), unit = rotary ? 'degrees' : 'mm';
	const tick = (/** @type {string} */ name, /** @type {string} */ label) => element('label', {className: 'tick'}, element('input', {type: 'checkbox', name: `${axis}.${name}`}), label);
	return element('fieldset', {className: 'axis', dataset: {axis}}, element('legend', {}, `Axis ${axis}`), textField(`${axis}.title`, 'title'),
		numberField(`${axis}.min`, `limit_min, ${unit}`, '', true, rotary ? 'such as -120' : 'such as -300'), numberField(`${axis}.max`, `limit_max, ${unit}`, '', true, rotary ? 'such as 30' : 'such as 300'),
		tick('endless', 'no limits'), ...(rotary ? vectorFields(`${axis}.location`, 'location', ['0', '0', '120']) : [tick('table', 'moves the table')]),
		...('AB'.includes(axis) ? [numberField(`${axis}.inclination`, 'angle to Z, degrees', '', false, '90')] : []),
		meshField(`${axis}.body`, 'bodies (STL files)', true, add),
		moreFields('Direction, rapid rate, home', ...vectorFields(`${axis}.direction`, 'direction', [], false),
			numberField(`${axis}.rate`, `rate_max, ${unit} a minute`, '', false, rotary ? '7200' : '30000'), numberField(`${axis}.home`, `home, ${unit}`, '', false, '0')),
		element('p', {className: 'fault', role: 'alert'}));
}

/**
 * The part of the form that a message of `fivecheck init` is about: that of an axis, of the spindle, of the work, of
 * the control, or none.
 * @param {string} message
 */
export function fieldOf(message) {
	const missing = message.match(/missing: (?:([XYZABC]): )?.*like --([a-z-]+)/);
	const wrong = message.match(/--([a-z-]+): '(?:(base|[XYZABC])=)?/);
	const [, about] = message.match(/(?:the home|--inclination) of ([XYZABC])\b/) ?? [];
	if (/--controller: |--tool-change[:=]/.test(message))
		return 'control';
	const [option, axis] = missing ? [missing[2], missing[1]] : wrong ? [wrong[1], wrong[2]] : ['', about];
	return axis && axis !== 'base' ? axis : option.startsWith('spindle') ? 'spindle' : option === 'workholding' ? 'work' : '';
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
		this.part('[name=family]').append(...Object.entries(FAMILIES).map(([value, {title}]) => element('option', {value}, title)));
		this.part('#base-body').append(meshField('base.body', 'bodies of the base (STL files)', true, add));
		this.part('#axes').append(...['X', 'Y', 'Z', ...ROTARY].map((axis) => axisFields(axis, add)));
		this.part('[data-axis=spindle] > .fault').before(...vectorFields('spindle', '', ['0', '0', '520']),
			moreFields('Direction', ...vectorFields('spindle-direction', 'direction', ['0', '0', '-1'], false)));
		this.part('[data-axis=work] > .fault').before(...vectorFields('workholding', '', ['0', '0', '0'], false));
		this.part('#control').before(element('div', {className: 'fields'}, ...['X', 'Y', 'Z', ...ROTARY].map((axis) => numberField(`change.${axis}`, `${axis}, ${ROTARY.includes(axis) ? 'degrees' : 'mm'}`, ''))));
		watchNumbers(form);
		form.addEventListener('submit', (event) => {
			event.preventDefault();
			this.write();
		});
		form.addEventListener('change', ({target}) => this.fit(/** @type {HTMLInputElement} */ (target).name));
		this.part('#fill-example').addEventListener('click', () => this.fill(EXAMPLES[this.value('family')]));
		this.show = writtenFile(this.part('#machine-made'), use);
		this.fit('family');
	}

	/** @param {string} selector */
	part(selector) {
		return /** @type {HTMLElement} */ (this.form.querySelector(selector));
	}

	/** @param {string} name */
	field(name) {
		return /** @type {HTMLInputElement} */ (this.form.elements.namedItem(name));
	}

	/** @param {string} name */
	value(name) {
		return this.field(name).value;
	}

	/** Shows the parts of the machine after a field was changed. @param {string} name */
	fit(name) {
		if (name === 'family')
			this.offerAxes();
		if (name === 'family' || name === 'dialect')
			offerControl(this.part('#control'), this.value('dialect'));
		const rotary = this.value('rotary'), {oblique} = FAMILIES[this.value('family')];
		for (const axis of ROTARY) {
			this.part(`[data-axis=${axis}]`).hidden = !rotary.includes(axis);
			/** @type {HTMLElement} */ (this.field(`change.${axis}`).closest('label')).hidden = !rotary.includes(axis);
			if (axis !== 'C')
				this.field(`${axis}.inclination`).placeholder = rotary.split(',')[oblique] === axis ? '45' : '90';
		}
		for (const axis of [...LINEAR, ...ROTARY])
			['min', 'max'].forEach((end) => this.field(`${axis}.${end}`).disabled = this.field(`${axis}.endless`).checked);
		if (name === '' || /^family$|^[XYZ]\.table$/.test(name))
			this.offerOrders();
		for (const axis of [...LINEAR, ...ROTARY])
			this.field(`change.${axis}`).disabled = this.field('change.none').checked;
		showUnit(this.form, this.value('units'));
	}

	/** The pairs of rotary axes that the family may have. */
	offerAxes() {
		const {rotary, first} = FAMILIES[this.value('family')];
		this.part('[name=rotary]').replaceChildren(...rotary.map((pair) => element('option', {value: pair}, pair.replace(',', first))));
	}

	/** The order in which the linear axes of table and head carry each other. */
	offerOrders() {
		const ticked = LINEAR.filter((axis) => this.field(`${axis}.table`).checked);
		for (const [name, axes] of [['table', ticked], ['head', LINEAR.filter((axis) => !ticked.includes(axis))]]) {
			const select = this.part(`[name="order.${name}"]`);
			select.replaceChildren(...orders(/** @type {string[]} */ (axes)).map((order) => element('option', {value: order.join()}, order.join(' carries '))));
			/** @type {HTMLElement} */ (select.closest('label')).hidden = axes.length < 2;
		}
	}

	/** Enters the numbers of an example, with its axes. @param {Record<string, string>} example by the name of the field; '+' ticks */
	fill(example) {
		for (const field of /** @type {NodeListOf<HTMLInputElement>} */ (this.form.querySelectorAll('#axes input:not([type=file]), [data-axis] input:not([type=file])'))) {
			field.checked = example[field.name] === '+';
			field.value = field.type === 'checkbox' ? 'on' : example[field.name] ?? (field.name.endsWith('.body') ? field.value : '');
		}
		this.field('rotary').value = example.rotary;
		this.fit('');
	}

	async write() {
		forgetFaults(this.form);
		const xml = [numbersAreRead(this.form), vectorsAreWhole(this.form), this.limitsAreRight()].every(Boolean) ? await this.written() : '';
		this.show(xml);
		document.dispatchEvent(new CustomEvent('machine-written'));
	}

	/** Reports travels that end before they begin. */
	limitsAreRight() {
		const wrong = [...LINEAR, ...ROTARY].filter((axis) => {
			const part = this.part(`[data-axis=${axis}]`), [min, max] = ['min', 'max'].map((end) => readNumber(this.value(`${axis}.${end}`)).number);
			const is = !part.hidden && !this.field(`${axis}.endless`).checked && min !== '' && max !== '' && Number(min) >= Number(max);
			if (is)
				tellFault(part, 'limit_min is to be less than limit_max', this.field(`${axis}.min`));
			return is;
		});
		return wrong.length === 0;
	}

	/** The machine file, or '' if `fivecheck init` reports an error. */
	async written() {
		const {status, out, err} = await this.client.run(['init', ...initArguments(new FormData(this.form))], [], [MORE])
			.catch(({message}) => ({status: STATUS.INTERNAL, out: '', err: `error: ${message}`}));
		for (const line of err.split('\n').filter((text) => text.includes('error: '))) {
			const field = fieldOf(line), mesh = line.match(/give the file (.*) another name/)?.[1];
			const named = [...this.form.querySelectorAll('.mesh input:not([type])')].find((input) => namesIn(/** @type {HTMLInputElement} */ (input).value).includes(mesh ?? ''));
			const attribute = /** @type {HTMLElement | null} */ (this.form.querySelector(`[name="controller.${attributeIn(line)}"]`));
			const place = field ? this.part(`[data-axis=${field}]`) : /** @type {HTMLElement | null | undefined} */ (named?.closest('[data-axis]'));
			tellFault(place ?? this.part('#form-fault'), line.replace(/^.*?error: (--controller: )?/, ''), attribute ?? undefined);
			attribute?.focus();
		}
		this.part('#machine-chains').textContent = chainsOf(err);
		return status === 0 ? out : '';
	}
}
