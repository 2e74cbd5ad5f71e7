// @ts-check
/** service_worker.js - the page works offline after the first visit. What the network has is newer and is taken first. */
const CACHE = 'fivecheck';
const CORE = ['./', 'index.html', 'report.html', 'page.css', 'main.js', 'client.js', 'modules.js', 'worker.js', 'fivecheck.js', 'files.js', 'wasi.js', 'job_files.js',
	'machine_form.js', 'machine_arguments.js', 'machine_families.js', 'cautions.js', 'program_result.js', 'setup_form.js', 'setup_proposal.js', 'setup_xml.js', 'fields.js', 'page.js', 'learn.html', 'viewer/stage.css', 'learn.css', 'learn.js', 'axis_picture.js', 'editor.js', 'jog.js', 'jog_stage.js', 'session_client.js',
	'session_worker.js', 'tour.js', 'fivecheck.wasm', 'fivecheck-klartext.wasm', 'fivecheck-sinumerik.wasm', 'fivecheck-more.wasm', 'viewer.js', 'examples/index.json'];

addEventListener('install', (event) => {
	/** @type {any} */ (event).waitUntil(caches.open(CACHE).then((cache) => cache.addAll(CORE)));
});

/** @param {Request} request */
async function answer(request) {
	const cache = await caches.open(CACHE);
	try {
		const fresh = await fetch(request);
		if (fresh.ok)
			await cache.put(request, fresh.clone()).catch(() => undefined);  // there may be no room
		return fresh;
	} catch (error) {
		const kept = await cache.match(request);
		if (kept)
			return kept;
		throw error;
	}
}

addEventListener('fetch', (event) => {
	const {request} = /** @type {any} */ (event);
	if (request.method === 'GET')
		/** @type {any} */ (event).respondWith(answer(request));
});
