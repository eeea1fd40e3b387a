// The controls: shows settings, and tells when they change.
import { PALETTES } from "./palettes.js";
import { MOTIONS, PATHS, RATES, SIZES, moves, withFirstScene, withScene } from "./settings.js";
import { SLIDERS } from "./sliders.js";

const OF_OWN_STREAM = ["motion", "px", "animation", "object", "path", "preset", "C", "bias", "size", "rate", "speed"]; // a broadcast of others has its own

const option = (value, label = value, title = "") => Object.assign(new Option(label, value), { title });

function group(label, options) {
  const made = Object.assign(document.createElement("optgroup"), { label });
  made.append(...options);
  return made;
}

const sceneLabel = (scene) => (moves(scene) ? `${scene.name} (moves)` : scene.name);

export class Form {
  // `changed(settings)` is called after each change by hand.
  constructor(form, settings, changed) {
    Object.assign(this, { form, settings, scenes: [], broadcasts: null });
    form.size.append(...SIZES.map((size) => option(size, size.replace("x", " × "))));
    form.rate.append(option(0, "follows the motion"), ...RATES.map((rate) => option(rate, `${rate} Hz`)));
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
    const setting = SLIDERS[name]?.from(Number(value)) ?? (name === "rate" ? Number(value) : value);
    this.settings = { ...this.settings, [name]: setting };
  }

  chooseSource(source) {
    const at = source.indexOf(":");
    const name = source.slice(at + 1);
    const { settings } = this;
    this.settings = source.startsWith("stream:")
      ? { ...settings, stream: name }
      : withScene({ ...settings, stream: "" }, this.scenes, name);
  }

  scene() {
    return this.scenes.find(({ name }) => name === this.settings.scene);
  }

  trajectories() {
    return this.scene()?.trajectories ?? [];
  }

  objects() {
    return this.scene()?.objects ?? [];
  }

  animations() {
    return this.scene()?.animations ?? [];
  }

  // Scenes and streams of the server: those that can be watched are offered.
  offer(scenes, streams) {
    const broadcasts = streams.filter(({ delivery }) => delivery === "DELIVERY_BROADCAST");
    const ids = broadcasts.map(({ streamId }) => streamId).join();
    if (this.scenes === scenes && this.broadcasts === ids) return;
    Object.assign(this, { scenes, broadcasts: ids });
    const ready = scenes.filter(({ unavailable }) => !unavailable);
    const running = broadcasts.map(({ streamId, scene }) => option("stream:" + streamId, `${scene} · ${streamId.slice(0, 6)}`));
    this.form.source.replaceChildren(
      group("Scenes", ready.map((scene) => option("scene:" + scene.name, sceneLabel(scene), scene.description))),
      ...(running.length > 0 ? [group("Running broadcasts", running)] : []),
    );
    if (!this.settings.scene && !this.settings.stream) this.settings = withFirstScene(this.settings, ready);
    this.show(this.settings);
  }

  // The sensors of known cameras that the server has.
  offerPresets(presets) {
    const cameras = presets.map(({ name, description }) => option(name, name, description));
    this.form.preset.replaceChildren(option("", "none"), ...cameras);
    this.show(this.settings);
  }

  show(settings) {
    this.settings = settings;
    const { form } = this;
    form.source.value = settings.stream ? "stream:" + settings.stream : "scene:" + settings.scene;
    this.showMotions();
    this.showAnimations();
    this.showObjects();
    for (const name of ["preset", "size", "rate", "colours"]) form[name].value = settings[name];
    for (const [name, { at, text }] of Object.entries(SLIDERS)) {
      form[name].value = at(settings[name]);
      form[name].parentElement.querySelector("output").value = text(settings[name]);
    }
    form.C.parentElement.hidden = settings.preset !== "";
    for (const name of OF_OWN_STREAM) form[name].disabled = settings.stream !== "";
  }

  showAnimations() {
    const { form, settings } = this;
    const names = this.animations();
    form.animation.replaceChildren(option("", "as the scene says"), ...names.map((name) => option(name)));
    form.animation.value = settings.animation;
    form.animation.parentElement.hidden = names.length === 0;
  }

  showObjects() {
    const { form, settings } = this;
    const moves = ({ name, motion }) => option(name, motion ? `${name} (${motion})` : name);
    form.object.replaceChildren(option("", "as the scene says"), ...this.objects().map(moves));
    form.object.value = settings.object;
    const named = PATHS.includes(settings.path) ? PATHS : [...PATHS, settings.path];
    const own = this.objects().some(({ name, motion }) => name === settings.object && motion);
    form.path.replaceChildren(...named.filter((path) => path !== "own" || own).map((path) => option(path)));
    form.path.value = settings.path;
    form.path.parentElement.hidden = settings.object === "";
  }

  showMotions() {
    const { form, settings } = this;
    const named = this.trajectories().filter((name) => !MOTIONS.includes(name)).map((name) => option(name));
    form.motion.replaceChildren(
      group("At constant speed", MOTIONS.map((name) => option(name))),
      ...(named.length > 0 ? [group("Trajectories of the scene", named)] : []),
    );
    form.motion.value = settings.motion;
    form.px.parentElement.hidden = settings.look === 1 || !MOTIONS.includes(settings.motion);
    form.motion.parentElement.hidden = settings.look === 1;
    form.walk.parentElement.hidden = settings.look === 0;
  }
}
