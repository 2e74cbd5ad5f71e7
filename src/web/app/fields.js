// @ts-check
/**
 * fields.js - the fields of a form: numbers as people type them, meshes that are chosen, and faults, shown at their
 * fields.
 */
import {element} from './page.js';

/**
 * Converts a typed number to the checker's form. A comma is a decimal comma, unless it may separate thousands.
 * @param {string} typed
 * @returns {{number: string, fault: string}} one of them is ''; both, where nothing was typed
 */
export function readNumber(typed) {
	const text = typed.trim().replace('\u2212', '-'), pointed = text.replace(',', '.');
	if (text !== '' && !/^[+-]?(\d+[.,]?\d*|[.,]\d+)$/.test(text))
		return {number: '', fault: `'${text}' is not a number`};
	if (/^[+-]?[1-9]\d{0,2},\d{3}$/.test(text))
		return {number: '', fault: `'${text}' may be ${text.replace(',', '')} or ${Number(pointed)}: write it without the comma`};
	return {number: pointed, fault: ''};
}

/**
 * A field for a number; when the user leaves it, it shows the number as it was understood.
 * @param {string} name @param {string} label @param {string} value
 * @param {boolean} [required]
 * @param {string} [placeholder] shown as long as the field is empty: "such as" some value, or what an empty field stands for
 */
export function numberField(name, label, value, required = false, placeholder = '') {
	return element('label', {}, label, element('input', {name, value, placeholder, autocomplete: 'off', dataset: {number: required ? 'required' : 'optional'}}));
}

/**
 * Three fields for x, y and z: mm, or a direction without a unit.
 * @param {string} name @param {string} label @param {string[]} like
 * @param {boolean} [required] else all three may be left out, which stands for `like`
 */
export function vectorFields(name, label, like, required = true) {
	return ['x', 'y', 'z'].map((letter, i) => {
		const words = `${label && `${label}_`}${letter}${label === 'direction' ? '' : ', mm'}`;
		const field = numberField(`${name}.${letter}`, words, '', required, required ? `such as ${like[i]}` : like[i] ?? '');
		Object.assign(/** @type {HTMLElement} */ (field.querySelector('input')).dataset, required ? {} : {vector: name});
		return field;
	});
}

/** The three numbers of a vector as x,y,z; '' if none is given. @param {FormData} data @param {string} name */
export function vectorIn(data, name) {
	const all = ['x', 'y', 'z'].map((letter) => readNumber(String(data.get(`${name}.${letter}`) ?? '')).number);
	return all.some((number) => number !== '') ? all.join(',') : '';
}

/** Fields that few users need, under a title. @param {string} title @param {HTMLElement[]} fields */
export function moreFields(title, ...fields) {
	return element('details', {className: 'more'}, element('summary', {}, title), element('div', {className: 'fields'}, ...fields));
}

/** Shows the unit in the labels of lengths. @param {HTMLElement} form @param {string} unit */
export function showUnit(form, unit) {
	form.querySelectorAll('label').forEach(({firstChild}) => {
		if (firstChild instanceof Text)
			firstChild.data = firstChild.data.replace(/, (mm|inch)\b/, `, ${unit}`);
	});
}

/** @param {string} name @param {string} label @param {string} [value] */
export function textField(name, label, value = '') {
	return element('label', {}, label, element('input', {name, value, autocomplete: 'off'}));
}

/**
 * A field for the names of files, of meshes if nothing else is said, with a button that chooses them.
 * @param {string} name @param {string} label
 * @param {boolean} several
 * @param {(found: [string, Blob][]) => void} add takes the files
 */
export function meshField(name, label, several, add, accept = '.stl,.obj,.ply') {
	const text = /** @type {HTMLInputElement} */ (element('input', {name, autocomplete: 'off'}));
	const choose = /** @type {HTMLInputElement} */ (element('input', {type: 'file', multiple: several, accept, ariaLabel: `Choose: ${label}`}));
	choose.addEventListener('change', () => {
		const files = [...(choose.files ?? [])];
		text.value = files.map((file) => file.name).join(', ');
		add(files.map((file) => [file.name, file]));
		choose.value = '';
	});
	return element('div', {className: 'mesh'}, element('label', {}, label, text), element('label', {className: 'button'}, 'Choose', choose));
}

/** The names in a field for meshes. @param {string} text */
export function namesIn(text) {
	return text.split(',').map((name) => name.trim()).filter((name) => name !== '');
}

/**
 * When the user leaves a number, it is shown as it was understood; if one number of a vector was entered, the others
 * are written, too.
 * @param {HTMLElement} form
 */
export function watchNumbers(form) {
	form.addEventListener('change', ({target}) => {
		if (!(target instanceof HTMLInputElement) || !target.dataset.number)
			return;
		target.value = readNumber(target.value).number || target.value;
		const others = /** @type {HTMLInputElement[]} */ (target.dataset.vector && target.value ? [...form.querySelectorAll(`[data-vector="${target.dataset.vector}"]`)] : []);
		others.forEach((field) => field.value ||= field.placeholder);
	});
}

/** @param {HTMLElement} form */
export function forgetFaults(form) {
	form.querySelectorAll('.fault').forEach((fault) => fault.textContent = '');
	form.querySelectorAll('[aria-invalid]').forEach((field) => ['aria-invalid', 'aria-describedby'].forEach((name) => field.removeAttribute(name)));
}

/**
 * Shows a fault at a part of the form, and marks the field.
 * @param {HTMLElement} part with a place for faults @param {string} text @param {HTMLElement} [field]
 */
export function tellFault(part, text, field) {
	/** @type {NodeListOf<HTMLDetailsElement>} */ (part.querySelectorAll('details')).forEach((more) => more.open ||= more.contains(field ?? null));
	for (let around = part.closest('details'); around; around = around.parentElement?.closest('details') ?? null)
		around.open = true;
	const place = /** @type {HTMLElement} */ (part.matches('.fault') ? part : part.querySelector(':scope > .fault') ?? part.querySelector('.fault'));
	place.textContent += `${text}\n`;
	if (place !== part)
		part.setAttribute('aria-invalid', 'true');
	for (let number = 0; !place.id; number++)
		place.id = document.getElementById(`fault-${number}`) ? '' : `fault-${number}`;
	field?.setAttribute('aria-invalid', 'true');
	field?.setAttribute('aria-describedby', place.id);
}

/**
 * Shows each number that is missing or cannot be read; the first of these fields gets the focus.
 * @param {HTMLFormElement} form
 * @returns {boolean} whether all can be read
 */
export function numbersAreRead(form) {
	const fields = [.../** @type {NodeListOf<HTMLInputElement>} */ (form.querySelectorAll('input[data-number]'))].filter((field) => !field.disabled && !field.closest('[hidden]'));
	const wrong = fields.filter((field) => {
		const {number, fault} = readNumber(field.value), label = field.closest('label')?.textContent ?? field.name;
		const text = fault || (number === '' && field.dataset.number === 'required' ? 'a number is missing' : '');
		if (text)
			tellFault(/** @type {HTMLElement} */ (field.closest('fieldset')), `${label}: ${text}`, field);
		return text;
	});
	wrong[0]?.focus();
	return wrong.length === 0;
}

/** Shows each vector that is only partly given. @param {HTMLFormElement} form */
export function vectorsAreWhole(form) {
	const fields = [.../** @type {NodeListOf<HTMLInputElement>} */ (form.querySelectorAll('input[data-vector]'))].filter((field) => !field.closest('[hidden]'));
	const names = new Set(fields.map((field) => field.dataset.vector));
	const broken = [...names].filter((name) => {
		const three = fields.filter((field) => field.dataset.vector === name), empty = three.filter((field) => field.value.trim() === '');
		if (empty.length % 3)
			tellFault(/** @type {HTMLElement} */ (three[0].closest('fieldset')), 'give all three numbers, or none', empty[0]);
		return empty.length % 3;
	});
	return broken.length === 0;
}

/**
 * A file that was written: its text is shown, and may be edited, downloaded, and used.
 * @param {HTMLElement} made with a link, a `textarea` and a button
 * @param {(xml: string) => void} use takes the text as it stands there
 * @returns {(xml: string) => void} shows a text; '' hides all
 */
export function writtenFile(made, use) {
	const link = /** @type {HTMLAnchorElement} */ (made.querySelector('a')), text = /** @type {HTMLTextAreaElement} */ (made.querySelector('textarea'));
	const offer = () => {
		URL.revokeObjectURL(link.href);
		link.href = URL.createObjectURL(new Blob([text.value], {type: 'application/xml'}));
	};
	text.addEventListener('input', offer);
	/** @type {HTMLElement} */ (made.querySelector('button')).addEventListener('click', () => use(text.value));
	return (xml) => {
		text.value = xml;
		text.rows = Math.min(24, xml.split('\n').length + 1);
		made.hidden = xml === '';
		offer();
	};
}
