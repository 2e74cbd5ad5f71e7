// check_face.mjs FOLDER - the JavaScript face of the checker (src/web/app/fivecheck.js): jobs, events, progress, files, faults.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {FIRST, Fivecheck, PARTS, PartLacking, STATUS} from '../../src/web/app/fivecheck.js';
import {BlobBytes, Files, MemoryBytes, READING} from '../../src/web/app/files.js';
import {missingFiles, withMeshes} from '../../src/web/app/job_files.js';
import {Modules, partsOf} from '../../src/web/app/modules.js';
import {setupXml} from '../../src/web/app/setup_xml.js';
import {addFromDisk} from './disk.mjs';

const folder = process.argv[2], viewer = fs.readFileSync(`${folder}/viewer.js`, 'utf8');
const fivecheck = await Fivecheck.load([FIRST, ...PARTS].map((name) => fs.readFileSync(`${folder}/${name}`)), viewer);
/** Only some of the modules. */
const modules = Object.fromEntries([FIRST, ...PARTS].map((name, i) => [name, fivecheck.modules[i]]));
const tests = {};

function exampleJob(program, more = {}) {
	const files = new Files();
	for (const folder of ['machines/ac-trunnion', 'examples/ac-trunnion'])
		addFromDisk(files, folder, folder);
	return {files, machine: 'machines/ac-trunnion/machine.xml', setup: 'examples/ac-trunnion/setup.xml',
		programs: [`examples/ac-trunnion/${program}.nc`], ...more};
}

tests['a collision is an event, a text and a report'] = () => {
	const told = [], parts = [];
	const job = exampleJob('collision', {report: true, onEvent: (event) => told.push(event), onProgress: (part) => parts.push(part)});
	const result = fivecheck.check(job);
	assert.equal(result.status, STATUS.FOUND);
	assert.deepEqual(told, result.events);
	const finding = told.find((event) => event.kind === 'collision');
	assert.equal(finding.line, 70);
	assert.equal(told.at(-1).kind, 'summary');
	assert.match(result.text, /collision: arbor \(C\) meets T3 holder \(Z\)/);
	const report = new TextDecoder().decode(result.reports.get(job.programs[0]));
	assert.match(report, /^<!doctype html>/i);
	assert.ok(parts.length > 0 && parts.every((part, i) => part > 0 && part <= 1 && (i === 0 || part > parts[i - 1])));
};

tests['the program for node in the README runs as it stands there'] = () => {
	const program = fs.readFileSync('src/web/app/README.md', 'utf8').match(/```js\n(\/\/ check\.mjs[^]*?)```/)[1];
	const beside = fs.mkdtempSync(path.join(os.tmpdir(), 'fivecheck-readme-')), job = path.join(beside, 'job');
	try {
		for (const name of fs.readdirSync(folder).filter((name) => /\.(js|wasm)$/.test(name)))
			fs.copyFileSync(`${folder}/${name}`, path.join(beside, name));
		for (const from of ['machines/ac-trunnion', 'examples/ac-trunnion'])
			fs.cpSync(from, job, {recursive: true});
		fs.writeFileSync(path.join(beside, 'package.json'), '{"type": "module"}');
		fs.writeFileSync(path.join(beside, 'check.mjs'), program);
		const {status, stdout, stderr} = spawnSync(process.execPath, [path.join(beside, 'check.mjs'), job, 'machine.xml', 'setup.xml', 'collision.nc'], {encoding: 'utf8'});
		assert.deepEqual([status, stdout], [STATUS.FOUND, 'line 70: collision: arbor and T3 holder\n'], stderr);
	} finally {
		fs.rmSync(beside, {recursive: true});
	}
};

tests['a report needs the script of the viewer'] = () => {
	assert.throws(() => new Fivecheck(fivecheck.modules).check(exampleJob('collision', {report: true})), PartLacking);
};

tests['a clear program has status 0, and the same job can be run again'] = () => {
	const job = exampleJob('clear');
	assert.equal(fivecheck.check(job).status, STATUS.CLEAR);
	assert.equal(fivecheck.check(job).status, STATUS.CLEAR);
};

tests['options count'] = () => {
	const result = fivecheck.check(exampleJob('clear', {options: ['--clearance=60']}));
	assert.equal(result.status, STATUS.FOUND);
	assert.ok(result.events.some((event) => event.kind === 'clearance'));
};

tests['a fault of the input is a message with its place'] = () => {
	const told = [], job = exampleJob('clear', {onMessage: (line) => told.push(line)});
	job.files.add(job.programs[0], 'G0 X1\nG1 X\n');
	const result = fivecheck.check(job);
	assert.equal(result.status, STATUS.INCOMPLETE);
	assert.match(told.join('\n'), /clear\.nc:2:/);
};

tests['a missing mesh is named'] = () => {
	const job = exampleJob('clear');
	job.files.folder('machines/ac-trunnion').entries.clear();
	job.files.add(job.machine, fs.readFileSync('machines/ac-trunnion/machine.xml'));
	const result = fivecheck.check(job);
	assert.equal(result.status, STATUS.INCOMPLETE);
	assert.match(result.messages, /\.stl/);
};

tests['init writes a machine file that loads'] = () => {
	const made = fivecheck.init(['table-table', '--rotary=A,C', '--limits=X=-300:300,Y=-250:250,Z=-400:0', '--limits=A=-120:30,C=none',
		'--location=A=0,0,120', '--location=C=0,0,120', '--spindle=0,0,520']);
	assert.equal(made.status, 0);
	assert.match(made.xml, /<axis name="A"/);
	const wrong = fivecheck.init(['table-table', '--rotary=A,C']);
	assert.equal(wrong.status, 2);
	assert.notEqual(wrong.messages, '');
};

tests['bytes of all kinds, folders, and paths that lead nowhere'] = () => {
	const files = new Files();
	files.add('a/b/c.txt', 'abc');
	files.add('/a/d', new Uint8Array([1, 2]));
	assert.deepEqual([...files.contents('a/../a/d')], [1, 2]);
	assert.equal(files.find('a/x'), undefined);
	assert.equal(files.find('../x'), undefined);
	assert.equal(files.find('../a/d'), files.find('a/d'));
	assert.throws(() => files.add('..', 'x'));
	const bytes = new MemoryBytes();
	bytes.write(3, new Uint8Array([7]));
	bytes.resize(2);
	bytes.resize(4);
	assert.deepEqual([...bytes.contents()], [0, 0, 0, 0]);
};

tests['bytes in memory are those of one array'] = () => {
	let state = 1, array = [1, 2, 3];
	const bytes = new MemoryBytes(Uint8Array.from(array)), next = (below) => (state = (state * 1103515245 + 12345) % 2 ** 31) % below;
	for (let i = 0; i < 400; i++) {
		const offset = next(array.length + 50), piece = Array.from({length: next(9000)}, () => next(256));
		if (i % 3 === 0) {
			array.length = Math.min(array.length, offset);
			bytes.resize(offset);
			while (array.length < offset)
				array.push(0);
		} else if (piece.length) {
			while (array.length < offset)
				array.push(0);
			piece.forEach((byte, j) => array[offset + j] = byte);
			bytes.write(offset, Uint8Array.from(piece));
		}
		const into = new Uint8Array(5000), from = next(array.length + 10), count = bytes.read(from, into);
		assert.deepEqual([...into.subarray(0, count)], array.slice(from, from + 5000));
	}
	assert.deepEqual([...bytes.contents()], array);
};

tests['progress is that of the check, not of the digests before it'] = () => {
	const told = [], line = 'G1 X1 F1000\nG1 X0\n';
	const job = exampleJob('clear', {options: ['--parse-only'], onEvent: ({kind}) => told.push(kind), onProgress: (part) => told.push(part)});
	job.programs = ['long.nc'];
	job.files.add('long.nc', line.repeat(40000));
	delete job.setup;
	assert.equal(fivecheck.check(job).status, STATUS.CLEAR);
	assert.equal(told[0], 'header');
	const parts = told.slice(1, told.indexOf('program'));
	assert.ok(parts.length > 2 && parts[0] < 0.5 && parts.at(-1) === 1 && parts.every((part, i) => i === 0 || part > parts[i - 1]));
};

tests['a long program is read in slices'] = () => {
	const line = 'G1 X1 F1000\nG1 X0\n', count = 400000;
	let most = 0;
	const source = {size: line.length * count, read(offset, into) {
		const wanted = Math.min(into.length, this.size - offset);
		most = Math.max(most, into.length);
		for (let i = 0; i < wanted; i++)
			into[i] = line.charCodeAt((offset + i) % line.length);
		return wanted;
	}};
	const job = exampleJob('clear', {options: ['--parse-only']});
	job.programs = ['long.nc'];
	job.files.add('long.nc', source);
	delete job.setup;
	assert.equal(fivecheck.check(job).status, STATUS.CLEAR);
	assert.ok(most <= 1 << 20);
};

/** What measures time and memory is left out. */
tests['blobs are read in slices, and only so much of them stays in memory'] = () => {
	const usual = {...READING}, sizes = [0, 1, 250, 100, 1000, 399], read = [];
	const contents = sizes.map((size, seed) => Uint8Array.from({length: size}, (_, i) => (i * 7 + seed * 31 + (i >> 8)) & 255));
	const blobs = contents.map((bytes, which) => ({size: bytes.length, slice: (from, to) => ({which, bytes: bytes.slice(from, to)})}));
	globalThis.FileReaderSync = class {
		readAsArrayBuffer({which, bytes}) {
			read.push([which, bytes.length]);
			return bytes.buffer;
		}
	};
	Object.assign(READING, {slice: 100, room: 250});
	try {
		const open = () => blobs.map((blob) => new BlobBytes(/** @type {any} */ (blob)));
		let files = open(), state = 1;
		for (let i = 0; i < 3000; i++) {
			state = (state * 1103515245 + 12345) % 2 ** 31;
			const which = state % 6, offset = (state >> 8) % 1100, into = new Uint8Array((state >> 4) % 130);
			const count = files[which].read(offset, into), wanted = contents[which].subarray(offset, offset + into.length);
			assert.ok(count === wanted.length || (count > 0 && count < wanted.length), `${count} bytes of ${wanted.length}`);
			assert.deepEqual(into.subarray(0, count), wanted.subarray(0, count));
			if (i % 100 === 0)
				files = open();
		}
		assert.ok(read.every(([, bytes]) => bytes > 0 && bytes <= 100));
		const whole = new Uint8Array(100), times = (which) => read.filter(([other]) => other === which).length;
		files[3].read(0, whole);
		const before = times(3);
		open()[3].read(50, whole);
		files[2].read(0, whole);
		files[3].read(0, whole);
		assert.equal(times(3), before, 'what is in memory is not read again');
		for (const offset of [0, 100, 200])
			files[4].read(offset, whole), files[5].read(offset, whole);
		files[3].read(0, whole);
		assert.equal(times(3), before + 1, 'what was read first makes room');
	} finally {
		Object.assign(READING, usual);
		delete globalThis.FileReaderSync;
	}
};

function untimed({memory, ...result}) {
	assert.ok(memory >= 1 << 20);
	return {...result, text: result.text.replace(/^[0-9]+ blocks?.*; time .*$/gm, 'TIME')};
}

tests['a session says what a run of its own says, again and again'] = () => {
	const {files, ...job} = exampleJob('clear'), session = fivecheck.session(files);
	const programs = {
		'clear.nc': files.contents(job.programs[0]) ?? fs.readFileSync(job.programs[0]), 'faulty.nc': 'G21\nG1 X\n', 'limit.nc': 'G21\nG53 G0 X1000\n',
		'collision.nc': fs.readFileSync('examples/ac-trunnion/collision.nc'),
	};
	for (const [name, text] of [...Object.entries(programs), ...Object.entries(programs)]) {
		files.add(name, text);
		assert.deepEqual(untimed(session.check({...job, programs: [name]})), untimed(fivecheck.check({...job, files, programs: [name]})));
	}
	// The machine file is not read again; a run of its own would fail.
	files.add(job.machine, 'gone');
	assert.equal(session.check({...job, programs: ['clear.nc']}).status, STATUS.CLEAR);
	// Unless another clearance is asked for.
	assert.equal(session.check({...job, programs: ['clear.nc'], options: ['--clearance=60']}).status, STATUS.INCOMPLETE);
};

tests['an edited block is checked without another look at the files of the machine'] = () => {
	const {files, ...job} = exampleJob('clear'), session = fivecheck.session(files), program = new TextEncoder().encode('G21\nG53 G0 X10\n');
	let read = 0;
	const count = (node) => {
		const {source} = node;
		node.source = {size: source.size, read: (offset, into) => {
			const bytes = source.read(offset, into);
			read += bytes;
			return bytes;
		}};
	};
	const countAll = (folder) => [...folder.entries.values()].forEach((entry) => entry.entries ? countAll(entry) : count(entry));
	files.add('edited.nc', program);
	countAll(files.root);
	const check = () => {
		read = 0;
		return session.check({...job, programs: ['edited.nc']});
	};
	const first = check();
	assert.ok(read > 1e6, `the machine has ${read} bytes`);
	const second = check();
	assert.ok(read > 0 && read < 1e4, `the second check read ${read} bytes`);
	assert.deepEqual(untimed(second), untimed(first));
};

tests['a session tells how near the bodies are'] = () => {
	const {files, ...job} = exampleJob('clear'), session = fivecheck.session(files);
	assert.throws(() => session.pose({}), /check a program first/);
	session.check(job);
	const home = session.pose({}, 1);
	assert.deepEqual(home.axes, {X: 0, Y: 0, Z: 0, A: 0, C: 0});
	assert.deepEqual([home.meets, home.near, home.unknown], [[], [], []]);
	// The pose of the first finding, as the check names it, and a little before.
	const found = session.check({...job, programs: ['examples/ac-trunnion/collision.nc']}).events.find(({kind}) => kind === 'collision');
	const there = session.pose(found.axes, 3);
	const apart = session.pose({...found.axes, Z: found.axes.Z + 0.1}, 3);
	assert.ok(there.meets.some(([a, b]) => a === found.a && b === found.b) || there.nearest.distance < 0.001);
	assert.deepEqual(apart.meets, []);
	assert.ok(apart.nearest.distance > 0 && apart.nearest.distance < 0.2, String(apart.nearest.distance));
	const {on_a, on_b, distance} = apart.nearest;
	assert.ok(Math.abs(Math.hypot(...on_a.map((v, i) => v - on_b[i])) - distance) < 1e-6);
	assert.throws(() => session.pose({Q: 1}), /is not a position of an axis/);
	assert.throws(() => session.pose({X: NaN}), /is not a position of an axis/);
};

tests['a job gets the parts that it needs, and all where that is not sure'] = () => {
	const machine = (controller, head = '') => `${head}<machine version="1"><controller dialect="${controller}"/></machine>`;
	const [klartext, sinumerik, more] = PARTS;
	assert.deepEqual(partsOf(machine('fanuc')), []);
	assert.deepEqual(partsOf(fs.readFileSync('machines/ac-trunnion/machine.xml', 'utf8'), fs.readFileSync('examples/ac-trunnion/setup.xml', 'utf8')), []);
	assert.deepEqual(partsOf(machine('sinumerik')), [sinumerik]);
	assert.deepEqual(partsOf(machine('klartext')), [klartext]);
	assert.deepEqual(partsOf(machine('fanuc'), '<setup version="1"><tools href="tool.tbl"/></setup>'), [more]);
	assert.deepEqual(partsOf(machine('fanuc'), undefined, ['--sensitivity=1,1,1,1']), [more]);
	assert.deepEqual(partsOf(machine('klar&#116;ext')), PARTS);
	assert.deepEqual(partsOf(machine('&c;', '<!DOCTYPE machine [<!ENTITY c "klartext">]>')), PARTS);
	assert.deepEqual(partsOf(Buffer.from(machine('fanuc'), 'utf16le').toString('latin1')), PARTS);
};

tests['a control needs the first module and its part alone, and says so without it'] = () => {
	const programs = {klartext: ['0 BEGIN PGM A MM', '1 L Z+0 R0 FMAX M91', '2 END PGM A MM'], sinumerik: ['G71 G90', 'G0 SUPA Z0 D0', 'M30']};
	for (const [i, [dialect, lines]] of Object.entries(programs).entries()) {
		const job = exampleJob('clear', {options: [`--dialect=${dialect}`]});
		delete job.setup;
		job.files.add('part.txt', lines.join('\n') + '\n');
		job.programs = ['part.txt'];
		assert.equal(new Fivecheck([modules[FIRST], modules[PARTS[i]]]).check(job).status, STATUS.CLEAR);
		assert.throws(() => new Fivecheck([modules[FIRST], modules[PARTS[1 - i]]]).check(job), PartLacking);
	}
};

tests['a part of another build is refused'] = () => {
	const bytes = fs.readFileSync(`${folder}/${PARTS[0]}`), build = /[0-9a-f]{8}(?=\.klartext\.)/;
	const own = build.exec(bytes.toString('latin1'))[0], other = own.replace(/./g, (digit) => digit === '0' ? '1' : '0');
	const changed = Buffer.from(bytes.toString('latin1').replaceAll(own, other), 'latin1');
	assert.throws(() => new Fivecheck([modules[FIRST], new WebAssembly.Module(changed)]).check(exampleJob('clear')), /different versions/);
};

tests['what the server does not give is an error, and is loaded the next time'] = async () => {
	const real = globalThis.fetch;
	let given = false;
	globalThis.fetch = async (address) => given ? new Response(fs.readFileSync(`${folder}/${String(address).split('/').pop()}`),
		{headers: {'Content-Type': 'application/wasm'}}) : new Response('<html>', {status: 404});
	try {
		const loader = new Modules('http://127.0.0.1/');
		await assert.rejects(loader.of('<machine><controller dialect="klartext"/></machine>'), /wasm cannot be loaded: the server answers 404/);
		await assert.rejects(loader.load(PARTS[0]), /klartext.wasm cannot be loaded/);
		await assert.rejects(loader.viewer(), /viewer.js cannot be loaded: the server answers 404/);
		given = true;
		assert.equal((await loader.of('<machine><controller dialect="klartext"/></machine>')).length, 2);
		assert.equal(await loader.viewer(), viewer);
	} finally {
		globalThis.fetch = real;
	}
};

tests['a mesh stands for another of its name only where their folders do not contradict'] = () => {
	const found = (mesh, ...paths) => {
		const files = [{path: 'machine.xml', blob: 0, role: 'machine', text: `<body mesh="${mesh}"/>`}, ...paths.map((path) => ({path, blob: path, role: 'mesh', text: ''}))];
		const blob = new Map(withMeshes(files)).get(mesh);
		assert.deepEqual(missingFiles(files), blob ? [] : [mesh]);
		return blob;
	};
	assert.equal(found('stl/head.stl', 'stl/head.stl', 'head.stl'), 'stl/head.stl');
	assert.equal(found('stl/head.stl', 'head.stl'), 'head.stl');
	assert.equal(found('head.stl', 'stl/head.stl'), 'stl/head.stl');
	assert.equal(found('../stl/head.stl', 'mill/stl/head.stl'), 'mill/stl/head.stl');
	assert.equal(found('stl/head.stl', 'fixtures/head.stl'), undefined);
	assert.equal(found('stl/head.stl', 'oldstl/head.stl'), undefined);
	assert.equal(found('head.stl', 'one/head.stl', 'two/head.stl'), undefined);
};

tests['a negative length of a holder is left to the check, which refuses it'] = () => {
	const data = new FormData();
	data.set('offset.name', 'G54');
	for (const [name, value] of Object.entries({number: 1, length: 120, holderLength: -60, holderDiameter: 50, cutterLength: 40, cutterDiameter: 10}))
		data.set(`t.${name}`, value);
	const job = exampleJob('clear');
	job.setup = 'own.xml';
	job.files.add('own.xml', setupXml(data, ['X'], {offset: ['offset'], part: [], fixture: [], tool: ['t']}));
	assert.match(fivecheck.check(job).messages, /length="-60" of <section>/);
};

tests['what the page keeps is of its build; where there is no room for an example, the network has it'] = async () => {
	const heard = {}, scope = 'https://here/app/', own = {'page.css': 'kept'};
	const cache = {put: async () => { throw new Error('no room'); }, match: async (name) => own[name] && new Response(own[name])};
	const worker = {registration: {scope, waiting: null}, addEventListener: (name, listener) => heard[name] = listener};
	new Function('self', 'caches', 'fetch', fs.readFileSync('src/web/app/service_worker.js', 'utf8'))(
		worker, {open: async () => cache}, async () => new Response('new'));
	const answered = async (path) => {
		let answer;
		heard.fetch({request: {method: 'GET', url: scope + path}, respondWith: (given) => answer = given});
		return (await answer).text();
	};
	assert.equal(await answered('page.css'), 'kept');
	assert.equal(await answered('examples/part.nc'), 'new');
};

tests['hostile files end with a status, and the next job is as before'] = () => {
	const seeds = fs.readdirSync('tests/fuzz/seeds').sort(), machine = fs.readFileSync('machines/ac-trunnion/machine.xml');
	const box = '<machine version="1"><base><body name="a" mesh="b.stl"/><axis name="X" type="linear" direction="1 0 0" rate_max="1">' +
		'<body name="b" mesh="b.stl"/></axis></base></machine>';
	let number = 12345;
	const random = (below) => (number = (number * 1103515245 + 12345) % 2147483648) % below;
	const spoiled = (bytes) => {
		const changed = Uint8Array.from(bytes.subarray(0, 1 + random(bytes.length)));
		for (let i = 0; i < 8; i++)
			changed[random(changed.length)] = random(256);
		return changed;
	};
	for (const bytes of [machine, ...seeds.map((name) => fs.readFileSync(`tests/fuzz/seeds/${name}`))].flatMap((good) => [good, spoiled(good), spoiled(good)])) {
		for (const hostile of ['m.xml', 's.xml', 'b.stl', 'p.nc']) {
			const files = new Files();
			files.add('m.xml', box);
			files.add('s.xml', '<setup version="1"/>');
			files.add('b.stl', 'solid b\nendsolid b\n');
			files.add('p.nc', 'G0 X1\n');
			files.add(hostile, bytes);
			const options = ['--dialect=fanuc', ...(hostile === 'b.stl' ? [] : ['--parse-only'])];
			const {status} = fivecheck.check({files, machine: 'm.xml', setup: 's.xml', programs: ['p.nc'], options});
			assert.ok(status >= 0 && status < STATUS.INTERNAL, `${hostile}: status ${status}`);
		}
	}
	assert.equal(fivecheck.check(exampleJob('clear')).status, STATUS.CLEAR);
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
	try {
		await test();
	} catch (error) {
		failed++;
		console.log(`check_face: ${name}: ${error.stack}`);
	}
}
console.log(`check_face: ${Object.keys(tests).length} tests, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
