// Prints what h5wasm finds in a file of events, as JSON: node read_h5.mjs MODULE_OF_H5WASM FILE
import { pathToFileURL } from "node:url";

const [module, path] = process.argv.slice(2);
const h5wasm = (await import(pathToFileURL(module).href)).default;
await h5wasm.ready;
const file = new h5wasm.File(path, "r");
const found = { width: Number(file.attrs.width.value), height: Number(file.attrs.height.value) };
for (const name of ["t", "x", "y", "p"]) found[name] = Array.from(file.get("events/" + name).value);
found.ms_to_idx = Array.from(file.get("ms_to_idx").value, Number);
console.log(JSON.stringify(found));
