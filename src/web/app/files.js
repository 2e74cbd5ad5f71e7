// @ts-check
/**
 * files.js - the files of a run of the checker: a tree of folders in memory, without links. The bytes of a file are in
 * memory, or are read in slices from their source, so that a program of any length fits.
 */

/**
 * The source of the bytes of a file.
 * @typedef {{ readonly size: number, read(offset: number, into: Uint8Array): number }} Source
 */

/** Bytes in memory, which grow as they are written. */
export class MemoryBytes {
	/** @param {Uint8Array} [bytes] */
	constructor(bytes = new Uint8Array(0)) {
		this.bytes = bytes;
		this.size = bytes.length;
	}

	/**
	 * @param {number} offset
	 * @param {Uint8Array} into
	 */
	read(offset, into) {
		const count = Math.max(0, Math.min(into.length, this.size - offset));
		into.set(this.bytes.subarray(offset, offset + count));
		return count;
	}

	/**
	 * @param {number} offset
	 * @param {Uint8Array} from
	 */
	write(offset, from) {
		const end = offset + from.length;
		if (end > this.bytes.length) {
			const larger = new Uint8Array(Math.max(end, 2 * this.bytes.length, 4096));
			larger.set(this.bytes.subarray(0, this.size));
			this.bytes = larger;
		}
		this.bytes.set(from, offset);
		this.size = Math.max(this.size, end);
	}

	/** @param {number} size */
	resize(size) {
		if (size > this.size)
			this.write(this.size, new Uint8Array(size - this.size));
		this.bytes.fill(0, size, this.size);
		this.size = size;
	}

	/** A copy of the bytes that were written. */
	contents() {
		return this.bytes.slice(0, this.size);
	}
}

/** A File or Blob of the browser, read in slices; only in a worker, where reading may block. */
export class BlobBytes {
	/** @param {Blob} blob */
	constructor(blob) {
		this.blob = blob;
		this.size = blob.size;
		this.start = 0;
		this.slice = new Uint8Array(0);
	}

	/**
	 * @param {number} offset
	 * @param {Uint8Array} into
	 */
	read(offset, into) {
		if (offset < this.start || offset >= this.start + this.slice.length) {
			if (offset >= this.size)
				return 0;
			const part = this.blob.slice(offset, offset + BlobBytes.SLICE);
			this.slice = new Uint8Array(new FileReaderSync().readAsArrayBuffer(part));
			this.start = offset;
		}
		const from = offset - this.start, count = Math.min(into.length, this.slice.length - from);
		into.set(this.slice.subarray(from, from + count));
		return count;
	}
}
BlobBytes.SLICE = 1 << 20;

/** @typedef {Map<string, Folder | FileNode>} Entries */

export class FileNode {
	/**
	 * @param {Source} source
	 * @param {number} number
	 */
	constructor(source, number) {
		this.source = source;
		this.number = number;
	}
}

export class Folder {
	/** @param {number} number */
	constructor(number) {
		/** @type {Entries} */
		this.entries = new Map();
		this.number = number;
	}
}

/** The tree. Paths are absolute or relative to the root, with `/` between their parts. */
export class Files {
	constructor() {
		this.count = 1;
		this.root = new Folder(this.count++);
		this.folder('tmp');
	}

	/**
	 * The parts of a path, without `.` and `..`; the root is its own parent, as in POSIX.
	 * @param {string} path
	 */
	static parts(path) {
		/** @type {string[]} */
		const parts = [];
		for (const part of path.split('/')) {
			if (part === '..')
				parts.pop();
			else if (part !== '' && part !== '.')
				parts.push(part);
		}
		return parts;
	}

	/**
	 * The file or folder with this path, or undefined.
	 * @param {string} path
	 * @param {Folder} [from]
	 * @returns {Folder | FileNode | undefined}
	 */
	find(path, from = this.root) {
		/** @type {Folder | FileNode | undefined} */
		let at = from;
		for (const part of Files.parts(path)) {
			if (!(at instanceof Folder))
				return undefined;
			at = at.entries.get(part);
		}
		return at;
	}

	/**
	 * The folder with this path; it is made if it is missing, with the folders above it.
	 * @param {string} path
	 */
	folder(path) {
		let at = this.root;
		for (const part of Files.parts(path)) {
			let next = at.entries.get(part);
			if (!(next instanceof Folder))
				at.entries.set(part, next = new Folder(this.count++));
			at = next;
		}
		return at;
	}

	/**
	 * Adds a file with this path, and makes its folders.
	 * @param {string} path
	 * @param {string | Uint8Array | ArrayBuffer | Blob | Source} contents
	 */
	add(path, contents) {
		const parts = Files.parts(path), name = parts.pop();
		if (name === undefined)
			throw new Error(`no path of a file: ${path}`);
		const node = new FileNode(sourceOf(contents), this.count++);
		this.folder(parts.join('/')).entries.set(name, node);
		return node;
	}

	/**
	 * The bytes of a file that was written, or undefined.
	 * @param {string} path
	 */
	contents(path) {
		const node = this.find(path);
		return node instanceof FileNode && node.source instanceof MemoryBytes ? node.source.contents() : undefined;
	}
}

/**
 * @param {string | Uint8Array | ArrayBuffer | Blob | Source} contents
 * @returns {Source}
 */
function sourceOf(contents) {
	if (typeof contents === 'string')
		return new MemoryBytes(new TextEncoder().encode(contents));
	if (contents instanceof Uint8Array)
		return new MemoryBytes(contents);
	if (contents instanceof ArrayBuffer)
		return new MemoryBytes(new Uint8Array(contents));
	return contents instanceof Blob ? new BlobBytes(contents) : contents;
}
