// @ts-check
/**
 * job_files.js - what the files that a user dropped are: the machine, its meshes, the setup, the programs.
 */

/** Enough of a file to see what it is. */
const HEAD = 65536;

/**
 * @typedef {'machine' | 'setup' | 'mesh' | 'program' | 'waivers'} Role
 * @typedef {{path: string, blob: Blob, role: Role, text: string}} JobFile
 */

/**
 * @param {string} path
 * @param {Blob} blob
 * @returns {Promise<JobFile>}
 */
export async function jobFile(path, blob) {
	const text = /\.(stl|obj|ply)$/i.test(path) ? '' : await blob.slice(0, HEAD).text();
	/** @type {Role} */
	let role = 'program';
	if (!text)
		role = 'mesh';
	else if (/<machine[\s>]/.test(text))
		role = 'machine';
	else if (/<setup[\s>]/.test(text))
		role = 'setup';
	else if (/<waivers[\s>]/.test(text))
		role = 'waivers';
	return {path, blob, role, text};
}

/** @param {string} path */
export function nameOf(path) {
	return path.slice(path.lastIndexOf('/') + 1);
}

/** @param {string} path */
function folderOf(path) {
	return path.slice(0, path.lastIndexOf('/') + 1);
}

/**
 * The files of a job. A mesh that an XML file names in a folder is also found where it was dropped without its folder.
 * @param {JobFile[]} files
 * @returns {[string, Blob][]}
 */
export function withMeshes(files) {
	/** @type {Map<string, Blob>} */
	const all = new Map(files.map(({path, blob}) => [path, blob]));
	for (const file of files) {
		if (file.role !== 'machine' && file.role !== 'setup')
			continue;
		for (const [, , mesh] of file.text.matchAll(/\smesh=(["'])([^"']+)\1/g)) {
			const path = folderOf(file.path) + mesh, found = files.find((other) => nameOf(other.path) === nameOf(mesh));
			if (!all.has(path) && found)
				all.set(path, found.blob);
		}
	}
	return [...all];
}
