// check_wasm.mjs - the checker in WebAssembly prints the same bytes as the native one.
//
// check_wasm.mjs FIVECHECK FOLDER [JOBS]: the modules in FOLDER (make web) on the examples, in all formats, with every table, all
// of them and the first alone; then the first alone on each job that tests/wasm/record_job kept in JOBS. All runs see the same files under the same names.
// What measures time is left out.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {FIRST, Fivecheck, PARTS, PartLacking} from '../../src/web/app/fivecheck.js';
import {Files} from '../../src/web/app/files.js';
import {addFromDisk} from './disk.mjs';

const [program, folder, jobs] = process.argv.slice(2), native = path.resolve(program);
const viewer = fs.readFileSync(`${folder}/viewer.js`, 'utf8');
const all = await Fivecheck.load([FIRST, ...PARTS].map((name) => fs.readFileSync(`${folder}/${name}`)), viewer);
const first = new Fivecheck(all.modules.slice(0, 1), viewer);
let runs = 0, failed = 0;

/** Times differ from run to run: the line of statistics, and the attribute of JUnit. */
function untimed(text) {
	return text.replace(/^[0-9]+ blocks?.*; time .*$/gm, 'TIME').replace(/ time="[0-9.]*"/g, ' time=""');
}

function firstDifference(a, b) {
	const left = a.split('\n'), right = b.split('\n');
	const line = left.findIndex((text, i) => text !== right[i]);
	return `line ${line + 1}:\n  native ${left[line]}\n  wasm   ${right[line]}`;
}

/** Runs both in `folder`, whose `inputs` the checker in WebAssembly sees, too. */
function compare(fivecheck, name, folder, inputs, args, written = []) {
	const files = new Files();
	const opened = inputs.flatMap((input) => addFromDisk(files, path.join(folder, input), input));
	const work = fs.mkdtempSync(path.join(os.tmpdir(), 'fivecheck-wasm-'));
	for (const input of inputs)
		fs.symlinkSync(path.resolve(folder, input), path.join(work, input));
	const one = spawnSync(native, args, {cwd: work, maxBuffer: 1 << 30, encoding: 'utf8', env: {PATH: process.env.PATH}});
	const two = fivecheck.run(args, files);
	opened.forEach((bytes) => bytes.close());
	const pairs = [['status', String(one.status), String(two.status)], ['output', untimed(one.stdout), untimed(two.out)],
		['messages', one.stderr, two.err]];
	for (const file of written) {
		const from = path.join(work, file), bytes = files.contents(file);
		pairs.push([file, fs.existsSync(from) ? fs.readFileSync(from, 'latin1') : '(none)',
			bytes ? Buffer.from(bytes).toString('latin1') : '(none)']);
	}
	fs.rmSync(work, {recursive: true});
	runs++;
	for (const [what, left, right] of pairs) {
		if (left !== right) {
			failed++;
			console.log(`${name}: ${args.join(' ')}: ${what} differs, ${firstDifference(left, right)}`);
		}
	}
	return two.status;
}

const WAYS = [['-f', 'text'], ['-f', 'ndjson', '--all'], ['-f', 'junit'], ['-f', 'sarif', '--all'], ['-f', 'github'], ['--dump-path'],
	['--list-pairs'], ['--parse-only'], ['--clearance=2', '--all', '-f', 'ndjson'], ['--method=conventional', '-f', 'ndjson'],
	['--tolerance=0.01', '--dump-path']];
/** What is not in the first module. */
const LARGE = [['-f', 'junit'], ['-f', 'sarif', '--all'], ['-f', 'github'], ['--glb=g.glb'], ['--sensitivity=1,1,1,1'],
	['--dialect=sinumerik'], ['--dialect=klartext']];
const WRITTEN = {'--report=r.html': 'r.html', '--picture=p.svg': 'p.svg', '--pose=s.stl': 's.stl', '--glb=g.glb': 'g.glb'};

/** The first module alone prints no result for what only a part has. */
function refuses(name, args) {
	const files = new Files(), opened = ['machines', 'examples'].flatMap((input) => addFromDisk(files, input, input));
	runs++;
	try {
		const {status} = first.run(args, files);
		failed++;
		console.log(`${name}: ${args.join(' ')}: status ${status} of the first module alone`);
	} catch (error) {
		if (!(error instanceof PartLacking))
			throw error;
	}
	opened.forEach((bytes) => bytes.close());
}

/** The head is in the table and two axes are past their limits: findings at one instant, which C libraries sort in different ways. */
function pastLimits() {
	const work = fs.mkdtempSync(path.join(os.tmpdir(), 'fivecheck-limits-')), blocks = [...Array(50).keys()];
	fs.cpSync('machines/ac-trunnion', work, {recursive: true});
	fs.writeFileSync(path.join(work, 'p.nc'), `G21 G90 G61 F1000\n${blocks.map((i) => `G1 Z${-410 - i} A${35 + i}\n`).join('')}M2\n`);
	compare(first, 'past limits', work, fs.readdirSync(work), ['-f', 'ndjson', '--all', 'machine.xml', 'p.nc']);
	fs.rmSync(work, {recursive: true});
}

for (const name of ['ac-trunnion', 'b-head-c-table', 'cb-head']) {
	const machine = `machines/${name}/machine.xml`, setup = `--setup=examples/${name}/setup.xml`;

	for (const fivecheck of [all, first]) {
		const written = Object.entries(WRITTEN).slice(0, fivecheck === first ? 3 : 4);
		const ways = fivecheck === first ? WAYS.filter((way) => !LARGE.some((large) => large.join() === way.join())) : WAYS;

		compare(fivecheck, name, '.', ['machines'], ['--check-machine', machine]);
		for (const program of ['clear', 'collision']) {
			for (const way of ways)
				compare(fivecheck, name, '.', ['machines', 'examples'], [...way, setup, machine, ...(way[0] === '--list-pairs' ? [] : [`examples/${name}/${program}.nc`])]);
		}
		compare(fivecheck, name, '.', ['machines', 'examples'], [...written.map(([option]) => option), '-f', 'ndjson', setup, machine, `examples/${name}/collision.nc`],
			written.map(([, file]) => file));
	}
	for (const large of LARGE)
		refuses(name, [...large, setup, machine, `examples/${name}/collision.nc`]);
}
refuses('explain', ['--explain=G1']);
pastLimits();
for (const job of jobs ? fs.readdirSync(jobs).sort() : []) {
	const args = fs.readFileSync(path.join(jobs, job, 'arguments'), 'utf8').trimEnd().split('\n'), folder = path.join(jobs, job, 'files');
	const inputs = fs.readdirSync(folder);

	compare(first, job, folder, inputs, args);
	compare(first, job, folder, inputs, ['--dump-path', ...args.filter((word) => word.startsWith('--setup')), ...(args.includes('-s') ? ['-s', 's.xml'] : []), 'm.xml', 'p.nc']);
}
console.log(`check-wasm: ${runs} runs, ${failed} differ`);
process.exitCode = failed ? 1 : 0;
