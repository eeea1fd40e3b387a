// HDF5 as the DSEC data set has it, without compression: /events/x, y, p, t, width, height, /ms_to_idx and /t_offset.
// An event is at t + t_offset microseconds. Entry m of ms_to_idx is the number of events before millisecond m of t.
import { H5File } from "./h5_objects.js";

export function h5File({ count, t, x, y, p, width, height, beginUs }) {
  const offset = 1000 * Math.floor(Math.min(beginUs, count ? t[0] : beginUs) / 1000);
  const times = Uint32Array.from(t, (time) => time - offset);
  const file = new H5File();
  const events = file.group({ x: file.array(x), y: file.array(y), p: file.array(p), t: file.array(times),
    width: file.number(width), height: file.number(height) });
  const root = file.group({ events, ms_to_idx: file.array(indexOf(times)), t_offset: file.number(offset) },
    { width, height });
  return file.parts(root);
}

function indexOf(times) {
  const index = new BigUint64Array(times.length ? Math.floor(times.at(-1) / 1000) + 2 : 1);
  let ms = 0;
  times.forEach((time, i) => {
    while (1000 * ms <= time) index[ms++] = BigInt(i);
  });
  index.fill(BigInt(times.length), ms);
  return index;
}
