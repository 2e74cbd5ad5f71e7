// @ts-check
// shaders.js - the two programs that run on the graphics card: lit surfaces, and what is drawn in one colour.

const COMMON = `#version 300 es
precision highp float;
uniform mat4 model, camera;
uniform vec4 colour, cut;
uniform vec3 eye;
`;

/** The vertex shader of both programs. */
export const VERTEX = COMMON + `
in vec3 position;
out vec3 world, local;
void main() {
	local = position;
	world = (model * vec4(position, 1)).xyz;
	gl_Position = camera * vec4(world, 1);
	gl_PointSize = 7.0;
}`;

/** Flat faces with a lamp beside the eye; inner sides, visible in a section, are hatched. */
export const SURFACE = COMMON + `
in vec3 world, local;
uniform float alpha;
out vec4 pixel;
void main() {
	if (dot(cut.xyz, world) > cut.w) discard;
	vec3 n = normalize(cross(dFdx(world), dFdy(world)));
	vec3 toEye = normalize(eye - world);
	if (dot(n, toEye) < 0.0) n = -n;
	vec3 lamp = normalize(toEye + vec3(-0.35, -0.25, 0.9));
	float light = 0.42 + 0.38 * max(dot(n, lamp), 0.0) + 0.14 * n.z + 0.16 * dot(n, toEye);
	vec3 c = colour.rgb * light;
	if (!gl_FrontFacing && length(cut.xyz) > 0.0)
		c = colour.rgb * (fract((gl_FragCoord.x + gl_FragCoord.y) / 9.0) < 0.25 ? 0.45 : 0.8);
	pixel = vec4(c, 1) * alpha;
}`;

/** Lines, and planes with a grid. */
export const PLAIN = COMMON + `
in vec3 world, local;
uniform float alpha, grid;
out vec4 pixel;
void main() {
	if (dot(cut.xyz, world) > cut.w) discard;
	float a = alpha;
	if (grid > 0.0) {
		vec2 cell = abs(fract(local.xy * grid) - 0.5) / fwidth(local.xy * grid);
		float border = max(abs(local.x), abs(local.y));
		a = min(cell.x, cell.y) < 0.7 ? 0.5 : alpha;
		a = border > 0.99 ? 0.9 : a;
	}
	pixel = vec4(colour.rgb, 1) * a;
}`;
