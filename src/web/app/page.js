// @ts-check
/** page.js - small helpers for elements. Foreign text is inserted only as text. */

/**
 * An element with properties and children.
 * @param {string} tag
 * @param {Record<string, any>} [properties]
 * @param {(Node | string)[]} children
 */
export function element(tag, properties = {}, ...children) {
	const {dataset, role, ...plain} = properties, made = Object.assign(document.createElement(tag), plain);
	Object.assign(made.dataset, dataset);
	if (role)
		made.setAttribute('role', role);
	made.append(...children);
	return made;
}

/** @param {string} id */
export function byId(id) {
	const found = document.getElementById(id);
	if (!found)
		throw new Error(`no element ${id}`);
	return found;
}

/**
 * Scrolls a changed element into view; at once for users who do not want motion.
 * @param {Element} what @param {ScrollLogicalPosition} [block] where it is to stand
 */
export function reveal(what, block = 'nearest') {
	what.scrollIntoView({block, behavior: matchMedia('(prefers-reduced-motion: reduce)').matches ? 'instant' : 'smooth'});
}
