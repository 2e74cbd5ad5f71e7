// @ts-check
/**
 * service_worker.js - the page works offline after the first visit, and always consists of files of one build.
 *
 * Each build has a separate cache. The cache is filled before it is used, and each file is compared with its digest
 * below: while a server has old and new files, the old build stays. A page that is open keeps its build; the newer one
 * replaces it when the page is loaded again and no other page is open.
 */

/** The files of the page, each with its SHA-256, and a name for all of them; `make web` writes both (scripts/web-build). */
const FILES = /** @type {Record<string, string>} */ ({});
const BUILD = '';

const worker = /** @type {any} */ (self), scope = worker.registration.scope;
const OWN = `fivecheck ${scope} `, CACHE = OWN + BUILD;
/** The caches of versions before there were builds. */
const FORMER = 'fivecheck';

/** Puts a file of this build into the cache. @param {Cache} cache @param {string} name */
async function keep(cache, name) {
	const response = await fetch(name, {cache: 'no-cache'}), kept = response.clone();
	const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', await response.arrayBuffer()));
	if ([...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('') !== FILES[name])
		throw new Error(`${name} is not of the build ${BUILD}`);
	await cache.put(name, kept);
}

async function install() {
	const cache = await caches.open(CACHE);
	try {
		await Promise.all(Object.keys(FILES).map((name) => keep(cache, name)));
	} catch (error) {
		await caches.delete(CACHE);
		throw error;
	}
}

/** Caches of other builds are no longer needed. */
async function tidy() {
	const names = await caches.keys();
	await Promise.all(names.filter((name) => name === FORMER || (name.startsWith(OWN) && name !== CACHE)).map((name) => caches.delete(name)));
}

/**
 * Makes the newer build answer when a page is loaded again; undefined: there is none, or another page is open, or this
 * page is opened in addition.
 * @param {Request} request
 */
async function handOver({cache, destination}) {
	const newer = worker.registration.waiting, again = cache === 'no-cache' || cache === 'reload';
	if (destination !== 'document' || !again || !newer || (await worker.clients.matchAll()).length > 1)
		return undefined;
	newer.postMessage('take over');
	return new Response('<link rel="icon" href="data:,">', {headers: {'Content-Type': 'text/html', Refresh: '0'}});
}

/** @param {Request} request @param {string} name */
async function answer(request, name) {
	// A browser that no longer stores anything still loads the page.
	const cache = await caches.open(CACHE).catch(() => undefined), kept = await cache?.match(name);
	if (kept)
		return kept;
	const fresh = await fetch(request);
	// The files of an example are kept after it was opened.
	if (cache && fresh.ok)
		await cache.put(name, fresh.clone()).catch(() => undefined);  // there may be no room
	return fresh;
}

worker.addEventListener('install', (/** @type {any} */ event) => event.waitUntil(install()));
worker.addEventListener('activate', (/** @type {any} */ event) => event.waitUntil(tidy()));
worker.addEventListener('message', (/** @type {any} */ event) => event.waitUntil(worker.skipWaiting()));
worker.addEventListener('fetch', (/** @type {any} */ event) => {
	const {request} = event, {origin, pathname} = new URL(request.url);
	if (request.method !== 'GET' || !(origin + pathname).startsWith(scope))
		return;
	const name = (origin + pathname).slice(scope.length) || 'index.html';
	event.respondWith(handOver(request).then((loadAgain) => loadAgain ?? answer(request, name)));
});
