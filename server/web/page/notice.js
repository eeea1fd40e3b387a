// What the page says about a stream that cannot keep the pace, and the setting that would.
import { RATES, SIZES } from "./settings.js";
import { SLIDERS } from "./sliders.js";

const pixels = (size) => size.split("x").reduce((product, side) => product * Number(side), 1);

// The setting that takes so small a share of the CPU: a smaller picture, else a lower frame rate. Null: there is none.
export function lighterSetting({ size, rate }, share) {
  const smaller = SIZES.findLast((other) => pixels(other) <= share * pixels(size));
  if (smaller) return { size: smaller };
  const slower = RATES.findLast((other) => other <= share * rate);
  return slower ? { rate: slower } : null;
}

// {text, offer, label}: `offer` are settings, or null. Null: there is nothing to say.
export function noticeOf(settings, taken, lagMs) {
  if (lagMs > 0) {
    return { text: `The stream is ${(lagMs / 1000).toFixed(1)} s behind its clock: its frames now take longer than measured.`,
      ...offered({ speed: taken / 2 }) };
  }
  if (taken === null || taken >= settings.speed) return null;
  const text = `Playback is ${SLIDERS.speed.text(taken)}: the server leaves CPU time for others, or they watch this at that ` +
    "speed.";
  return { text, ...offered(lighterSetting(settings, taken / settings.speed)) };
}

function offered(offer) {
  if (!offer) return { offer: null, label: "" };
  const { size, rate, speed } = offer;
  const label = size ? size.replace("x", " × ") : rate ? `${rate} frames/s` : SLIDERS.speed.text(speed);
  return { offer, label: `Use ${label}` };
}

// Shows a notice; `take(settings)` is called where its button is pressed.
export class NoticeLine {
  constructor(take) {
    this.line = document.getElementById("notice");
    this.text = document.getElementById("notice-text");
    this.button = document.getElementById("notice-offer");
    this.button.addEventListener("click", () => take(this.offer));
  }

  show(notice) {
    this.line.hidden = notice === null;
    if (!notice) return;
    this.offer = notice.offer;
    if (this.text.textContent !== notice.text) this.text.textContent = notice.text;
    this.button.textContent = notice.label;
    this.button.hidden = !notice.offer;
  }
}
