// Steers the camera with the mouse, a finger and the keys, where the stream is the viewer's own.

const SEND_MS = 80; // between two steers
const LEAST_FRAMES = 20; // a second: where fewer come, the camera moves as slowly as if these did
const TURN = 1.5; // radians a second of the wall clock, where the pointer is pulled by the width of a picture
const KEY_TURN = 0.6; // likewise, of an arrow key
const STILL = { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } };

// Keys by what they do: an axis of the camera (x right, y down, z forward), and its sign.
const WALK = { w: ["z", 1], s: ["z", -1], a: ["x", -1], d: ["x", 1], e: ["y", -1], q: ["y", 1] };
const TURNS = { ArrowRight: ["y", 1], ArrowLeft: ["y", -1], ArrowUp: ["x", 1], ArrowDown: ["x", -1] };

// The velocity that keys and a pull of the pointer ask for, per second of the stream. `pull`: {x, y} in widths of the
// picture. `walk`: scene units a second of the wall clock. `speed`: stream seconds per second. `rate`: frames in a second
// of the stream.
export function velocityOf(keys, pull, { walk, speed, rate }) {
  const factor = Math.min(1 / speed, rate / LEAST_FRAMES);
  const { linear, angular } = structuredClone(STILL);
  for (const key of keys) {
    if (WALK[key]) linear[WALK[key][0]] += WALK[key][1] * walk * factor;
    if (TURNS[key]) angular[TURNS[key][0]] += TURNS[key][1] * KEY_TURN * factor;
  }
  angular.y += TURN * pull.x * factor;
  angular.x -= TURN * pull.y * factor;
  return { linear, angular };
}

export class LookRound {
  // `target()`: {id, token, walk, speed, rate} of the stream, or null where it is not to be steered.
  constructor(connection, pictures, target) {
    Object.assign(this, { connection, target, keys: new Set(), pull: { x: 0, y: 0 }, sent: "" });
    pictures.addEventListener("pointerdown", (event) => this.grab(event));
    pictures.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) pictures.addEventListener(end, () => this.release());
    addEventListener("keydown", (event) => this.key(event, true));
    addEventListener("keyup", (event) => this.key(event, false));
    addEventListener("blur", () => this.keys.clear());
    setInterval(() => this.send(), SEND_MS);
  }

  grab(event) {
    if (!this.target() || event.target.tagName !== "CANVAS") return;
    event.preventDefault();
    event.target.setPointerCapture(event.pointerId);
    this.from = { x: event.clientX, y: event.clientY, width: event.target.clientWidth };
  }

  move({ clientX, clientY }) {
    const { from } = this;
    if (from) this.pull = { x: (clientX - from.x) / from.width, y: (clientY - from.y) / from.width };
  }

  release() {
    this.from = null;
    this.pull = { x: 0, y: 0 };
  }

  key(event, down) {
    const taken = event.target.closest?.("select, input") || event.ctrlKey || event.metaKey || event.altKey;
    if (!this.target() || (down && taken) || !(event.key in WALK || event.key in TURNS)) return;
    event.preventDefault();
    if (down) this.keys.add(event.key);
    else this.keys.delete(event.key);
  }

  // The server keeps the newest velocity: only a change is sent. A new stream follows its trajectory until the first one.
  send() {
    const target = this.target();
    if (!target) return void (this.sent = "");
    const velocity = velocityOf(this.keys, this.pull, target);
    const said = target.id + JSON.stringify(velocity);
    if (said === this.sent) return;
    this.sent = said;
    this.connection.call("steer", { streamId: target.id, token: target.token, velocity }).catch(() => {});
  }
}
