// @ts-check
/** machine_families.js - the families of machines that `fivecheck init` knows, and an example of each: its numbers in the form. */

export const ROTARY = ['A', 'B', 'C'];

/**
 * The texts of the form for each family; `first` is between its two axes; `oblique` is the place of the oblique axis,
 * which is never C.
 * @type {Record<string, {title: string, rotary: string[], first: string, oblique: number}>}
 */
export const FAMILIES = {
	'table-table': {title: 'both rotary axes turn the table', rotary: ['A,C', 'B,C', 'A,B', 'C,A', 'C,B', 'B,A'], first: ' carries ', oblique: -1},
	'head-head': {title: 'both rotary axes turn the head', rotary: ['C,B', 'C,A', 'A,B', 'B,A', 'A,C', 'B,C'], first: ' carries ', oblique: -1},
	'head-table': {title: 'one turns the head, one the table', rotary: ['B,C', 'A,C', 'B,A', 'A,B', 'C,A', 'C,B'], first: ' turns the head, the table ', oblique: -1},
	'nutating-table': {title: 'both turn the table, one is oblique (nutating table)', rotary: ['B,C', 'A,C', 'A,B', 'B,A'], first: ', oblique, carries ', oblique: 0},
	'nutating-head': {title: 'both turn the head, one is oblique (nutating head)', rotary: ['C,B', 'C,A', 'A,B', 'B,A'], first: ' carries the oblique ', oblique: 1},
};

/** @param {string} names @param {string} place x,y,z */
function vector(names, place) {
	return Object.fromEntries(place.split(',').map((value, i) => [`${names}.${'xyz'[i]}`, value]));
}

/** @param {string} axis @param {string} limits min:max, or '' @param {string} [place] of a rotary axis */
function axis(axis, limits, place) {
	const [min, max] = limits.split(':');
	return {...(limits ? {[`${axis}.min`]: min, [`${axis}.max`]: max} : {[`${axis}.endless`]: '+'}), ...(place ? vector(`${axis}.location`, place) : {})};
}

/** @param {string} x @param {string} y @param {string} z */
function linear(x, y, z) {
	return {...axis('X', x), ...axis('Y', y), ...axis('Z', z)};
}

/** By family; the first three are the examples of the page. @type {Record<string, Record<string, string>>} */
export const EXAMPLES = {
	'table-table': {rotary: 'A,C', ...linear('-300:300', '-250:250', '-400:0'), ...axis('A', '-120:30', '0,0,120'), ...axis('C', '', '0,0,120'), ...vector('spindle', '0,0,520'), ...vector('workholding', '0,0,80')},
	'head-head': {rotary: 'C,B', ...linear('-500:500', '-750:750', '-700:0'), ...axis('C', '-360:360', '0,0,1050'), ...axis('B', '-110:110', '0,0,1050'), ...vector('spindle', '0,0,800'), ...vector('workholding', '0,0,0')},
	'head-table': {rotary: 'B,C', ...linear('-500:500', '-220:220', '-560:0'), 'Y.table': '+', ...axis('B', '-30:120', '0,0,720'), ...axis('C', '', '0,0,0'), ...vector('spindle', '0,0,500'), ...vector('workholding', '0,0,0')},
	'nutating-table': {rotary: 'B,C', ...linear('-250:250', '-210:210', '-400:0'), ...axis('B', '0:180', '0,0,50'), 'B.inclination': '45', ...axis('C', '', '0,0,0'), ...vector('spindle', '0,0,520'), ...vector('workholding', '0,0,0')},
	'nutating-head': {rotary: 'C,B', ...linear('-500:500', '-750:750', '-700:0'), ...axis('C', '-360:360', '0,0,1050'), ...axis('B', '-180:180', '0,0,1050'), 'B.inclination': '45', ...vector('spindle', '0,0,800'), ...vector('workholding', '0,0,0')},
};
