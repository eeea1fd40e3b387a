// The newest frame as a camera has it, its brightness as the sensor sees it, and its change since the frame before. They
// are made of the planes of get_frame.
import { coloursOf } from "./palettes.js";

// Scales are set by all but this share of the pixels.
const OUTLIERS = 0.01;

function floatsOf(base64) {
  const text = atob(base64);
  return new Float32Array(Uint8Array.from(text, (c) => c.charCodeAt(0)).buffer);
}

// The value below which a share of the numbers lies, from a sample of them.
function quantile(values, share) {
  const step = Math.max(1, Math.floor(values.length / 2000));
  const sample = values.filter((_, i) => i % step === 0).sort();
  return sample[Math.min(sample.length - 1, Math.floor(share * sample.length))];
}

function paint(canvas, width, height, values, colour) {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  values.forEach((value, i) => {
    const [r, g, b] = colour(value);
    image.data.set([255 * r, 255 * g, 255 * b, 255], 4 * i);
  });
  context.putImageData(image, 0, 0);
}

// sRGB of the linear luminance. White is the brightest of most pixels, as by a camera's automatic exposure.
export function paintFrame(canvas, picture) {
  const luminance = floatsOf(picture.intensity);
  const scale = 1 / Math.max(quantile(luminance, 1 - OUTLIERS), 1e-9);
  paint(canvas, picture.width, picture.height, luminance, (value) => {
    const share = Math.min(1, Math.max(0, value * scale));
    const grey = share <= 0.0031308 ? 12.92 * share : 1.055 * share ** (1 / 2.4) - 0.055; // IEC 61966-2-1
    return [grey, grey, grey];
  });
}

// Grey by log(bias + I), as the sensor sees it.
export function paintBrightness(canvas, picture, bias) {
  const logs = floatsOf(picture.intensity).map((luminance) => Math.log(bias + luminance));
  const [low, high] = [quantile(logs, OUTLIERS), quantile(logs, 1 - OUTLIERS)];
  const scale = 1 / Math.max(high - low, 1e-6);
  paint(canvas, picture.width, picture.height, logs, (value) => {
    const grey = Math.min(1, Math.max(0, (value - low) * scale));
    return [grey, grey, grey];
  });
}

// Towards the colours of ON and OFF. Returns the change of full colour, in natural log units.
export function paintChange(canvas, picture, palette) {
  const change = floatsOf(picture.brightnessChange);
  const full = Math.max(quantile(change.map(Math.abs), 1 - OUTLIERS), 1e-6);
  const { none, on, off } = coloursOf(palette);
  paint(canvas, picture.width, picture.height, change, (value) => {
    const share = Math.min(1, Math.abs(value) / full);
    const hue = value > 0 ? on : off;
    return none.map((channel, i) => channel + share * (hue[i] - channel));
  });
  return full;
}
