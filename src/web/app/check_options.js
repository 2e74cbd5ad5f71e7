// @ts-check
/**
 * check_options.js - the options that affect a verdict, with the texts of `fivecheck --help`, and the command line with
 * them.
 */
import {readNumber} from './fields.js';
import {element} from './page.js';

/**
 * An option: what it takes, and what it means. Fields for numbers are empty as long as the default holds; a choice is one of
 * `choices`, and without these an option with no value is a tick.
 * @typedef {{option: string, words: string, number?: boolean, text?: boolean, choices?: [string, string][]}} Option
 */

/** Those that few need. @type {Option[]} */
const MORE = [
	{option: 'dialect=NAME', words: 'linuxcnc, fanuc, haas, sinumerik, klartext or auto; overrides the machine file; auto: find the dialect from codes that only some controls have',
		choices: [['', 'that of the machine file'], ...['linuxcnc', 'fanuc', 'haas', 'sinumerik', 'klartext', 'auto'].map((name) => /** @type {[string, string]} */ ([name, name]))]},
	{option: 'tolerance=MM', words: 'how exactly contact is decided, and how exactly --dump-path follows curves (0.001)', number: true},
	{option: 'stock-tolerance=MM', words: 'the tolerance of the remaining stock (0.1)', number: true},
	{option: 'step=SECONDS', words: 'time between samples of the sampled methods (0.01)', number: true},
	{option: 'include=DIR', words: 'look for subprograms in DIR after the folder of the program; may be given several times', text: true},
	{option: 'max-blocks=N', words: 'give up after N blocks in loops and subprograms (100000000)', number: true},
	{option: 'fail-on=KIND,...', words: 'findings of these kinds fail the run, others only warn: collision, clearance, limit, start-overlap, rapid-contact, gouge, warning or none; warning: warnings fail, too; none: nothing fails', text: true},
	{option: 'duplicates=error|last', words: 'a word that occurs twice in a block is an error (the default), or the last one counts', choices: [['', 'error'], ['last', 'last']]},
	{option: 'sensitivity=DX,DY,DZ,DL', words: 'report how far, up to these values, work offsets and tool lengths may be wrong before the verdict changes', text: true},
	{option: 'block-delete', words: 'skip blocks that begin with /'},
	{option: 'parse-only', words: 'interpret the programs and check axis limits, but not collisions'},
];

/** @param {Option} option */
function nameOf({option}) {
	return option.replace(/=.*/, '');
}

/** The fields of options that few users need. */
export function moreOptions() {
	return MORE.map((option) => {
		const name = nameOf(option), words = [element('code', {}, `--${option.option}`), element('span', {}, option.words)];
		if (option.choices)
			return element('label', {}, ...words, element('select', {name}, ...option.choices.map(([value, text]) => element('option', {value}, text))));
		if (option.number || option.text)
			return element('label', {}, ...words, element('input', {name, autocomplete: 'off', dataset: option.number ? {number: 'optional'} : {}}));
		return element('label', {className: 'tick'}, element('input', {name, type: 'checkbox'}), ...words);
	});
}

/** The options of a check that differ from their defaults. @param {FormData} data */
export function optionsIn(data) {
	const value = (/** @type {string} */ name) => String(data.get(name) ?? '').trim(), number = (/** @type {string} */ name) => readNumber(value(name)).number || value(name);
	const clearance = number('clearance'), method = value('method');
	const more = MORE.filter((option) => value(nameOf(option)) !== '').map((option) => {
		const name = nameOf(option);
		return option.choices || option.text ? `--${name}=${value(name)}` : option.number ? `--${name}=${number(name)}` : `--${name}`;
	});
	return [...(clearance === '' || Number(clearance) === 0 ? [] : [`--clearance=${clearance}`]), ...(method === 'certified' ? [] : [`--method=${method}`]),
		...(data.get('all') ? ['--all'] : []), ...more];
}

/** A word, quoted for a shell if necessary. @param {string} word */
function quoted(word) {
	return /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll('\'', '\'\\\'\'')}'`;
}

/**
 * The command line for a shell; `./` keeps operands that begin with a hyphen from being read as options.
 * @param {string[]} options @param {string[]} operands
 */
export function commandLine(options, operands) {
	return ['fivecheck', ...options, ...operands.map((path) => path.startsWith('-') ? `./${path}` : path)].map(quoted).join(' ');
}

/** A command line with a button that copies it. @param {string} label @param {string} text */
export function copyField(label, text) {
	const code = element('code', {className: 'command', tabIndex: 0, role: 'textbox', ariaLabel: label, ariaReadOnly: 'true'}, text), button = element('button', {type: 'button', ariaLabel: `Copy: ${label}`}, 'Copy');
	button.addEventListener('click', async () => {
		try {
			await navigator.clipboard.writeText(text);
			button.textContent = 'Copied';
		} catch {
			getSelection()?.selectAllChildren(code);
			button.textContent = 'Selected: copy it';
		}
	});
	return element('p', {className: 'row copied'}, element('span', {}, `${label}:`), code, button);
}
