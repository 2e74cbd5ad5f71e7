// @ts-check
/**
 * job_files.js - what the files that a user dropped are: the machine, its meshes, the setup, the programs.
 */

/** Enough of a file to see what it is. */
const HEAD = 65536;

/**
 * @typedef {'machine' | 'setup' | 'mesh' | 'program' | 'waivers' | 'library' | 'other'} Role
 * @typedef {{path: string, blob: Blob, role: Role, text: string}} JobFile
 */

/** The beginning of a text: UTF-16 if its first bytes say so, else UTF-8. @param {Blob} blob */
async function headOf(blob) {
	const bytes = new Uint8Array(await blob.slice(0, HEAD).arrayBuffer()), mark = 256 * bytes[0] + bytes[1];
	return new TextDecoder(mark === 0xfffe ? 'utf-16le' : mark === 0xfeff ? 'utf-16be' : 'utf-8').decode(bytes);
}

/** Files that are surely no programs. */
const FOREIGN = /\.(jpe?g|png|gif|svg|pdf|zip|gz|html?|md|docx?|xlsx?|odt|ods)$/i;

/** A drawing of a CAD system, which is no mesh. @param {string} path */
export function isDrawing(path) {
	return /\.(step|stp|iges|igs|sldprt|sldasm|ipt|iam|prt|catpart|x_t|dxf|dwg|f3d|3mf|glb|gltf)$/i.test(path);
}

/** @param {string} path @param {string} text @returns {Role} */
function roleOf(path, text) {
	if (/\.(stl|obj|ply)$/i.test(path))
		return 'mesh';
	const root = /** @type {Role | undefined} */ (text.match(/<(machine|setup|waivers)[\s>]/)?.[1]);
	return root ?? (/\.xml$/i.test(path) || isDrawing(path) || FOREIGN.test(path) ? 'other' : 'program');
}

/**
 * @param {string} path
 * @param {Blob} blob
 * @returns {Promise<JobFile>}
 */
export async function jobFile(path, blob) {
	const text = await headOf(blob);
	return {path, blob, role: roleOf(path, text), text};
}

/** A file of an example of the page. @param {string} path */
export async function exampleFile(path) {
	const response = await fetch(`examples/${path}`);
	if (!response.ok)
		throw new Error(`${path} cannot be loaded: the server answers ${response.status}`);
	return jobFile(path, await response.blob());
}

/** Do two files hold the same bytes? @param {Blob} a @param {Blob} b */
export async function sameBytes(a, b) {
	if (a.size !== b.size)
		return false;
	const [left, right] = (await Promise.all([a.arrayBuffer(), b.arrayBuffer()])).map((buffer) => new Uint8Array(buffer));
	return left.every((byte, i) => byte === right[i]);
}

/** Files that a setup names as tool libraries are no programs. @param {JobFile[]} files */
export function withLibraries(files) {
	const setups = files.filter(({role}) => role === 'setup');
	const named = new Set(setups.flatMap(({text}) => [...text.matchAll(/<tools\s[^>]*?\bhref=(["'])([^"']+)\1/g)].map(([, , path]) => nameOf(path))));
	return files.map((file) => (file.role === 'program' || file.role === 'other') && named.has(nameOf(file.path)) ? {...file, role: /** @type {Role} */ ('library')} : file);
}

/** What a person has to look at first stands first. @type {Role[]} */
const ORDER = ['machine', 'setup', 'program', 'waivers', 'library', 'other', 'mesh'];

/** @param {JobFile[]} files */
export function inOrder(files) {
	return [...files].sort((a, b) => ORDER.indexOf(a.role) - ORDER.indexOf(b.role));
}

/** @param {string} path */
export function nameOf(path) {
	return path.slice(path.lastIndexOf('/') + 1);
}

/** @param {string} path */
function folderOf(path) {
	return path.slice(0, path.lastIndexOf('/') + 1);
}

/** The files that a machine or setup names: their paths as it writes them. @param {JobFile} file */
function namedIn({role, text}) {
	if (role !== 'machine' && role !== 'setup')
		return [];
	return [...text.replace(/<!--[^]*?-->/g, '').matchAll(/\s(?:mesh|href)=(["'])([^"']+)\1/g)].map(([, , path]) => path);
}

/** Folders from somewhere up to a file: do they end alike? @param {string} a @param {string} b */
function foldersAgree(a, b) {
	const [one, other] = [a, b].map((path) => `/${folderOf(path).replace(/^(\.{0,2}\/)+/, '')}`.replace(/^\/$/, ''));
	return one.endsWith(other) || other.endsWith(one);
}

/** The only file that may be the one that is named. @param {JobFile[]} files @param {string} named */
function standIn(files, named) {
	const found = files.filter(({path}) => nameOf(path) === nameOf(named) && foldersAgree(path, named));
	return found.length === 1 ? found[0] : undefined;
}

/**
 * The files of a job. A mesh or tool library that an XML file names in a folder is also found where it was dropped without its
 * folder, or with more folders around it.
 * @param {JobFile[]} files
 * @returns {[string, Blob][]}
 */
export function withMeshes(files) {
	/** @type {Map<string, Blob>} */
	const all = new Map(files.map(({path, blob}) => [path, blob]));
	for (const file of files) {
		for (const named of namedIn(file)) {
			const path = folderOf(file.path) + named, found = all.has(path) ? undefined : standIn(files, named);
			if (found)
				all.set(path, found.blob);
		}
	}
	return [...all];
}

/** The names of files that machine and setup name and that are not here. @param {JobFile[]} files */
export function missingFiles(files) {
	const all = new Set(withMeshes(files).map(([path]) => path));
	return [...new Set(files.flatMap((file) => namedIn(file).filter((named) => !all.has(folderOf(file.path) + named))))];
}
