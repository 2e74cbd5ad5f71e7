// @ts-check
/** offline.js - makes the browser keep the page for use without a network. */

/**
 * ms: filling the cache takes the browser a second of processor time, which a user who opens an example at once needs.
 */
const QUIET = 2000;

/** Registers the service worker, but not while the page is at work. @param {() => boolean} busy */
export function keepOffline(busy) {
	// If nothing may be stored, as in some private windows, the page works nevertheless.
	/** @returns {unknown} */
	const look = () => busy() ? setTimeout(look, QUIET) : navigator.serviceWorker.register('service_worker.js').catch(() => undefined);
	if ('serviceWorker' in navigator)
		setTimeout(look, QUIET);
}
