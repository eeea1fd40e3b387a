// Keeps one stream open for the newest settings. A change of the sensor joins the running feed before the old stream is
// closed, so that no picture is missing. Other changes close the old stream first, because two feeds may not fit.
import { openStreamOf } from "./settings.js";

const SLOWEST = 1 / 256; // stream seconds per second; below, the server's refusal stands

const feedOf = (request) => JSON.stringify({ ...request, sensors: [] });

export class Watch {
  // `on.opened(stream)`: its packets follow. `on.slowed(speed)`: the server has no time for more.
  constructor(connection, on) {
    this.connection = connection;
    this.on = on;
    this.stream = null; // id, and token and resolved if it is our own
    this.turn = 0; // counts calls of show(); an older one gives way
  }

  // Throws Refused if the server refuses.
  async show(settings) {
    const turn = ++this.turn;
    this.cancel();
    if (settings.stream) return this.subscribe(settings);
    const request = openStreamOf(settings);
    if (this.stream?.feed !== feedOf(request)) this.close();
    const opened = await this.open(request, turn);
    if (!opened) return;
    const stream = { id: opened.streamId, token: opened.token, resolved: opened.resolved, opened, feed: feedOf(request) };
    if (turn !== this.turn) return this.drop(stream);
    this.connection.send({ attach: { streamId: stream.id, token: stream.token } });
    this.close();
    this.stream = stream;
    this.on.opened(stream);
  }

  // Tries again at half the speed while the server lacks the time.
  async open(request, turn) {
    while (turn === this.turn) {
      const reply = this.connection.call("openStream", request);
      this.opening = reply.requestId;
      try {
        return await reply;
      } catch (fault) {
        if (turn !== this.turn) return null;
        if (fault.limit !== "cpu" || request.timing.speed / 2 < SLOWEST) throw fault;
        request.timing.speed /= 2;
        this.on.slowed(request.timing.speed);
      } finally {
        if (this.opening === reply.requestId) this.opening = null;
      }
    }
    return null;
  }

  subscribe({ stream, sensor }) {
    this.close();
    this.connection.send({ subscribe: { streamId: stream, sensor } });
    this.stream = { id: stream };
    this.on.opened(this.stream);
  }

  cancel() {
    if (this.opening) this.connection.call("cancelOpen", { requestId: this.opening }).catch(() => {});
    this.opening = null;
  }

  close() {
    if (this.stream) this.drop(this.stream);
    this.stream = null;
  }

  drop({ id, token }) {
    if (token) this.connection.call("closeStream", { streamId: id, token }).catch(() => {});
  }

  // The connection is lost, and with it the stream.
  forget() {
    this.stream = this.opening = null;
    ++this.turn;
  }
}
