// EVT2 in a RAW file of Prophesee: a word of 32 bits per event, and TIME_HIGH when the time above its lower 6 bits
// changes. client/formats/evt/evt2_writer.cpp writes the same.

const [OFF, ON, TIME_HIGH] = [0x0, 0x1, 0x8]; // types, in the upper 4 bits
const MASK = 2 ** 28 - 1; // of TIME_HIGH, which wraps

const header = ({ width, height }) =>
  `% camera_integrator_name Prophesee\n% evt 2.0\n% format EVT2;height=${height};width=${width}\n` +
  `% geometry ${width}x${height}\n% integrator_name Prophesee\n% plugin_integrator_name Prophesee\n` +
  "% plugin_name hal_plugin_prophesee\n% serial_number simulated\n% simulator Saccade\n% end\n";

const timeHigh = (high) => ((TIME_HIGH << 28) | (high % (MASK + 1))) >>> 0;

export function rawFile(recording) {
  const { count, t, x, y, p } = recording;
  const words = [timeHigh(0)];
  let last = 0;
  for (let i = 0; i < count; ++i) {
    const high = Math.floor(t[i] / 64);
    for (let wrap = Math.floor(last / (MASK + 1)); wrap < Math.floor(high / (MASK + 1)); ++wrap)
      words.push(timeHigh(MASK), timeHigh(0));
    if (high > last) words.push(timeHigh((last = high)));
    words.push((((p[i] ? ON : OFF) << 28) | ((t[i] % 64) << 22) | (x[i] << 11) | y[i]) >>> 0);
  }
  return [header(recording), new Uint32Array(words)];
}
