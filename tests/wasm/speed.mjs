// speed.mjs - what the checker in WebAssembly takes, beside the native one. No time is judged here.
//
// speed.mjs FIVECHECK MODULE MACHINE SETUP PROGRAM [ROUNDS]: the least time of some rounds, on the clock and of the processor,
// each for itself. In each round the native program, a new node (cold: the module is compiled, too) and the same node once
// more (warm) take turns. All read the program in slices. The processor's time has that of node's threads in it, which compile
// beside the run. The machine's meshes have to be in its folder.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {Fivecheck} from '../../src/web/app/fivecheck.js';
import {Files} from '../../src/web/app/files.js';
import {addFromDisk} from './disk.mjs';

/** Seconds on the clock, and of the processor that this process and its threads took. */
function now() {
	const {user, system} = process.cpuUsage();
	return {wall: performance.now() / 1e3, cpu: (user + system) / 1e6};
}

/** Two runs of the module in this process: cold, warm. */
async function runs(module, machine, setup, program) {
	const times = [];
	let fivecheck;
	for (let i = 0; i < 2; i++) {
		const start = now(), files = new Files();
		fivecheck ??= await Fivecheck.load(fs.readFileSync(module));
		addFromDisk(files, path.dirname(machine), '.');
		files.add('s.xml', fs.readFileSync(setup));
		const opened = addFromDisk(files, program, 'p.nc');
		const {status} = fivecheck.run(['-fndjson', '--setup=s.xml', path.basename(machine), 'p.nc'], files);
		const end = now();
		opened.forEach((file) => file.close());
		times.push({status, wall: end.wall - start.wall, cpu: end.cpu - start.cpu});
	}
	return times;
}

/** The native program, its times as the shell tells them. */
function native(fivecheck, machine, setup, program) {
	const {status, stderr} = spawnSync('bash', ['-c', 'TIMEFORMAT="%R %U %S"; time "$0" "$@" >/dev/null 2>&1', fivecheck, '-j1', '-fndjson', `--setup=${setup}`, machine, program],
		{encoding: 'utf8'});
	const [wall, user, system] = stderr.trim().split(' ').map(Number);
	return {status, wall, cpu: user + system};
}

const [fivecheck, module, machine, setup, program, rounds = '5'] = process.argv.slice(2);
if (fivecheck === '--runs') {
	console.log(JSON.stringify(await runs(module, machine, setup, program)));
} else {
	const least = ['native', 'cold', 'warm'].map((name) => ({name, wall: Infinity, cpu: Infinity}));
	for (let i = 0; i < Number(rounds); i++) {
		const node = spawnSync(process.execPath, [fileURLToPath(import.meta.url), '--runs', module, machine, setup, program], {encoding: 'utf8'});
		const all = [native(fivecheck, machine, setup, program), ...JSON.parse(node.stdout)];
		if (new Set(all.map(({status}) => status)).size > 1)
			throw new Error(`exit statuses ${all.map(({status}) => status)}`);
		all.forEach((time, k) => ['wall', 'cpu'].forEach((kind) => least[k][kind] = Math.min(least[k][kind], time[kind])));
	}
	for (const {name, wall, cpu} of least) {
		const [{wall: clock, cpu: processor}] = least;
		console.log(`${name.padEnd(6)} wall ${wall.toFixed(2)} s, ${(wall / clock).toFixed(2)} times; processor ${cpu.toFixed(2)} s, ${(cpu / processor).toFixed(2)} times`);
	}
}
