// The sliders by name: position from value, value from position, text of the value. Most are logarithmic.

const KEEP = 7; // end of the slider of the decay: events stay

const places = (value) => String(Number(value.toPrecision(2)));
const log = (text) => ({ at: Math.log, from: (at) => Number(Math.exp(at).toPrecision(3)), text });

export const SLIDERS = {
  px: log((value) => `${places(value)} px/frame`),
  walk: log((value) => `${places(value)} units/s`),
  C: log(places),
  bias: log(places),
  speed: {
    at: Math.log2,
    from: (at) => 2 ** at,
    text: (value) => (value >= 1 ? "real time" : `1/${Math.round(1 / value)} of real time`),
  },
  decay: {
    at: (value) => (value === 0 ? KEEP : Math.log(value)),
    from: (at) => (at >= KEEP ? 0 : Number(Math.exp(at).toPrecision(2))),
    text: (value) => (value === 0 ? "none" : `${places(value)} ms`),
  },
};
