// @ts-check
// model.js - what the viewer shows: plain data, whoever brings it (pack.js for a report, later the app).
//
// Lengths in mm, angles in degrees, times in seconds. Link 0 is the base, link i + 1 is what axes[i] carries. Meshes and
// the directions and locations of axes are in machine coordinates with every axis at 0.

/**
 * @typedef {[number, number, number]} Vec3
 *
 * @typedef {Object} Axis
 * @property {string} letter
 * @property {string} [title]
 * @property {boolean} rotary
 * @property {number} parent	the link that carries it
 * @property {Vec3} direction
 * @property {Vec3} location
 * @property {number|null} min	null: unlimited
 * @property {number|null} max
 *
 * @typedef {Object} Mesh
 * @property {Float32Array} positions	x y z for each vertex
 * @property {Uint32Array} indices	three for each triangle
 *
 * @typedef {Object} Body
 * @property {string} name
 * @property {number} link
 * @property {'machine'|'fixture'|'part'|'stock'|'holder'|'shank'|'cutter'|string} role
 * @property {number} tool	number of the tool that it belongs to: shown only while that tool is in the spindle; 0: always
 * @property {Mesh} mesh
 *
 * @typedef {Object} Finding	as a line of --format=ndjson, and besides:
 * @property {string} kind	collision, clearance, limit, start-overlap, ...
 * @property {string} file
 * @property {number} line
 * @property {number} column
 * @property {number} fraction
 * @property {string|null} a
 * @property {string|null} b
 * @property {Object<string, number>} axes
 * @property {number} time
 * @property {Vec3|null} point
 * @property {number|null} clearance
 * @property {number} [allowed_depth]	mm, of a cutter in the part or the stock
 * @property {boolean} [certain]	with the stock: it is met where no cutter has been; else it may have been cut
 * @property {string|null} block
 * @property {{file: string, line: number, column: number}[]} [callers]	of a subprogram: the call of it, the call of its caller ...
 * @property {string} [accepted]
 * @property {string} [reason]
 * @property {string} [expires]
 * @property {string} [axis]	of a limit
 * @property {number} [bound]
 * @property {number} [target]
 * @property {number} [excess]
 * @property {number} [path_tolerance]	of a limit: the axis may be so far beside its path, which stays inside
 * @property {[number, number]|null} bodies	indices
 * @property {number} [tool]
 * @property {[number[], number[]]|null} [triangles]	of a and of b, nine numbers each, as they stand at the finding
 *
 * @typedef {Object} Pair
 * @property {number} a	index of a body
 * @property {number} b
 * @property {string} status
 * @property {number} clearance	that must be kept
 * @property {string} reason
 *
 * @typedef {Object} Modes
 * @property {string|null} work_offset	null: machine coordinates are commanded
 * @property {Object<string, number>} work	its values
 * @property {Object<string, number>} shift	what G52 and G92 add
 * @property {number} length	mm: of the tool, in force
 * @property {boolean} tcp
 * @property {boolean} turned	the program has turned, mirrored or scaled its coordinates
 * @property {number} spindle	revolutions per minute, by M4 below 0; 0: it stands, or its speed is not known
 *
 * @typedef {Object} Pose
 * @property {number[]} values	by axis, in the order of model.axes; mm and degrees
 * @property {number} block	number of the block that runs, from 1; 0: none
 * @property {number} line	of that block
 * @property {number} file	index in model.sources
 * @property {number} tool
 * @property {number} feed	mm/min that the program asks for; 0: a rapid, or a feed of rotary axes alone, or a time
 * @property {Modes|null} modes	what holds there; null: not known
 * @property {number} motion	0 rest, 1 rapid, 2 feed, 3 feed with the spindle at rest, 4 a rapid whose way is unknown
 *
 * @typedef {Object} Path	what is not at hand yet is promised, and the coarse level answers meanwhile
 * @property {number} duration
 * @property {number} checked	what comes later was read, but not checked
 * @property {(time: number) => Pose} pose
 * @property {(most: number) => number[]} instants	about so many times at which axes change their motion
 * @property {(time: number) => Promise<unknown>|null} load	what pose(time) should know; null: it knows
 * @property {(time: number, by: number) => Promise<number>} blockEnd	where the block `by` blocks on from the present one ends
 * @property {(file: number, line: number) => Promise<number>} timeOf	where the first block of a line ends, or of the last one before that moves
 *
 * @typedef {Object} Source	a program or subprogram
 * @property {string} name
 * @property {string|null} sha256
 * @property {number} lines
 * @property {{first: number, lines: string[]}[]} windows	what is at hand of the text, in order
 *
 * @typedef {Object} Clearance	"at least" of all pairs, over time
 * @property {number} cap	mm: more is not measured
 * @property {number} bound	mm: of all blocks, as far as the cap
 * @property {{least: number, pair: number, file: string, line: number, time: number}|null} smallest	that was measured, at the end of its block
 * @property {Float64Array} times	starts of the intervals, and the end of the last
 * @property {Float64Array} least	mm, one for each interval
 * @property {Float64Array} most	the greatest of the bounds that were merged to this interval
 * @property {Float64Array} pair	index of the nearest pair in model.pairs, or -1
 *
 * @typedef {Object} Planes	by row: from its time to the next one's
 * @property {Float64Array} time
 * @property {Float64Array} pair	-1: nothing is near
 * @property {Float64Array[]} point	x, y, z: in the frame of the link of body a
 * @property {Float64Array[]} normal	from a to b
 * @property {Float64Array} distance	between the nearest triangles at that time
 *
 * @typedef {Object} Mark	a tool change or the name of an operation
 * @property {number} time
 * @property {string} text
 *
 * @typedef {Object} Model
 * @property {string} version	of fivecheck
 * @property {string} machine
 * @property {string} program
 * @property {'clear'|'passed'|'found'|'accepted'|'incomplete'|string} verdict
 * @property {string} sentence
 * @property {boolean} failing
 * @property {string[]} cautions
 * @property {string[]} doubts	those of them that doubt what the verdict takes for granted
 * @property {{file: string|null, line: number|null, text: string}[]} errors
 * @property {{kind: string, file: string, sha256: string|null}[]} files
 * @property {Axis[]} axes
 * @property {string[]} readOut	letters of the axes as a control shows them
 * @property {string[]} links	names
 * @property {{link: number, location: Vec3, direction: Vec3}} spindle	its gauge point, and the way to the tip of a tool
 * @property {number} workholding	the link that carries the work
 * @property {Map<number, number>} lengths	of the tools of the setup by number, mm
 * @property {Body[]} bodies
 * @property {Pair[]} pairs
 * @property {Finding[]} findings
 * @property {Path} path
 * @property {Source[]} sources
 * @property {Clearance|null} clearance
 * @property {Planes|null} planes
 * @property {Mark[]} tools
 * @property {Mark[]} operations
 * @property {[string, string][]} setup	what, value
 * @property {[string, string][]} statistics
 * @property {{quantity: string, direction: string, result: string, range: number, tried: number, turn: number, kind: string|null}[]} sensitivity	what a setup that is off does; empty: not asked for
 * @property {number} leftOut	findings that are not here
 * @property {number|null} accuracy	mm: how exactly the bodies are drawn
 */

export {};
