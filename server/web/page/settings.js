// What the page asks for: its form, the fragment of its address, and the request to the server.

export const DEFAULTS = {
  scene: "", // the first of the server that moves by itself, before a camera that stands
  stream: "", // id of a running broadcast, instead of a scene
  sensor: 0, // of that broadcast
  motion: "pan", // a kind of motion, or the name of a trajectory
  px: 0.5, // pixels per frame, of a kind of motion
  animation: "", // of a glTF scene, that plays alone
  object: "", // of the scene, that moves in another way than the scene says
  path: "spin:45", // of that object, one of PATHS
  size: "160x120",
  rate: 200, // frames per second of stream time; 0: 100, with intervals that follow the motion
  duration: 0, // seconds of stream time; 0: until the page leaves. It has no control
  speed: 0.25, // stream seconds per second
  preset: "", // the sensor of a known camera, instead of C
  C: 0.2,
  bias: 0.001,
  look: 0, // 1: the camera is steered from the page, on a stream of its own
  walk: 1, // scene units a second of the wall clock, of a camera that is steered
  decay: 15, // ms of stream time; 0: events stay
  colours: "orange-blue",
};

export const SIZES = ["64x48", "128x96", "160x120", "240x180", "346x260", "640x480"];
export const RATES = [25, 50, 100, 200, 500, 1000, 2000];
export const SLOWEST = 1 / 256; // stream seconds per second, where the server lacks the CPU for more
// Of an object: as the scene says, not at all, or a kind of motion and its speed per second.
export const PATHS = ["own", "still", "spin:45", "spin:-45", "orbit:30", "slide:0.5", "swing:1"];
export const MOTIONS = ["pan", "tilt", "roll", "truck", "pedestal", "dolly", "orbit", "shake", "random", "roam"];

// The settings of a fragment such as #scene=cornell-box&C=0.1; what it leaves out, or says wrong, has its default.
export function fromFragment(fragment) {
  const settings = { ...DEFAULTS };
  for (const [key, text] of new URLSearchParams(fragment.replace(/^#/, ""))) {
    if (!(key in DEFAULTS)) continue;
    const value = typeof DEFAULTS[key] === "number" ? Number(text) : text;
    if (typeof value === "string" || (text !== "" && Number.isFinite(value))) settings[key] = value;
  }
  if (!/^\d{1,4}x\d{1,4}$/.test(settings.size)) settings.size = DEFAULTS.size;
  if (!PATHS.includes(settings.path) && !/^[a-z]+:-?[\d.]+$/.test(settings.path)) settings.path = DEFAULTS.path;
  return settings;
}

export function toFragment(settings) {
  const said = Object.entries(settings).filter(([key, value]) => key === "scene" || value !== DEFAULTS[key]);
  return "#" + new URLSearchParams(said.filter(([, value]) => value !== ""));
}

// Whether a SceneInfo of control.proto has objects that move by themselves.
export const moves = ({ objects = [] }) => objects.some(({ motion }) => motion);

// The settings of a page whose address names no scene: the first that moves by itself, else the first one.
export function withFirstScene(settings, scenes) {
  const { name = "" } = scenes.find(moves) ?? scenes[0] ?? {};
  return withScene({ ...settings, motion: settings.motion === DEFAULTS.motion ? "still" : settings.motion }, scenes, name);
}

// A camera that stands before what stands would see no events: it has the default motion.
export function withScene(settings, scenes, scene) {
  const { trajectories = [], objects = [], animations = [] } = scenes.find(({ name }) => name === scene) ?? {};
  const known = [...MOTIONS, ...trajectories].includes(settings.motion);
  const sees = settings.motion !== "still" || moves({ objects });
  return {
    ...settings,
    scene,
    motion: known && sees ? settings.motion : DEFAULTS.motion,
    animation: animations.includes(settings.animation) ? settings.animation : DEFAULTS.animation,
    object: objects.some(({ name }) => name === settings.object) ? settings.object : DEFAULTS.object,
  };
}

// An ObjectPath of control.proto.
function objectPathOf(path) {
  if (path === "own" || path === "still") return { [path]: {} };
  const [kind, speed] = path.split(":");
  return { motion: { kind: "OBJECT_MOTION_KIND_" + kind.toUpperCase(), speed: Number(speed) } };
}

// Of a Timing of control.proto. Motions in pixels per frame need a number of frames.
export const frameTimesOf = ({ rate }) => (rate === 0 ? { frameRateHz: 100, intervalPx: 1 } : { frameRateHz: rate });

// An OpenStream of control.proto.
export function openStreamOf(settings) {
  const [width, height] = settings.size.split("x").map(Number);
  const kind = "MOTION_KIND_" + settings.motion.toUpperCase();
  const trajectory = MOTIONS.includes(settings.motion)
    ? { motion: { kind, pxPerFrame: settings.px } }
    : { name: settings.motion };
  const threshold = settings.preset ? { preset: settings.preset } : { threshold: settings.C };
  return {
    scene: settings.scene,
    view: { width, height },
    trajectory,
    ...(settings.animation && { animation: settings.animation }),
    ...(settings.object && { objects: [{ name: settings.object, path: objectPathOf(settings.path) }] }),
    timing: { ...frameTimesOf(settings), durationS: settings.duration, clock: "CLOCK_PACED", speed: settings.speed,
      minSpeed: Math.min(SLOWEST, settings.speed), steerable: settings.look === 1 },
    sensors: [{ ...threshold, bias: settings.bias }],
    delivery: "DELIVERY_LIVE",
  };
}
