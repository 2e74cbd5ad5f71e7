// units.js - checks of the viewer's modules against plain arithmetic; runs inside the joined script, in a browser.
// The last value is the list of what failed.

const failures = [];
const check = (name, condition) => {
	if (!condition) failures.push(name);
};
const near = (a, b, tolerance = 1e-9) => Math.abs(a - b) <= tolerance;
const sameVec = (a, b, tolerance = 1e-9) => a.every((value, k) => near(value, b[k], tolerance));
/** The same numbers in each run. */
function* randoms() {
	for (let state = 12345;;) {
		state = Math.imul(state, 1103515245) + 12345 >>> 0;
		yield state / 2 ** 32;
	}
}
const source = randoms();
const random = (low, high) => low + (high - low) * source.next().value;

// Matrices and kinematics: A about -x through z 120, then C about -z, as on the example machine.
{
	const p = [3, -4, 5];
	const m = rotation([0, 0, 1], [1, 0, 0], Math.PI / 2);
	check('rotation', sameVec(place(m, [2, 0, 7]), [1, 1, 7]));
	check('placeBack', sameVec(placeBack(m, place(m, p)), p));
	check('turnBack', sameVec(turnBack(m, turn(m, p)), p));
	const axes = [
		{letter: 'A', rotary: true, parent: 0, direction: [-1, 0, 0], location: [0, 0, 120]},
		{letter: 'C', rotary: true, parent: 1, direction: [0, 0, -1], location: [0, 0, 120]},
		{letter: 'X', rotary: false, parent: 0, direction: [1, 0, 0], location: [0, 0, 0]},
	];
	const poses = linkPoses(axes, [-90, 90, 12]);
	// C 90 about -z takes x to -y; A -90 about -x is +90 about x: y to z.
	check('two rotary axes', sameVec(place(poses[2], [10, 0, 120]), [0, 0, 110]));
	check('linear axis', sameVec(place(poses[3], [1, 2, 3]), [13, 2, 3]));
}

// The camera: a pixel's ray passes through what is seen at that pixel.
{
	const camera = new Camera();
	camera.fit([10, 20, 30], 100, 1.5);
	for (let i = 0; i < 50; i++) {
		camera.orbit(random(-1, 1), random(-1, 1));
		const point = [random(-50, 70), random(-40, 80), random(-30, 90)];
		const [x, y, depth] = camera.project(point, 900, 600);
		const {origin, direction} = camera.ray(x, y, 900, 600);
		const along = dot(sub(point, origin), direction);
		check('ray and project', depth > 0 && norm(sub(add(origin, scale(direction, along)), point)) < 1e-6);
		const clip = multiply(camera.projection(1.5, 500), camera.view());
		const w = clip[3] * point[0] + clip[7] * point[1] + clip[11] * point[2] + clip[15];
		const sx = (place(clip, point)[0] / w + 1) * 450;
		check('matrix and project', near(sx, x, 1e-6));
	}
	const from = camera.back();
	camera.lookFrom([1, 2, 3]);
	check('lookFrom', sameVec(camera.back(), unit([1, 2, 3])) && norm(from) > 0.99);
	check('front', (camera.yaw = 0, camera.pitch = 0, sameVec(camera.back(), [0, -1, 0]) && sameVec(camera.up(), [0, 0, 1])));
}

/** A box as a closed mesh of 12 triangles. */
function box(low, high) {
	const positions = [];
	for (let i = 0; i < 8; i++) positions.push(i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]);
	const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
	return {positions: Float32Array.from(positions), indices: Uint32Array.from(quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]))};
}

// A cube has twelve edges; the diagonals of its sides are none. An open triangle has three.
check('edges of a box', featureEdges(box([0, 0, 0], [1, 2, 3])).length === 24);
check('edges of a triangle', featureEdges({positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), indices: Uint32Array.of(0, 1, 2)}).length === 6);

// Rays against a tree of boxes: as against all triangles one by one.
{
	const positions = [], indices = [];
	for (let t = 0; t < 300; t++) {
		const c = [random(-100, 100), random(-100, 100), random(-100, 100)];
		for (let k = 0; k < 9; k++) positions.push(c[k % 3] + random(-15, 15));
		indices.push(3 * t, 3 * t + 1, 3 * t + 2);
	}
	const tree = new MeshTree({positions: Float32Array.from(positions), indices: Uint32Array.from(indices)});
	let hits = 0;
	for (let i = 0; i < 300; i++) {
		const o = [random(-200, 200), random(-200, 200), 250], d = unit(sub([random(-80, 80), random(-80, 80), 0], o));
		let least = Infinity;
		for (let t = 0; t < 300; t++) least = Math.min(least, tree.meetsTriangle(t, o, d));
		const hit = tree.hit(o, d, 1e6);
		check('tree and all triangles', hit ? near(hit.distance, least) : least === Infinity);
		if (hit) hits++;
	}
	check('some rays hit', hits > 50 && hits < 300);
	const cube = new MeshTree(box([-1, -1, -1], [1, 1, 1]));
	check('ray along a side of the box', cube.hit([0, 0, 5], [0, 0, -1], 1e6)?.distance === 4);
	check('ray past the box', cube.hit([3, 0, 5], [0, 0, -1], 1e6) === null);
	check('limit of a ray', cube.hit([0, 0, 5], [0, 0, -1], 3) === null);
}

// The pyramid: least and greatest of any stretch, as by a walk.
{
	const count = 777;
	const times = Float64Array.from({length: count + 1}, (_, i) => i);
	const least = Float64Array.from({length: count}, () => random(0, 10)), most = least.map((value) => value + 1);
	const pyramid = new Pyramid({cap: 10, times, least, most, pair: least});
	for (let i = 0; i < 200; i++) {
		const from = random(-5, count), to = from + random(0, 200);
		const first = Math.max(0, Math.floor(from)), last = Math.min(count - 1, Math.max(first, Math.floor(to)));
		const range = pyramid.range(from, to);
		check('pyramid', near(range[0], Math.min(...least.slice(first, last + 1))) && near(range[1], Math.max(...most.slice(first, last + 1))));
	}
	check('an empty pyramid', new Pyramid({cap: 1, times: Float64Array.of(0), least: new Float64Array(0), most: new Float64Array(0), pair: least}).range(0, 1) === null);
}

// A path of ten blocks of two rows each, at one level and in chunks of seven rows of which one is missing.
const pathChecks = (async () => {
	const names = ['time', 'block', 'line', 'file', 'tool', 'class', 'modes', 'feed', 'X'];
	const rows = [[0, 0, 0, 0, 0, 0, -1, 0, 0]];
	for (let block = 1; block <= 10; block++) {
		for (const half of [0.5, 1]) rows.push([block - 1 + half, block, 10 * block, 0, block > 5 ? 2 : 1, 2, -1, 600, 100 * (block - 1 + half)]);
	}
	const columns = (list) => names.map((_, k) => Float64Array.from(list, (row) => row[k]));
	const whole = new Levels({columns: names, scale: [], rows: rows.length, coarse: {blob: 0, rows: rows.length}, chunks: [], complete: true}, null, columns(rows));
	const parts = [rows.slice(0, 7), rows.slice(7, 14), rows.slice(14)];
	const heads = parts.map((part, i) => ({blob: i, first: 7 * i, rows: part.length, from: part[0][0], to: part[part.length - 1][0]}));
	const coarse = columns(rows.filter((_, i) => i % 4 === 0));
	const chunked = new Levels({columns: names, scale: names.map(() => 1), rows: rows.length, coarse: {blob: 9, rows: 6}, chunks: heads, complete: true}, null, coarse);
	parts.forEach((part, i) => chunked.ready.set(i, columns(part)));
	const windows = new Levels({columns: names, scale: names.map(() => 1), rows: rows.length, coarse: {blob: 9, rows: 6}, chunks: [heads[0], heads[2]], complete: false}, null, coarse);
	windows.ready.set(0, columns(parts[0]));
	windows.ready.set(1, columns(parts[2]));
	for (const [name, levels] of Object.entries({whole, chunked})) {
		const path = new ReportPath(levels, ['X'], 10, 10, []);
		for (let time = 0; time <= 10; time += 0.05) check(`${name}: pose at ${time}`, near(path.pose(time).values[0], 100 * time, 1e-6));
		check(`${name}: block`, path.pose(3).block === 3 && path.pose(3.01).block === 4 && path.pose(5.2).tool === 2);
		check(`${name}: next`, await path.blockEnd(3.2, 1) === 4 && await path.blockEnd(4, 1) === 5 && await path.blockEnd(9.9, 1) === 10 && await path.blockEnd(10, 1) === 10);
		check(`${name}: previous`, await path.blockEnd(3.2, -1) === 3 && await path.blockEnd(3, -1) === 2 && await path.blockEnd(0.3, -1) === 0);
		check(`${name}: several`, await path.blockEnd(0, 4) === 4 && await path.blockEnd(10, -3) === 7);
		check(`${name}: line`, await path.timeOf(0, 40) === 4 && await path.timeOf(0, 45) === 4 && await path.timeOf(0, 5) === -1);
	}
	const path = new ReportPath(windows, ['X'], 10, 10, []);
	check('windows: coarse between', near(path.pose(4.5).values[0], 450, 1e-6));
	check('windows: fine', path.pose(8.7).block === 9 && path.load(8.7) === null);
	check('windows: line in a chunk', await path.timeOf(0, 90) === 9);
})();

// Comments of several controls, and numbers as a person reads them.
check('comments', commentOf('(ROUGH)') === 'ROUGH' && commentOf('N10 ; Finish') === 'Finish' && commentOf('12 * - POCKET') === 'POCKET' &&
	commentOf('( M104 S205 T1 )') === null && commentOf('(G92 E-0.5)') === null && commentOf('(BLADE 1)') === 'BLADE 1' && commentOf('(T1 BALL 10)') === 'T1 BALL 10' &&
	commentOf('G0 (NOT ALONE)') === null && commentOf('(---)') === null);
check('numbers', fixed(-0.0001, 3) === '0.000' && fixed(-0.1, 3) === '-0.100' && fixed(-10, 0) === '-10' && grouped(1234567) === '1,234,567');
check('durations', duration(53.3388) === '53.339 s' && duration(59.9996) === '1 min 0.0 s' && duration(7300) === '2 h 1 min 40 s');

pathChecks.then(() => {
	window.unitFailures = failures;
	document.dispatchEvent(new Event('units-done'));
}, (e) => {
	window.unitFailures = [...failures, String(e)];
	document.dispatchEvent(new Event('units-done'));
});
