// @ts-check
/**
 * worker.js - runs one job of the checker in a worker (client.js). What ends the worker ends the job.
 */
import {Fivecheck} from './fivecheck.js';
import {Files} from './files.js';

/** @param {[string, string | Blob][]} given */
function filesOf(given) {
	const files = new Files();
	for (const [path, contents] of given)
		files.add(path, contents);
	return files;
}

addEventListener('message', async ({data}) => {
	try {
		const fivecheck = await Fivecheck.load(data.modules, data.viewer), files = filesOf(data.files);
		if (data.args) {
			postMessage({done: fivecheck.run(data.args, files)});
			return;
		}
		const result = fivecheck.check({
			...data.job, files,
			onEvent: (event) => postMessage({event}),
			onMessage: (message) => postMessage({message}),
			onProgress: (progress) => postMessage({progress}),
		});
		postMessage({done: result});
	} catch (error) {
		postMessage({failed: String(error)});
	}
});
