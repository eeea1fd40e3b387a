// The page: connects the server, the pictures, the measures and the controls.
import { copy } from "./clipboard.js";
import { Connection } from "./connection.js";
import { DrawQueue } from "./draw_queue.js";
import { enlargeOnClick, toggleFullScreen } from "./enlarge.js";
import { EventView } from "./event_view.js";
import { Form } from "./form.js";
import { FramePictures } from "./frame_pictures.js";
import { Intake } from "./intake.js";
import { listen } from "./keyboard.js";
import { LookRound } from "./look_round.js";
import { Meters } from "./meters.js";
import { NoticeLine, noticeOf } from "./notice.js";
import { PALETTES, coloursOf } from "./palettes.js";
import { RateChart } from "./rate_chart.js";
import { recordLineOf } from "./record_line.js";
import { RecordPanel } from "./record_panel.js";
import { Recorder } from "./recorder.js";
import { fromFragment, toFragment } from "./settings.js";
import { say } from "./status_line.js";
import { openingText, showMeasures, showRates, showRendering, showStream } from "./texts.js";
import { Watch } from "./watch.js";

const DEBOUNCE_MS = 250; // of sliders, before a stream is opened again
const MEASURE_MS = 500;
const LIST_MS = 3000; // between two looks at the streams of the server
const DRAWN = new Set(["colours", "decay", "walk"]); // settings that need no other stream

const element = (id) => document.getElementById(id);
const view = new EventView(element("events"));
const chart = new RateChart(element("rates"));
const meters = new Meters();
const queue = new DrawQueue((events) => meters.skipped(events));
const form = new Form(element("controls"), fromFragment(location.hash), change);
const connection = new Connection({ open: begin, closed: lost, packet: (buffer) => intake.receive(buffer), refused: fault });
const watch = new Watch(connection, { opened, waits: (...what) => say(openingText(...what)), full });
const frames = new FramePictures(connection, watch, () => form.settings);
const recorder = new Recorder();
const intake = new Intake({ watch, meters, chart, queue, recorder }, () => refused || sayLive());
const panel = new RecordPanel(recorder, () => `${form.settings.scene || "broadcast"}-${form.settings.size}`);
const notice = new NoticeLine((settings) => take(settings));
const look = new LookRound(connection, element("pictures"), steered);
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
  recorder.stop();
  say(reason.trim(), "fault");
}

function fault({ message }) {
  refused = true;
  say(message, "fault");
}

function full({ message, retryAfterS }) {
  say(`${message}; the page asks again in ${retryAfterS.toFixed(1)} s`);
}

async function open() {
  asked = form.settings;
  refused = true; // until it is open, packets are the old stream's
  say(asked.stream ? "Waiting for the broadcast" : openingText(asked.scene, null, 0));
  element("pictures").classList.add("old");
  try {
    await watch.show({ ...asked });
  } catch (fault) {
    say(fault.message, "fault");
  }
}

function opened(stream) {
  const { timing, sensors } = stream.resolved ?? {};
  refused = false;
  recorder.stop();
  queue.clear();
  meters.reset(timing?.speed, sensors?.[0].refractoryS > 0);
  chart.reset(timing?.speed ?? 1);
  element("pictures").classList.remove("old");
  element("pictures").classList.toggle("no-frames", !stream.token);
  element("pictures").classList.toggle("steered", Boolean(timing?.steerable));
  showStream(stream);
}

// The stream that the page steers.
function steered() {
  const { stream } = watch;
  const timing = stream?.resolved?.timing;
  return timing?.steerable ? { ...stream, walk: form.settings.walk, speed: timing.speed, rate: timing.frameRateHz } : null;
}

// Takes settings that do not come from the form.
function take(settings) {
  form.show({ ...form.settings, ...settings });
  change(form.settings);
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
  const { colours, decay, look, stream } = form.settings;
  view.decayS = decay === 0 ? Infinity : decay * 1e-3;
  for (const name of ["on", "off"])
    element(`${name}-key`).style.background = `rgb(${coloursOf(colours)[name].map((channel) => 255 * channel)})`;
  element("look").setAttribute("aria-pressed", look === 1);
  element("look-hint").hidden = look === 0;
  element("look").disabled = stream !== "";
  element("line").disabled = stream !== "" || look === 1; // no command goes where the camera was steered
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
  notice.show(noticeOf(form.settings, watch.stream?.resolved?.timing.speed ?? null, meters.lagMs));
  panel.show();
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

function copyLink() {
  share();
  return copy(element("share"), location.href);
}

const copyLine = () => copy(element("line"), recordLineOf(form.settings, meters.streamS));

function nextColours() {
  const names = Object.keys(PALETTES);
  take({ colours: names[(names.indexOf(form.settings.colours) + 1) % names.length] });
}

const toggleLook = () => take({ look: 1 - form.settings.look });

listen({ " ": pause, c: nextColours, l: copyLink, f: toggleFullScreen, r: () => panel.toggle() });
for (const [id, act] of Object.entries({ pause, share: copyLink, line: copyLine, full: toggleFullScreen, look: toggleLook }))
  element(id).addEventListener("click", act);
enlargeOnClick(element("pictures"), () => !steered());
addEventListener("hashchange", () => take(fromFragment(location.hash)));
applyDrawing();
requestAnimationFrame(draw);
setInterval(measure, MEASURE_MS);
setInterval(() => list().catch(() => {}), LIST_MS);

globalThis.saccade = { view, meters, watch, form, recorder, look }; // for the console, and for tests
