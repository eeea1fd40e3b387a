// Colours of ON and OFF events that people with any kind of colour vision can tell apart.

const hex = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255);
const palette = (none, on, off) => ({ none: hex(none), on: hex(on), off: hex(off) });

// By name: what to show on a dark and on a light page.
export const PALETTES = {
  "orange-blue": { label: "Orange and blue", dark: palette("#0b0d10", "#ffb14a", "#4fa3ff"), light: palette("#ffffff", "#d55e00", "#0072b2") },
  "yellow-violet": { label: "Yellow and violet", dark: palette("#0b0d10", "#ffe14d", "#a56bff"), light: palette("#ffffff", "#c99700", "#5b2a86") },
  "white-black": { label: "White and black", dark: palette("#5a5e64", "#ffffff", "#000000"), light: palette("#a9adb3", "#ffffff", "#000000") },
};

const dark = matchMedia("(prefers-color-scheme: dark)");
export const coloursOf = (name) => PALETTES[name][dark.matches ? "dark" : "light"];
