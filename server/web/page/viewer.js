// The page: connects the server, the pictures, the measures and the controls.
import { Connection } from "./connection.js";
import { DrawQueue } from "./draw_queue.js";
import { EventView } from "./event_view.js";
import { Form } from "./form.js";
import { FramePictures } from "./frame_pictures.js";
import { listen } from "./keyboard.js";
import { Meters } from "./meters.js";
import { EndReason, Kind, messageOf, readPacket } from "./packet.js";
import { PALETTES, coloursOf } from "./palettes.js";
import { RateChart } from "./rate_chart.js";
import { fromFragment, toFragment } from "./settings.js";
import { say } from "./status_line.js";
import { showMeasures, showRates, showRendering, showStream } from "./texts.js";
import { Watch } from "./watch.js";

const DEBOUNCE_MS = 250; // of sliders, before a stream is opened again
const MEASURE_MS = 500;
const LIST_MS = 3000; // between two looks at the streams of the server
const DRAWN = new Set(["colours", "decay"]); // settings that need no other stream

const element = (id) => document.getElementById(id);
const view = new EventView(element("events"));
const chart = new RateChart(element("rates"));
const meters = new Meters();
const queue = new DrawQueue((events) => meters.skipped(events));
const form = new Form(element("controls"), fromFragment(location.hash), change);
const connection = new Connection({ open: begin, closed: lost, packet: receive, refused: fault });
const watch = new Watch(connection, { opened, slowed });
const frames = new FramePictures(connection, watch, () => form.settings);
let paused = false;
let refused = false; // the newest request; packets of an older stream may still come
let asked = null; // settings of the newest request
let timer = 0;

async function begin() {
  say("Asking for scenes");
  try {
    const questions = ["listScenes", "listStreams", "serverInfo"].map((name) => connection.call(name));
    const [{ scenes }, { streams }, { presets }] = await Promise.all(questions);
    form.offerPresets(presets);
    form.offer(scenes, streams);
    await open();
  } catch (fault) {
    say(fault.message, "fault");
  }
}

function lost(reason) {
  watch.forget();
  say(reason.trim(), "fault");
}

function fault({ message }) {
  refused = true;
  say(message, "fault");
}

async function open() {
  asked = form.settings;
  refused = false;
  say(asked.stream ? "Waiting for the broadcast" : `Opening ${asked.scene}`);
  try {
    await watch.show({ ...asked });
  } catch (fault) {
    refused = true;
    say(fault.message, "fault");
  }
}

function opened(stream) {
  const speed = stream.resolved?.timing.speed ?? 1;
  queue.clear();
  meters.reset(speed);
  chart.reset(speed);
  element("pictures").classList.toggle("no-frames", !stream.token);
  showStream(stream);
}

function slowed(speed) {
  asked = { ...form.settings, speed };
  form.show(asked);
  share();
}

function change(settings) {
  share();
  applyDrawing();
  clearTimeout(timer);
  const needsStream = Object.keys(settings).some((key) => !DRAWN.has(key) && settings[key] !== asked?.[key]);
  if (needsStream) timer = setTimeout(open, DEBOUNCE_MS);
}

const share = () => history.replaceState(null, "", toFragment(form.settings));

function applyDrawing() {
  const { colours, decay } = form.settings;
  view.decayS = decay === 0 ? Infinity : decay * 1e-3;
  for (const name of ["on", "off"])
    element(`${name}-key`).style.background = `rgb(${coloursOf(colours)[name].map((channel) => 255 * channel)})`;
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
  if (packet.kind === Kind.END) return say(`The stream has ended: ${EndReason[packet.endReason]}.`);
  if (packet.kind === Kind.EVENTS) {
    chart.add(packet, meters.lost - lostBefore);
    queue.add(packet);
  }
  if (!refused) sayLive();
}

const sayLive = () => (paused ? say("Paused") : say("Live", "live"));

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

function measure() {
  showMeasures(meters, meters.read(performance.now()));
  showRates(chart.seconds, chart.draw());
}

async function list() {
  const { streams } = await connection.call("listStreams");
  form.offer(form.scenes, streams);
  showRendering(streams.find(({ streamId }) => streamId === watch.stream?.id));
}

function pause() {
  paused = frames.paused = !paused;
  element("pause").setAttribute("aria-pressed", paused);
  element("pause").textContent = paused ? "Go on" : "Pause";
  sayLive();
}

async function copyLink() {
  share();
  try {
    await navigator.clipboard.writeText(location.href);
    element("share").textContent = "Copied";
  } catch {
    element("share").textContent = "See the address"; // browsers copy on localhost and with TLS alone
  }
  setTimeout(() => (element("share").textContent = "Copy link"), 1500);
}

function nextColours() {
  const names = Object.keys(PALETTES);
  const colours = names[(names.indexOf(form.settings.colours) + 1) % names.length];
  form.show({ ...form.settings, colours });
  change(form.settings);
}

listen({ " ": pause, c: nextColours, l: copyLink });
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

globalThis.saccade = { view, meters, watch, form }; // for the console, and for tests
