// @ts-check
// elements.js - makes elements of the page. Text goes in by textContent alone: names and comments are strangers' text.

/**
 * @param {string} tag with its classes: 'div.card.first'
 * @param {Object<string, any>} [attributes] on…: a listener; others are set unless they are null or false
 * @param {...(Node|string|null|undefined|false)} children
 * @returns {HTMLElement}
 */
export function h(tag, attributes = {}, ...children) {
	const [name, ...classes] = tag.split('.');
	const element = document.createElement(name);
	if (classes.length) element.className = classes.join(' ');
	for (const [key, value] of Object.entries(attributes)) {
		if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
		else if (value !== null && value !== undefined && value !== false) element.setAttribute(key, value === true ? '' : String(value));
	}
	for (const child of children) if (child || child === '') element.append(child);
	return element;
}

/** An element of a drawing. @param {string} tag @param {Object<string, string|number>} [attributes] @param {...Node} children */
export function svg(tag, attributes = {}, ...children) {
	const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
	for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
	element.append(...children);
	return element;
}

/** Two or more rows of cells, with a heading. @param {string[]} heads @param {(string|Node)[][]} rows */
export const table = (heads, rows) => h('table', {},
	h('thead', {}, h('tr', {}, ...heads.map((text) => h('th', {scope: 'col'}, text)))),
	h('tbody', {}, ...rows.map((cells) => h('tr', {}, ...cells.map((cell) => h('td', {}, cell))))));

/** @param {number} value @param {number} digits without negative zero */
export const fixed = (value, digits) => value.toFixed(digits).replace(/^-(0\.?0*)$/, '$1');

/** Seconds for people: 53.339 s, 3 min 19.3 s. @param {number} seconds */
export function duration(seconds) {
	const round = Math.round(seconds * 1000) / 1000;
	if (round < 60) return `${fixed(round, 3)} s`;
	const minutes = Math.floor(round / 60);
	if (minutes < 60) return `${minutes} min ${fixed(round - 60 * minutes, 1)} s`;
	return `${Math.floor(minutes / 60)} h ${minutes % 60} min ${Math.floor(round - 60 * minutes)} s`;
}

/** 1,234,567. @param {number} n */
export const grouped = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ',');
