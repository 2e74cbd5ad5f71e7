// @ts-check
/** machine_arguments.js - the entries of the form of a machine, as the arguments of `fivecheck init`. */
import {controlArguments} from './control_fields.js';
import {namesIn, readNumber, vectorIn} from './fields.js';

/** The usual order in which they carry each other. */
export const LINEAR = ['Y', 'X', 'Z'];

/** All orders of some axes, the current one first. @param {string[]} axes @returns {string[][]} */
export function orders(axes) {
	return axes.length < 2 ? [axes] : axes.flatMap((first, i) => orders([...axes.slice(0, i), ...axes.slice(i + 1)]).map((rest) => [first, ...rest]));
}

/** The chains of axes, from the output of `fivecheck init`. @param {string} messages */
export function chainsOf(messages) {
	const chains = messages.match(/note: (base.*workholding)/)?.[1] ?? '';
	return chains.split('; ').map((chain) => chain.replaceAll(' > ', ' \u2192 ')).join('; ');
}

/** @param {FormData} data */
export function initArguments(data) {
	const value = (/** @type {string} */ name) => String(data.get(name) ?? '').trim(), number = (/** @type {string} */ name) => readNumber(value(name)).number;
	const rotary = value('rotary').split(',');
	const args = [value('family'), `--rotary=${rotary.join(',')}`];
	/** @param {string} option @param {string} text */
	const add = (option, text) => text && args.push(`--${option}=${text}`);
	add('table', value('order.table'));
	const head = value('order.head'), usual = LINEAR.filter((axis) => head.includes(axis)).join();
	add('head', head === usual ? '' : head);
	for (const axis of ['X', 'Y', 'Z', ...rotary]) {
		const of = (/** @type {string} */ text) => text && `${axis}=${text}`;
		add('limits', of(data.get(`${axis}.endless`) ? 'none' : `${number(`${axis}.min`)}:${number(`${axis}.max`)}`));
		add('title', of(value(`${axis}.title`)));
		if (rotary.includes(axis))
			add('location', of(vectorIn(data, `${axis}.location`)));
		add('inclination', of(number(`${axis}.inclination`)));
		add('direction', of(vectorIn(data, `${axis}.direction`)));
		add('rates', of(number(`${axis}.rate`)));
		add('home', of(number(`${axis}.home`)));
		namesIn(value(`${axis}.body`)).forEach((mesh) => add('body', of(mesh)));
	}
	add('spindle', vectorIn(data, 'spindle'));
	add('spindle-direction', vectorIn(data, 'spindle-direction'));
	add('workholding', vectorIn(data, 'workholding'));
	namesIn(value('base.body')).forEach((mesh) => add('body', `base=${mesh}`));
	add('name', value('name'));
	add('units', value('units') === 'mm' ? '' : value('units'));
	add('dialect', value('dialect'));
	add('rapid', value('rapid'));
	return [...args, ...controlArguments(data, ['X', 'Y', 'Z', ...rotary])];
}
