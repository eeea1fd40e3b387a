// Draws events on the GPU: each packet is uploaded as it came, and its events are added to a picture that decays.
import * as shaders from "./shaders.js";

const MAX_BYTES = 32768 * 9; // of a packet
// Columns of the payload: type, and offset in bytes for each event.
const COLUMNS = [["UNSIGNED_INT", 0], ["UNSIGNED_SHORT", 4], ["UNSIGNED_SHORT", 6], ["UNSIGNED_BYTE", 8]];

export class EventView {
  // Throws Error where the browser cannot draw into textures of floats.
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { antialias: false, alpha: false });
    if (!this.gl?.getExtension("EXT_color_buffer_float"))
      throw new Error("This browser has no WebGL 2 with textures of floats.");
    const { gl } = this;
    this.format = gl.getExtension("EXT_float_blend") ? gl.RG32F : gl.RG16F;
    this.events = program(gl, shaders.EVENT_VERTEX, shaders.EVENT_FRAGMENT);
    this.decay = program(gl, shaders.SCREEN_VERTEX, shaders.DECAY_FRAGMENT);
    this.screen = program(gl, shaders.SCREEN_VERTEX, shaders.SHOW_FRAGMENT);
    this.columns = gl.createVertexArray();
    this.nothing = gl.createVertexArray();
    this.target = gl.createFramebuffer();
    this.buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, MAX_BYTES, gl.DYNAMIC_DRAW);
    this.decayS = Infinity;
    this.resize(1, 1);
  }

  // Keeps the picture if the size is the same.
  resize(width, height) {
    if (this.width === width && this.height === height) return;
    const { gl } = this;
    [this.width, this.height] = [this.canvas.width, this.canvas.height] = [width, height];
    gl.deleteTexture(this.sums ?? null);
    this.sums = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.sums);
    gl.texStorage2D(gl.TEXTURE_2D, 1, this.format, width, height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST); // floats have no other filter
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.sums, 0);
    this.clear();
  }

  clear() {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    this.nowNs = null;
  }

  // Adds packets of events, in the order of time; decays the picture to the end of the last one.
  add(packets) {
    if (packets.length === 0) return;
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.viewport(0, 0, this.width, this.height);
    gl.enable(gl.BLEND);
    this.passTo(packets[packets.length - 1].t1Ns);
    gl.useProgram(this.events.program);
    gl.bindVertexArray(this.columns);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.uniform2f(this.events.at.size, this.width, this.height);
    gl.uniform1f(this.events.at.rate, 1 / this.decayS);
    for (const packet of packets) if (packet.count > 0) this.draw(packet);
    gl.disable(gl.BLEND);
  }

  passTo(timeNs) {
    const { gl } = this;
    const left = Math.exp((-(timeNs - (this.nowNs ?? timeNs)) * 1e-9) / this.decayS);
    this.nowNs = timeNs;
    if (left === 1) return;
    gl.useProgram(this.decay.program);
    gl.bindVertexArray(this.nothing);
    gl.blendColor(left, left, left, left);
    gl.blendFunc(gl.ZERO, gl.CONSTANT_COLOR);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  draw({ payload, count, t0Ns, dtUnitNs }) {
    const { gl } = this;
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, payload);
    COLUMNS.forEach(([type, offset], column) => {
      gl.enableVertexAttribArray(column);
      gl.vertexAttribIPointer(column, 1, gl[type], 0, offset * count);
    });
    gl.uniform1f(this.events.at.age, (this.nowNs - t0Ns) * 1e-9);
    gl.uniform1f(this.events.at.unit, dtUnitNs * 1e-9);
    gl.drawArrays(gl.POINTS, 0, count);
  }

  // Draws the picture to the canvas; colours are [r, g, b] from 0 to 1.
  show({ none, on, off }) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, this.width, this.height);
    gl.useProgram(this.screen.program);
    gl.bindVertexArray(this.nothing);
    gl.bindTexture(gl.TEXTURE_2D, this.sums);
    gl.uniform3fv(this.screen.at.none, none);
    gl.uniform3fv(this.screen.at.on, on);
    gl.uniform3fv(this.screen.at.off, off);
    gl.uniform1i(this.screen.at.height, this.height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // The sums of all pixels, row by row from the top: ON, OFF, 0, 1 of each.
  sumsOf() {
    const { gl } = this;
    const sums = new Float32Array(4 * this.width * this.height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.readPixels(0, 0, this.width, this.height, gl.RGBA, gl.FLOAT, sums);
    return sums;
  }
}

// A program with the places of its uniforms.
function program(gl, vertex, fragment) {
  const made = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  const uniforms = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS);
  const names = Array.from({ length: uniforms }, (_, i) => gl.getActiveUniform(made, i).name);
  return { program: made, at: Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(made, name)])) };
}
