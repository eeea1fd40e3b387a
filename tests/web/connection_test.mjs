// What the page says of its WebSocket, which stands for itself here.
import assert from "node:assert";
import { test } from "node:test";
import { Connection } from "../../server/web/page/connection.js";

globalThis.location = { href: "http://127.0.0.1:5773/" };
globalThis.fetch = async () => ({ status: 426 });
globalThis.setTimeout = () => {}; // it does not connect again

// What the page is told, and the socket that tells it.
function open() {
  let socket;
  globalThis.WebSocket = class {
    constructor() {
      socket = this;
    }
  };
  const told = [];
  const tell = (what) => (value) => told.push([what, value?.message ?? value]);
  new Connection({ open: tell("open"), closed: tell("closed"), packet: tell("packet"), refused: tell("refused") });
  return { socket, told };
}

test("the reason for which the server closes is told", async () => {
  const { socket, told } = open();
  await socket.onclose({ reason: "the server stops" });
  assert.deepStrictEqual(told, [["closed", "the server stops"]]);
});

test("an end without a reason is told", async () => {
  const { socket, told } = open();
  await socket.onclose({ reason: "" });
  await new Promise(setImmediate);
  assert.deepStrictEqual(told, [["closed", "The connection was lost."]]);
});

test("a refusal of what is no call is told", () => {
  const { socket, told } = open();
  socket.onmessage({ data: JSON.stringify({ requestId: "0", status: { code: "CODE_RESOURCE_EXHAUSTED", message: "too many" } }) });
  assert.deepStrictEqual(told, [["refused", "too many"]]);
});
