// Events per second over stream time, with marks where packets were lost.

const BINS = 100;
const BIN_S = 0.1; // of the clock on the wall
const PACKET_NS = 5e6; // the longest packet

export class RateChart {
  constructor(canvas) {
    this.canvas = canvas;
    this.reset(1);
  }

  // `speed`: stream seconds per second.
  reset(speed) {
    this.binNs = Math.max(PACKET_NS, BIN_S * 1e9 * speed);
    this.bins = []; // {id, events, lost}
  }

  get seconds() {
    return BINS * this.binNs * 1e-9;
  }

  add({ t0Ns, count }, lost) {
    const id = Math.floor(t0Ns / this.binNs);
    if (this.bins.at(-1)?.id !== id) this.bins.push({ id, events: 0, lost: 0 });
    this.bins = this.bins.filter((bin) => bin.id > id - BINS && bin.id <= id);
    this.bins.at(-1).events += count;
    this.bins.at(-1).lost += lost;
  }

  // Returns the rate at the top of the chart, in events per second.
  draw() {
    const { canvas } = this;
    const context = canvas.getContext("2d");
    const style = getComputedStyle(canvas);
    [canvas.width, canvas.height] = [canvas.clientWidth, canvas.clientHeight].map((size) => size * devicePixelRatio);
    const complete = this.bins.slice(0, -1);
    const perS = 1e9 / this.binNs;
    const top = niceAbove(Math.max(...complete.map((bin) => bin.events), 1) * perS);
    const width = canvas.width / BINS;
    for (const { id, events, lost } of complete) {
      const height = ((events * perS) / top) * canvas.height;
      const left = Math.floor(canvas.width - (complete.at(-1).id - id + 1) * width);
      context.fillStyle = style.getPropertyValue("--ink-3");
      context.fillRect(left, canvas.height - height, Math.ceil(width), height);
      context.fillStyle = style.getPropertyValue("--bad");
      if (lost > 0) context.fillRect(left, 0, Math.ceil(width), canvas.height);
    }
    return top;
  }
}

// 1, 2 or 5 times a power of ten.
function niceAbove(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((step) => step * power >= value);
}
