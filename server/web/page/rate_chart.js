// Events per second over the last ten seconds, with marks where packets were lost.

const BINS = 100;
const BIN_MS = 100;

export class RateChart {
  constructor(canvas) {
    this.canvas = canvas;
    this.bins = [];
  }

  add(events, lost, now) {
    const id = Math.floor(now / BIN_MS);
    this.bins = this.bins.filter((bin) => bin.id > id - BINS);
    if (this.bins.at(-1)?.id !== id) this.bins.push({ id, events: 0, lost: 0 });
    this.bins.at(-1).events += events;
    this.bins.at(-1).lost += lost;
  }

  // Returns the rate at the top of the chart, in events per second.
  draw(now) {
    const { canvas } = this;
    const context = canvas.getContext("2d");
    const style = getComputedStyle(canvas);
    [canvas.width, canvas.height] = [canvas.clientWidth, canvas.clientHeight].map((size) => size * devicePixelRatio);
    const top = niceAbove(Math.max(...this.bins.map((bin) => bin.events), 1) * (1000 / BIN_MS));
    const width = canvas.width / (BINS - 1);
    const newest = Math.floor(now / BIN_MS) - 1; // the present one is not complete
    for (const { id, events, lost } of this.bins.filter((bin) => bin.id <= newest)) {
      const height = ((events * (1000 / BIN_MS)) / top) * canvas.height;
      const left = Math.floor(canvas.width - (newest - id + 1) * width);
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
