// The files that the page writes, as `saccade` names and reads them. Each writer takes a recording of recorder.js and
// returns the parts of a Blob.
import { h5File } from "./h5_file.js";
import { npzFile } from "./npz_file.js";
import { rawFile } from "./raw_file.js";

const ROWS = 1 << 16; // that become one text

function csvFile({ count, t, x, y, p }) {
  const parts = ["t,x,y,p\n"];
  for (let begin = 0; begin < count; begin += ROWS) {
    let text = "";
    for (let i = begin; i < Math.min(count, begin + ROWS); ++i) text += `${t[i]},${x[i]},${y[i]},${p[i]}\n`;
    parts.push(text);
  }
  return parts;
}

export const FILE_FORMATS = { csv: csvFile, npz: npzFile, raw: rawFile, h5: h5File };
