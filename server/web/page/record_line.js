// The `saccade record` line that gives the events of the page.
import { MOTIONS, frameTimesOf } from "./settings.js";

const quoted = (text) => (/^[\w.:,/-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

// `seconds`: how long the recording is, where the settings say no duration. The page's events of these first seconds of
// the stream are those of the file: neither the clock, the playback nor the delivery changes an event.
export function recordLineOf(settings, seconds) {
  const { frameRateHz, intervalPx } = frameTimesOf(settings);
  const duration = settings.duration || Math.max(1, Math.ceil(seconds * frameRateHz - 1e-6)) / frameRateHz; // whole frames
  const motion = MOTIONS.includes(settings.motion) ? `${settings.motion}:${settings.px}px` : settings.motion;
  const sensor = settings.preset ? ["--preset", settings.preset] : ["--threshold", settings.C];
  const animation = settings.animation ? ["--animation", settings.animation] : [];
  const rate = intervalPx ? "--min-rate" : "--rate"; // the former has intervals of 1 px
  const object = settings.object ? ["--object", `${settings.object}=${settings.path}`] : [];
  const words = ["saccade", "record", settings.scene, "--motion", motion, ...animation, ...object, "--size", settings.size,
    rate, frameRateHz, "--duration", Number(duration.toFixed(6)), ...sensor, "--bias", settings.bias,
    "-o", "events.h5"];
  return words.map((word) => quoted(String(word))).join(" ");
}
