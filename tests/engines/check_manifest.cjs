// Checks objects of Kubernetes against the schemas of its API: check_manifest.cjs, with an array of objects as JSON on its
// standard input. Prints the faults, one a line. The schemas allow unknown keys, which a server refuses: a key that no
// schema has read is unknown.
const path = require("path");

// The package exports its classes alone, whose constructors would read all keys.
const schemas = path.join(path.dirname(require.resolve("kubernetes-models/batch/v1")), "../../_schemas");
const { validate: job } = require(path.join(schemas, "IoK8sApiBatchV1Job.js"));

const VALIDATORS = { "batch/v1 Job": job };

// The value, with all objects in it noting in `unread` which of their keys nobody has read.
function watched(value, at, unread) {
  if (value === null || typeof value !== "object") return value;
  const inner = Array.isArray(value) ? [] : {};
  for (const [key, item] of Object.entries(value)) {
    inner[key] = watched(item, `${at}/${key}`, unread);
    if (!Array.isArray(value)) unread.add(`${at}/${key}`);
  }
  return new Proxy(inner, {
    get(target, key) {
      unread.delete(`${at}/${String(key)}`);
      return target[key];
    },
  });
}

function faultsOf(object) {
  const kind = `${object.apiVersion} ${object.kind}`;
  const validate = VALIDATORS[kind];
  if (!validate) return [`${kind} is unknown`];
  const unread = new Set();
  validate(watched(object, "", unread));
  const faults = (validate.errors || []).map((fault) => `${fault.instancePath} ${fault.message || JSON.stringify(fault)}`);
  return [...faults, ...[...unread].map((at) => `${at} is unknown`)];
}

const objects = JSON.parse(require("fs").readFileSync(0, "utf8"));
process.stdout.write(objects.flatMap(faultsOf).map((fault) => fault + "\n").join(""));
