// @ts-check
/** offline.js - has the browser keep the page for when there is no network. */

/** ms: filling the cache takes the browser a second of processor time, which whoever opens an example at once needs for that. */
const QUIET = 2000;

/** Registers the service worker, but not while the page is at work. @param {() => boolean} busy */
export function keepOffline(busy) {
	// Where nothing may be stored, as in some private windows, the page works all the same.
	/** @returns {unknown} */
	const look = () => busy() ? setTimeout(look, QUIET) : navigator.serviceWorker.register('service_worker.js').catch(() => undefined);
	if ('serviceWorker' in navigator)
		setTimeout(look, QUIET);
}
