// @ts-check
/**
 * control_fields.js - more settings of the control in the form of a machine: the attributes of <controller> (man 5
 * fivecheck-machine).
 */
import {moreFields, numberField, readNumber} from './fields.js';
import {element} from './page.js';

const ISO = ['fanuc', 'haas'], START = [...ISO, 'sinumerik'], ALL = ['linuxcnc', ...START, 'klartext'];

/**
 * An attribute: the controls that can be told it, its words, and its choices; without these it is a number.
 * @typedef {{name: string, of: string[], words: string, choices?: string[]}} Attribute
 */
/** @param {string} name @param {string[]} of @param {string} words @param {string[]} [choices] @returns {Attribute} */
function row(name, of, words, choices) {
	return {name, of, words, choices};
}

/** @type {Attribute[]} */
export const ATTRIBUTES = [
	row('path_tolerance', ALL, 'how far the control may leave the path where it rounds corners, mm'),
	row('tcp_zero', ALL, 'where the rotary axes stand when points under tool centre point control are on the table', ['machine', 'offset']),
	row('preset', ['fanuc'], 'generation of the control: its manual answers what is left out here', ['16i', '0i-MB', '0i-D', '0i-F', '30i-B']),
	row('preset', ['haas'], 'generation of the control: its manual answers what is left out here', ['classic', 'ngc']),
	row('least_input', ISO, 'what a 1 without a decimal point means; 0.001 on most controls'),
	row('length_offset_moves', ISO, 'does a change of the length offset (G43, G49) move the axes at once?', ['yes', 'no']),
	row('length_after_reference', ISO, 'what is left of the length offset after G28, G30 and G53', ['keeps', 'cancels']),
	row('power_on_units', START, 'unit before any G20 or G21', ['mm', 'inch']),
	row('power_on_distance', START, 'coordinates before any G90 or G91', ['absolute', 'incremental']),
	row('power_on_plane', START, 'plane before any G17, G18 or G19', ['xy', 'zx', 'yz']),
	row('power_on_motion', ISO, 'motion before any G0 or G1', ['rapid', 'feed']),
	row('power_on_work_offset', ['sinumerik'], 'work offset before any G500 or G54', ['G500', 'G54', 'G55', 'G56', 'G57']),
	row('cutter_comp_start', START, 'how cutter compensation starts and ends', ['A', 'B']),
	row('cutter_comp_corner', START, 'how cutter compensation leads round outside corners', ['linear', 'circular']),
	row('cutter_comp_idle_blocks', ['fanuc', 'sinumerik'], 'blocks without a move that tool radius compensation looks past', ['1', '2', '3', '4', '5', '6', '7', '8', '9']),
	row('cutter_comp_d', ISO, 'what G10 L12 and L13 write into D', ['radius', 'diameter']),
	row('g53_with_g91', ISO, 'what G53 means while G91 is in force', ['absolute', 'incremental']),
	row('m6_with_move', ISO, 'is the tool changed after or before the move of the block of M6?', ['after', 'before']),
	row('m6_with_t', ['fanuc'], 'which tool M6 loads beside a T, while another T waits', ['own', 'before', 'first']),
	row('arc_radius_tolerance', ['fanuc'], 'difference of radii up to which an arc is a spiral, mm'),
	row('unidirectional_overrun', ISO, 'how far G60 goes past its end, mm'),
	row('cycle_axis', ['fanuc'], 'which axis canned cycles drill along in G18 and G19', ['plane', 'z']),
	row('cycle_repeats', ['fanuc'], 'word that repeats a canned cycle', ['K', 'L']),
	row('length_under_g68', ['fanuc'], 'which way the length acts under G68 with I, J and K', ['turned', 'straight']),
	row('polar_axes', ['fanuc'], 'axes of polar coordinate interpolation (G12.1)', ['XA', 'XB', 'XC']),
	row('semicolon', ISO, 'what ; does', ['comment', 'block-end']),
	row('colon', ISO, 'what : with a number is at the start of a line', ['program', 'block']),
	row('orientation_interpolation', ['fanuc'], 'how the tool turns under G43.5', ['axes', 'vector']),
	row('orientation_interpolation', ['sinumerik'], 'how the tool turns under TRAORI', ['axes', 'vector', 'oriwks']),
	row('orientation_pole', ['sinumerik'], 'what ORIVECT does at a pole of the rotary axes', ['axes']),
	row('rotation_order', ['sinumerik'], 'order of the angles of one ROT', ['rpy', 'euler']),
	row('edge_after_tool_change', ['sinumerik'], 'edge (D) that holds after M6', ['first', 'none', 'keeps']),
	row('t_changes_tool', ['sinumerik'], 'does T change the tool by itself, without M6?', ['yes', 'no']),
	row('mirror_toggle', ['sinumerik'], 'does MIRROR ignore the values of its axes (MD10612)?', ['yes', 'no']),
	row('frames_outlive_traori', ['sinumerik'], 'are frames in force after TRAORI and TRAFOOF?', ['yes', 'no']),
	row('frames_outlive_cycle800', ['sinumerik'], 'are frames in force after CYCLE800 takes the plane back?', ['yes', 'no']),
	row('increments_after_shift', ['sinumerik'], 'what an increment does after a change of frames or lengths', ['traverse', 'stay']),
	row('increments_after_shift', ['klartext'], 'what an increment does after a change of datum or lengths', ['stay']),
	row('tool_length_axis', ['fanuc', 'sinumerik'], 'the length always acts along Z', ['z']),
	row('swivel_axis', ['sinumerik'], 'rotary axis whose value DIR of CYCLE800 looks at', ['A', 'B', 'C']),
	row('swivel_pole', ['sinumerik', 'klartext'], 'what CYCLE800 or PLANE does with an axis that the tool points along', ['zero', 'stays']),
	row('cycle_19_angles', ['klartext'], 'what the angles of CYCL DEF 19 are', ['spatial', 'axes']),
	row('cycle_11_axes', ['klartext'], 'axes that CYCL DEF 11 scales', ['plane', 'all']),
	row('rotary_way', ['sinumerik'], 'way of a modulo axis to an absolute position without DC', ['plain', 'shorter']),
	row('rotary_way', ['klartext'], 'way of a rotary axis with a reduced display without M126', ['plain', 'shorter']),
	row('rotary_angle', ['klartext'], 'what an angle outside of 0 to 360 of such an axis means without M126', ['as-written', 'reduced']),
	row('m6', ['klartext'], 'M6 does nothing, because TOOL CALL changes the tool', ['ignored']),
	row('plane_rotation', ['klartext'], 'what PLANE without COORD ROT and TABLE ROT turns at a free axis', ['coordinates', 'table']),
	row('plane_retract', ['klartext'], 'when MB of PLANE retracts the tool', ['always', 'turning']),
	row('shift_behind_plane', ['klartext'], 'a datum shift, behind a plane in which CYCL DEF 7 named its axis', ['keeps', 'cancelled']),
	row('tool_def', ['klartext'], 'L and R of TOOL DEF, where the tool table is active', ['ignored']),
];

/** @param {string} dialect */
function attributesOf(dialect) {
	return ATTRIBUTES.filter(({of}) => of.includes(dialect));
}

/**
 * The fields for a control; earlier entries stay where they still fit.
 * @param {HTMLElement} place @param {string} dialect
 */
export function offerControl(place, dialect) {
	const before = new Map([.../** @type {NodeListOf<HTMLInputElement>} */ (place.querySelectorAll('input, select'))].map(({name, value}) => [name, value]));
	const fields = attributesOf(dialect).map(({name, words, choices}) => {
		const key = `controller.${name}`, old = before.get(key) ?? '', label = `${name}: ${words}`;
		if (!choices)
			return numberField(key, label, old);
		const select = /** @type {HTMLSelectElement} */ (element('select', {name: key}, element('option', {value: ''}, 'not told'), ...choices.map((choice) => element('option', {}, choice))));
		select.value = choices.includes(old) ? old : '';
		return element('label', {}, label, select);
	});
	const open = place.querySelector('details')?.open ?? false;
	place.replaceChildren(Object.assign(moreFields('What else the control does; a check says if a program needs to know', ...fields), {open}));
}

/** The attribute in a message of `fivecheck init`. @param {string} message */
export function attributeIn(message) {
	return message.match(/--controller: (?:unknown attribute ')?(\w+)/)?.[1] ?? '';
}

/** The arguments of `fivecheck init` for these fields. @param {FormData} data @param {string[]} axes of the machine */
export function controlArguments(data, axes) {
	const value = (/** @type {string} */ name) => String(data.get(name) ?? '').trim();
	const told = attributesOf(value('dialect')).flatMap(({name, choices}) => {
		const entered = value(`controller.${name}`), text = choices ? entered : readNumber(entered).number;
		return text ? [`--controller=${name}=${text}`] : [];
	});
	const places = axes.flatMap((axis) => {
		const {number} = readNumber(value(`change.${axis}`));
		return number ? [`${axis}=${number}`] : [];
	});
	return [...(data.get('change.none') ? ['--tool-change=none'] : places.length ? [`--tool-change=${places.join()}`] : []), ...told];
}
