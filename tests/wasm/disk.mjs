// disk.mjs - files of the disk as the checker in WebAssembly sees them, read in slices.
import fs from 'node:fs';
import path from 'node:path';

/** A file of the disk as a source of bytes (files.js). */
class DiskBytes {
	constructor(name) {
		this.fd = fs.openSync(name, 'r');
		this.size = fs.fstatSync(this.fd).size;
	}

	read(offset, into) {
		return fs.readSync(this.fd, into, 0, into.length, offset);
	}

	close() {
		fs.closeSync(this.fd);
	}
}

/** Adds a file or all of a folder at `to`. Returns what has to be closed. */
export function addFromDisk(files, from, to, opened = []) {
	if (fs.statSync(from).isDirectory()) {
		files.folder(to);
		for (const name of fs.readdirSync(from).sort())
			addFromDisk(files, path.join(from, name), `${to}/${name}`, opened);
	} else {
		const bytes = new DiskBytes(from);
		opened.push(bytes);
		files.add(to, bytes);
	}
	return opened;
}
