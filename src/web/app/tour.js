// @ts-check
/** tour.js - the guided tour: which pairs are checked, what a separating axis is, what samples miss. */
import {axisPicture} from './axis_picture.js';
import {byId, element} from './page.js';

/** @typedef {import('./viewer/model.js').Model} Model */

/** A wall of half a millimetre; at 30 m/min samples are 5 mm apart. */
const WALL_PROGRAM = 'G21 G90\nG0 X300\nM2\n';
const WALL_MACHINE = `<machine version="1" name="A thin wall">
<controller dialect="linuxcnc" rapid="linear"/>
<base>
<body name="wall" mesh="wall.stl"/>
<axis name="X" type="linear" direction="1 0 0" limit_min="0" limit_max="400" rate_max="30000">
<body name="plate" mesh="plate.stl"/>
</axis>
</base>
<pairs><pair a="plate" b="wall" check="always"/></pairs>
</machine>
`;

/** An STL file of a box. @param {number[]} low @param {number[]} high */
export function boxStl(low, high) {
	const corner = (/** @type {number} */ i) => [0, 1, 2].map((k) => (i >> k & 1 ? high : low)[k]).join(' ');
	const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
	const triangles = faces.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);
	return `solid box\n${triangles.map((triangle) => `facet normal 0 0 0\nouter loop\n${triangle.map((i) => `vertex ${corner(i)}\n`).join('')}endloop\nendfacet\n`).join('')}endsolid box\n`;
}

/**
 * The pairs of links, as in the paper's table: an axis represents everything that it carries. A pair of links is
 * checked if any two of their own bodies are.
 * @param {Model} model
 * @returns {{a: string, b: string, links: number[], checked: boolean, why: string}[]}
 */
export function linkPairs(model) {
	/** @type {Map<string, {a: string, b: string, links: number[], checked: boolean, reasons: Set<string>}>} */
	const found = new Map();
	const own = model.pairs.filter(({a, b}) => [a, b].every((i) => model.bodies[i]?.role === 'machine'));
	for (const {a, b, status, reason} of own) {
		const links = [a, b].map((i) => model.bodies[i].link);
		if (links[0] === links[1] || !links[0] || !links[1])
			continue;
		const [one, other] = links.map((link) => model.axes[link - 1].letter), key = `${one}${other}`;
		const entry = found.get(key) ?? {a: one, b: other, links, checked: false, reasons: new Set()};
		const checked = status === 'checked';
		if (checked && !entry.checked)
			entry.reasons.clear();
		if (checked || !entry.checked)
			entry.reasons.add(checked ? `${model.bodies[a].name} and ${model.bodies[b].name}: ${reason}` : `${status}: ${reason}`);
		entry.checked ||= checked;
		found.set(key, entry);
	}
	return [...found.values()].map(({a, b, links, checked, reasons}) => ({a, b, links, checked, why: [...reasons].join('; ')}));
}

/** The button of a pair stays pressed while the pair is shown. @param {number[]} links */
function pressPair(links) {
	byId('pair-table').querySelectorAll('button').forEach((button) => button.ariaPressed = String(button.dataset.links === links.join()));
}

/** @param {string} pair @param {number[]} links @param {(links: number[]) => void} look */
function pairButton(pair, links, look) {
	const button = element('button', {type: 'button', dataset: {links: links.join()}, ariaPressed: 'false', ariaLabel: `Show ${pair} on the machine`}, 'Show');
	button.addEventListener('click', () => look(button.ariaPressed === 'true' ? [] : links));
	return button;
}

/** @param {Model} model @param {(links: number[]) => void} look the user wants to see two links, or none any more */
export function showPairs(model, look) {
	const rows = linkPairs(model), checked = rows.filter((row) => row.checked);
	byId('pair-table').replaceChildren(
		element('p', {className: 'verdict'}, `${checked.length} of ${rows.length} pairs of axes are checked: ${checked.map(({a, b}) => `${a}–${b}`).join(', ') || 'none'}.`),
		element('table', {}, element('thead', {}, element('tr', {}, ...['axes', 'checked', 'why', 'picture'].map((text) => element('th', {scope: 'col'}, text)))),
			element('tbody', {}, ...rows.map(({a, b, links, checked: is, why}) => element('tr', {className: is ? 'checked' : ''},
				element('th', {scope: 'row'}, `${a}–${b}`), element('td', {}, is ? 'yes' : 'no'), element('td', {}, why),
				element('td', {}, pairButton(`${a}–${b}`, links, look)))))));
}

/**
 * Checks the thin wall with samples and with the proof, side by side.
 * @param {import('./client.js').Client} client
 */
async function showWall(client) {
	/** @type {[string, string][]} */
	const files = [['machine.xml', WALL_MACHINE], ['wall.stl', boxStl([152.2, -100, 0], [152.7, 100, 200])],
		['plate.stl', boxStl([-0.5, -60, 40], [0.5, 60, 160])], ['wall.nc', WALL_PROGRAM]];
	const cards = await Promise.all(['conventional', 'certified'].map(async (method) => {
		const {status, text} = await client.check({files, machine: 'machine.xml', programs: ['wall.nc'], options: [`--method=${method}`]}, {});
		const sampled = method !== 'certified', verdict = status === 1 ? 'found' : status === 0 && !sampled ? 'clear' : 'incomplete';
		const words = ['Nothing was seen at the samples. The plate is through the wall.', 'The collision is found.'][status] ?? 'Incomplete.';
		return element('article', {className: 'program', dataset: {verdict, method}}, element('h3', {}, `--method=${method}`),
			element('p', {className: 'verdict'}, words),
			element('pre', {}, text.split('\n').slice(0, 6).join('\n')));
	}));
	byId('wall-results').replaceChildren(...cards);
	document.dispatchEvent(new Event('wall-checked'));
}

/** @param {import('./client.js').Client} client @param {() => void} showPlane between the nearest bodies of the machine */
export function startTour(client, showPlane) {
	byId('axis-picture').append(axisPicture());
	byId('wall-program').textContent = WALL_PROGRAM;
	byId('show-plane').addEventListener('click', showPlane);
	document.addEventListener('links-shown', (event) => pressPair(/** @type {CustomEvent} */ (event).detail));
	byId('check-wall').addEventListener('click', () => showWall(client));
}
