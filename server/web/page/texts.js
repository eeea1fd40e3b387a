// The numbers of the page, as people read them.

const element = (id) => document.getElementById(id);

// Three digits and a prefix: 1.23 M.
export function amount(value) {
  const [scale, prefix] = value >= 1e6 ? [1e6, " M"] : value >= 1e3 ? [1e3, " k"] : [1, ""];
  const shown = value / scale;
  return shown.toFixed(shown >= 100 || scale === 1 ? 0 : shown >= 10 ? 1 : 2) + prefix;
}

function setLoss(id, value, bad = value > 0) {
  element(id).textContent = amount(value);
  element(id).classList.toggle("bad", bad);
}

export function showMeasures(meters, { rate, received, delayMs, pictures }) {
  element("m-rate").textContent = rate === null ? "–" : `${amount(rate)}/s`;
  element("m-received").textContent = `${amount(received)}/s`;
  element("m-delay").textContent = delayMs === null ? "–" : `${delayMs.toFixed(0)} ms`;
  element("m-lag").textContent = `${(meters.lagMs / 1000).toFixed(1)} s`;
  element("m-lag").classList.toggle("bad", meters.lagMs > 0);
  setLoss("m-lost", meters.lost);
  setLoss("m-skipped", meters.notDrawn);
  setLoss("m-withheld", meters.withheld, meters.withheld > 0 && !meters.refractory);
  element("m-drawn").textContent = `${pictures.toFixed(0)} /s`;
}

// What an open_stream waits for, as list_streams tells it; undefined: nothing is known.
export function openingText(scene, opening, seconds) {
  const done = opening?.done > 0 ? ` (${Math.round(100 * opening.done)} %)` : "";
  return `Opening ${scene}: ${opening ? opening.doing + done : "asking"}, ${seconds.toFixed(1)} s`;
}

export function showRates(seconds, top) {
  element("rate-span").value = `${Number(seconds.toPrecision(2))} s of the stream`;
  element("rate-top").value = `${amount(top)}/s at the top`;
}

// What list_streams says of the stream; undefined: nothing.
export function showRendering(info) {
  element("m-cpu").textContent = info ? `${info.frameCpuMs.toFixed(1)} ms` : "–";
}

// One line about the stream.
export function showStream({ id, resolved, opened }) {
  if (!resolved) return void (element("about").textContent = `broadcast ${id}`);
  const { view, timing, method } = resolved;
  const follows = timing.intervalPx > 0;
  const px = opened.pxPerFrameP50 * (follows ? timing.frameRateHz : 1);
  const rate = follows ? `${timing.intervalPx} px/interval` : `${timing.frameRateHz} frames/s`;
  const motion = px > 0 ? `${px.toPrecision(2)} px/${follows ? "s" : "frame"}` : "still";
  const parts = [resolved.scene, `${view.width} × ${view.height}`, rate, motion, method.name];
  element("about").textContent = parts.join(" · ");
}
