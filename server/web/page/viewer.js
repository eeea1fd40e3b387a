// The page: connects the server, the pictures, the measures and the controls.
import { Connection } from "./connection.js";
import { DrawQueue } from "./draw_queue.js";
import { EventView } from "./event_view.js";
import { Form } from "./form.js";
import { Meters } from "./meters.js";
import { EndReason, Kind, messageOf, readPacket } from "./packet.js";
import { PALETTES, coloursOf } from "./palettes.js";
import { paintBrightness, paintChange } from "./pictures.js";
import { RateChart } from "./rate_chart.js";
import { fromFragment, toFragment } from "./settings.js";
import { amount, showMeasures, showStream } from "./texts.js";
import { Watch } from "./watch.js";

const DEBOUNCE_MS = 250; // of sliders, before a stream is opened again
const PICTURE_MS = 250; // between two pictures of the newest frame
const MEASURE_MS = 500;
const LIST_MS = 3000; // between two looks at the streams of the server
const DRAWN = new Set(["colours", "decay"]); // settings that need no other stream

const element = (id) => document.getElementById(id);
const view = new EventView(element("events"));
const chart = new RateChart(element("rates"));
const meters = new Meters();
const queue = new DrawQueue((events) => meters.skipped(events));
const form = new Form(element("controls"), fromFragment(location.hash), change);
const connection = new Connection({ open: begin, closed: lost, packet: receive });
const watch = new Watch(connection, { opened, slowed });
let paused = false;
let shown = null; // settings of the stream
let timer = 0;

function say(text, kind = "") {
  const state = element("state");
  if (state.textContent === text) return; // else a screen reader would say it for every packet
  state.textContent = text;
  state.className = kind;
}

async function begin() {
  say("Asking for scenes");
  await look();
  await open();
}

function lost(reason) {
  watch.forget();
  say(reason.trim(), "fault");
}

async function look() {
  try {
    const [{ scenes }, { streams }] = await Promise.all([connection.call("listScenes"), connection.call("listStreams")]);
    form.offer(scenes, streams.filter(({ delivery }) => delivery === "DELIVERY_BROADCAST"));
  } catch (fault) {
    say(fault.message, "fault");
  }
}

async function open() {
  shown = form.settings;
  say(shown.stream ? "Waiting for the broadcast" : `Opening ${shown.scene}`);
  try {
    await watch.show({ ...shown });
  } catch (fault) {
    say(fault.message, "fault");
  }
}

function opened(stream) {
  queue.clear();
  const speed = stream.resolved?.timing.speed ?? 1;
  meters.reset(speed);
  chart.reset(speed);
  element("pictures").classList.toggle("token-only", !stream.token);
  if (stream.resolved) view.resize(stream.resolved.view.width, stream.resolved.view.height);
  showStream(stream);
}

function slowed(speed) {
  form.show({ ...form.settings, speed });
  shown = form.settings;
  share();
}

const needsStream = (settings) => Object.keys(settings).some((key) => !DRAWN.has(key) && settings[key] !== shown?.[key]);

function change(settings) {
  share();
  applyDrawing();
  clearTimeout(timer);
  if (needsStream(settings)) timer = setTimeout(open, DEBOUNCE_MS);
}

const share = () => history.replaceState(null, "", toFragment(form.settings));

function applyDrawing() {
  const { colours, decay } = form.settings;
  view.decayS = decay === 0 ? Infinity : decay * 1e-3;
  for (const [id, name] of [["on-key", "on"], ["off-key", "off"]])
    element(id).style.background = `rgb(${coloursOf(colours)[name].map((channel) => 255 * channel)})`;
}

function receive(buffer) {
  try {
    const packet = readPacket(buffer);
    if (packet.streamId === watch.stream?.id) take(packet);
  } catch (fault) {
    say(`A packet cannot be read: ${fault.message}.`, "fault");
  }
}

function take(packet) {
  if (packet.kind === Kind.ERROR) return say(messageOf(packet), "fault");
  const lostBefore = meters.lost;
  meters.take(packet, performance.now());
  if (packet.kind === Kind.EVENTS) chart.add(packet, meters.lost - lostBefore);
  if (packet.kind === Kind.END) return say(`The stream has ended: ${EndReason[packet.endReason]}.`);
  if (packet.kind === Kind.EVENTS) queue.add(packet);
  say(paused ? "Paused" : "Live", paused ? "" : "live");
}

function draw(now) {
  const packets = queue.take(now);
  if (packets.length > 0 && !paused) {
    view.resize(packets[0].width, packets[0].height);
    view.add(packets);
    meters.drawn(now);
  }
  view.show(coloursOf(form.settings.colours));
  requestAnimationFrame(draw);
}

async function picture() {
  const { stream } = watch;
  if (stream?.token && !document.hidden && !paused) {
    try {
      const frame = await connection.call("getFrame", { streamId: stream.id, token: stream.token });
      paintBrightness(element("brightness"), frame, shown.bias);
      const full = paintChange(element("change"), frame, form.settings.colours);
      element("change-scale").value = `± ${full.toPrecision(2)}`;
    } catch {
      // There is no frame yet, or the stream has just been closed.
    }
  }
  setTimeout(picture, PICTURE_MS);
}

function measure() {
  showMeasures(meters, meters.read(performance.now()));
  element("rate-span").value = `${Number(chart.seconds.toPrecision(2))} s of the stream`;
  element("rate-top").value = `${amount(chart.draw())}/s at the top`;
}

async function list() {
  const { streams } = await connection.call("listStreams");
  const own = streams.find(({ streamId }) => streamId === watch.stream?.id);
  if (own) element("m-cpu").textContent = `${own.frameCpuMs.toFixed(1)} ms`;
}

function pause() {
  paused = !paused;
  element("pause").setAttribute("aria-pressed", paused);
  element("pause").textContent = paused ? "Go on" : "Pause";
  say(paused ? "Paused" : "Live", paused ? "" : "live");
}

async function copyLink() {
  share();
  await navigator.clipboard?.writeText(location.href);
  element("share").textContent = "Copied";
  setTimeout(() => (element("share").textContent = "Copy link"), 1500);
}

function nextColours() {
  const names = Object.keys(PALETTES);
  const colours = names[(names.indexOf(form.settings.colours) + 1) % names.length];
  form.show({ ...form.settings, colours });
  change(form.settings);
}

const KEYS = { " ": pause, c: nextColours, l: copyLink };
addEventListener("keydown", (event) => {
  const typing = event.target.closest("select, button") || event.ctrlKey || event.metaKey || event.altKey;
  if (!KEYS[event.key] || typing) return;
  event.preventDefault();
  KEYS[event.key]();
});
element("pause").addEventListener("click", pause);
element("share").addEventListener("click", copyLink);
addEventListener("hashchange", () => {
  form.show(fromFragment(location.hash));
  change(form.settings);
});

applyDrawing();
requestAnimationFrame(draw);
setInterval(measure, MEASURE_MS);
setInterval(() => list().catch(() => {}), LIST_MS);
picture();

// For the console, and for tests.
globalThis.saccade = { view, meters, watch, form };
