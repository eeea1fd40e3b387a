// The programs of the GPU. Textures have the rows of the sensor: row 0 is the top one.

// One point for each event. Its weight has decayed since the event: hits is (ON, OFF).
export const EVENT_VERTEX = `#version 300 es
layout(location = 0) in uint dt;
layout(location = 1) in uint x;
layout(location = 2) in uint y;
layout(location = 3) in uint p;
uniform vec2 size;    // pixels of the sensor
uniform float age;    // seconds from t0 of the packet to now
uniform float unit;   // seconds of a step of dt
uniform float rate;   // of the decay, 1 / s; 0: hits are kept
flat out vec2 hits;
void main() {
  float weight = exp(-rate * (age - float(dt) * unit));
  hits = p == 1u ? vec2(weight, 0.0) : vec2(0.0, weight);
  gl_Position = vec4((vec2(x, y) + 0.5) / size * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}`;

export const EVENT_FRAGMENT = `#version 300 es
precision highp float;
flat in vec2 hits;
out vec4 sum;
void main() { sum = vec4(hits, 0.0, 0.0); }`;

// A triangle over the whole target.
export const SCREEN_VERTEX = `#version 300 es
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}`;

export const DECAY_FRAGMENT = `#version 300 es
precision highp float;
out vec4 none;
void main() { none = vec4(0.0); }`;  // blending multiplies the target by the constant colour

export const SHOW_FRAGMENT = `#version 300 es
precision highp float;
uniform highp sampler2D sums;
uniform vec3 none, on, off;
uniform int height;
out vec4 colour;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.x, float(height) - gl_FragCoord.y);
  vec2 sum = texelFetch(sums, pixel, 0).rg;
  vec2 strength = 1.0 - exp(-1.2 * sum);
  float most = max(strength.x, strength.y);
  vec2 share = sum * sum;  // the stronger polarity gives the colour
  vec3 hue = (on * share.x + off * share.y) / max(share.x + share.y, 1e-12);
  colour = vec4(mix(none, hue, most), 1.0);
}`;
