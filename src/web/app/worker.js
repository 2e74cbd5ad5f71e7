// @ts-check
/**
 * worker.js - runs jobs of the checker in a worker, one after the other (client.js). Ending the worker ends the job.
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

/** The files of the last job: a job with the same files does not send them again. @type {[string, string | Blob][]} */
let given = [];

addEventListener('message', async ({data}) => {
	try {
		given = data.files ?? given;
		const fivecheck = await Fivecheck.load(data.modules, data.viewer), files = filesOf(given);
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
