// The WebSocket of the viewer: requests and their replies, and packets.

const RETRY_MS = 2000;

// A reply whose status is not CODE_OK.
export class Refused extends Error {
  constructor(status) {
    super(status.field ? `${status.field}: ${status.message}` : status.message);
    this.code = status.code;
    this.limit = status.limit;
    this.retryAfterS = status.retryAfterS ?? 0;
  }
}

export class Connection {
  // `on.open()`, `on.closed(reason)`, `on.refused(Refused)` of a message that is no call, and `on.packet(ArrayBuffer)` are
  // called as these things happen.
  constructor(on) {
    this.on = on;
    this.nextId = 1 + Math.floor(Math.random() * 2 ** 40); // list_streams tells the openings of all pages by these
    this.waiting = new Map(); // by request id
    this.connect();
  }

  connect() {
    const url = new URL("viewer", location.href);
    url.protocol = url.protocol.replace("http", "ws");
    this.socket = new WebSocket(url);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => this.on.open();
    this.socket.onmessage = ({ data }) => (typeof data === "string" ? this.answer(JSON.parse(data)) : this.on.packet(data));
    this.socket.onclose = ({ reason }) => this.lost(reason);
  }

  async lost(reason) {
    for (const { reject } of this.waiting.values()) reject(new Error("the connection is lost"));
    this.waiting.clear();
    this.on.closed(reason || (await this.reason()));
    setTimeout(() => this.connect(), RETRY_MS);
  }

  // A browser does not tell why a WebSocket was refused, but the same address as a page does.
  async reason() {
    try {
      const answer = await fetch("viewer");
      return answer.status === 503 ? await answer.text() : "The connection was lost.";
    } catch {
      return "No server answers.";
    }
  }

  answer(reply) {
    const waiting = this.waiting.get(reply.requestId);
    this.waiting.delete(reply.requestId);
    if (!waiting) return reply.requestId === "0" && this.on.refused(new Refused(reply.status));
    if (reply.status.code === "CODE_OK") waiting.resolve(reply[waiting.call]);
    else waiting.reject(new Refused(reply.status));
  }

  // The result of a call of control.proto, such as call("openStream", {...}). The promise has the requestId.
  call(call, argument = {}) {
    const requestId = String(this.nextId++);
    const reply = new Promise((resolve, reject) => this.waiting.set(requestId, { call, resolve, reject }));
    this.send({ request: { requestId, protocolVersion: 1, [call]: argument } });
    return Object.assign(reply, { requestId });
  }

  // A ViewerMessage of viewer.proto.
  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }
}
