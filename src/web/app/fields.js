// @ts-check
/** fields.js - the fields of a form: numbers as people type them, meshes that are chosen, and what is wrong, told where it stands. */
import {element} from './page.js';

/**
 * A number that a person typed, as the checker reads it. A comma is a decimal comma, unless the text may be thousands, too.
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
 * A field for a number; once it is left, it shows what was understood.
 * @param {string} name @param {string} label @param {string} value
 * @param {boolean} [required]
 * @param {string} [like] some value, shown as long as the field is empty
 */
export function numberField(name, label, value, required = false, like = '') {
	const placeholder = like && `such as ${like}`;
	return element('label', {}, label, element('input', {name, value, placeholder, autocomplete: 'off', dataset: {number: required ? 'required' : 'optional'}}));
}

/** @param {string} name @param {string} label @param {string} [value] */
export function textField(name, label, value = '') {
	return element('label', {}, label, element('input', {name, value, autocomplete: 'off'}));
}

/**
 * A field for the names of meshes, with a button that chooses them.
 * @param {string} name @param {string} label
 * @param {boolean} several
 * @param {(found: [string, Blob][]) => void} add takes the files
 */
export function meshField(name, label, several, add) {
	const text = /** @type {HTMLInputElement} */ (element('input', {name, autocomplete: 'off'}));
	const choose = /** @type {HTMLInputElement} */ (element('input', {type: 'file', multiple: several, accept: '.stl,.obj,.ply', ariaLabel: `Choose: ${label}`}));
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

/** Numbers show what was understood of them as soon as they are left. @param {HTMLElement} form */
export function watchNumbers(form) {
	form.addEventListener('change', ({target}) => {
		if (target instanceof HTMLInputElement && target.dataset.number)
			target.value = readNumber(target.value).number || target.value;
	});
}

/** @param {HTMLElement} form */
export function forgetFaults(form) {
	form.querySelectorAll('.fault').forEach((fault) => fault.textContent = '');
	form.querySelectorAll('[aria-invalid]').forEach((field) => field.removeAttribute('aria-invalid'));
}

/**
 * Says what is wrong at a part of the form, and marks it.
 * @param {HTMLElement} part with a place for faults @param {string} text @param {HTMLElement} [field]
 */
export function tellFault(part, text, field) {
	const place = /** @type {HTMLElement} */ (part.matches('.fault') ? part : part.querySelector('.fault'));
	place.textContent += `${text}\n`;
	if (place !== part)
		part.setAttribute('aria-invalid', 'true');
	field?.setAttribute('aria-invalid', 'true');
}

/**
 * Tells of each number that is missing or cannot be read; the first of these fields has the focus then.
 * @param {HTMLFormElement} form
 * @returns {boolean} whether all can be read
 */
export function numbersAreRead(form) {
	const fields = [.../** @type {NodeListOf<HTMLInputElement>} */ (form.querySelectorAll('input[data-number]'))].filter((field) => !field.closest('[hidden]'));
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

/**
 * A file that was written: its text is shown, and may be downloaded.
 * @param {HTMLElement} made with a link and a `pre` @param {string} xml
 */
export function showFile(made, xml) {
	const link = /** @type {HTMLAnchorElement} */ (made.querySelector('a'));
	URL.revokeObjectURL(link.href);
	link.href = URL.createObjectURL(new Blob([xml], {type: 'application/xml'}));
	/** @type {HTMLElement} */ (made.querySelector('pre')).textContent = xml;
	made.hidden = xml === '';
}
