// The controls: shows settings, and tells when they change.
import { PALETTES } from "./palettes.js";
import { DEFAULTS, MOTIONS } from "./settings.js";

const SIZES = ["64x48", "128x96", "160x120", "240x180", "346x260", "640x480"];
const RATES = [25, 50, 100, 200, 500, 1000, 2000];
const KEEP = 7; // end of the slider of the decay: events stay

const places = (value, digits = 2) => String(Number(value.toPrecision(digits)));
// Sliders by name: position from value, value from position, text of the value.
const log = (text) => ({ at: Math.log, from: (at) => Number(Math.exp(at).toPrecision(3)), text });
const SLIDERS = {
  px: log((v) => `${places(v)} px/frame`),
  C: log((v) => places(v)),
  bias: log((v) => places(v)),
  speed: { at: Math.log2, from: (at) => 2 ** at, text: (v) => (v >= 1 ? "real time" : `1/${Math.round(1 / v)} of real time`) },
  decay: {
    at: (v) => (v === 0 ? KEEP : Math.log(v)),
    from: (at) => (at >= KEEP ? 0 : Number(Math.exp(at).toPrecision(2))),
    text: (v) => (v === 0 ? "none" : `${places(v)} ms`),
  },
};

const option = (value, label = value, title = "") => Object.assign(new Option(label, value), { title });

function group(label, options) {
  const made = Object.assign(document.createElement("optgroup"), { label });
  made.append(...options);
  return made;
}

export class Form {
  // `changed(settings)` is called after each change by hand.
  constructor(form, settings, changed) {
    Object.assign(this, { form, settings, scenes: [], running: [] });
    form.size.append(...SIZES.map((size) => option(size, size.replace("x", " × "))));
    form.rate.append(...RATES.map((rate) => option(rate, `${rate} Hz`)));
    form.colours.append(...Object.entries(PALETTES).map(([name, { label }]) => option(name, label)));
    form.addEventListener("input", ({ target }) => {
      this.read(target);
      this.show(this.settings);
      changed(this.settings);
    });
    form.addEventListener("submit", (event) => event.preventDefault());
  }

  read({ name, value }) {
    if (name === "source") return this.chooseSource(value);
    const number = SLIDERS[name]?.from(Number(value)) ?? (name === "rate" ? Number(value) : value);
    this.settings = { ...this.settings, [name]: number };
  }

  chooseSource(value) {
    const [kind, name] = [value.slice(0, value.indexOf(":")), value.slice(value.indexOf(":") + 1)];
    this.settings = { ...this.settings, stream: kind === "stream" ? name : "", scene: kind === "scene" ? name : this.settings.scene };
    if (!this.motions().includes(this.settings.motion)) this.settings.motion = DEFAULTS.motion;
  }

  motions() {
    const scene = this.scenes.find(({ name }) => name === this.settings.scene);
    return [...MOTIONS, ...(scene?.trajectories ?? [])];
  }

  // What the server offers: scenes, and running broadcasts.
  offer(scenes, running) {
    Object.assign(this, { scenes, running });
    const stands = ({ unavailable }) => !unavailable;
    const groups = [group("Scenes", scenes.filter(stands).map(({ name, description }) => option("scene:" + name, name, description)))];
    if (running.length > 0)
      groups.push(group("Running broadcasts", running.map(({ streamId, scene }) => option("stream:" + streamId, `${scene} · ${streamId.slice(0, 6)}`))));
    this.form.source.replaceChildren(...groups);
    if (!this.settings.scene && !this.settings.stream) this.settings.scene = scenes.find(stands)?.name ?? "";
    this.show(this.settings);
  }

  show(settings) {
    this.settings = settings;
    const { form } = this;
    form.source.value = settings.stream ? "stream:" + settings.stream : "scene:" + settings.scene;
    const named = this.motions().slice(MOTIONS.length).map((name) => option(name));
    form.motion.replaceChildren(group("At constant speed", MOTIONS.map((name) => option(name))), ...(named.length ? [group("Trajectories of the scene", named)] : []));
    form.motion.value = settings.motion;
    for (const name of ["size", "rate", "colours"]) form[name].value = settings[name];
    for (const [name, { at, text }] of Object.entries(SLIDERS)) {
      form[name].value = at(settings[name]);
      form[name].parentElement.querySelector("output").value = text(settings[name]);
    }
    form.px.parentElement.hidden = !MOTIONS.includes(settings.motion);
    for (const name of ["motion", "px", "C", "bias", "size", "rate", "speed"]) form[name].disabled = settings.stream !== "";
  }
}
