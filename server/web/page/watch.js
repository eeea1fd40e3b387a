// Keeps one stream open for the newest settings. A change of the sensor joins the running feed before the old stream is
// closed, so that no picture is missing. Other changes close the old stream first, because two feeds may not fit.
import { openStreamOf } from "./settings.js";

const PROGRESS_MS = 400; // between two looks at what an opening waits for

const feedOf = (request) => JSON.stringify({ ...request, sensors: [] });

export class Watch {
  // `on.opened(stream)`: its packets follow. `on.waits(scene, opening, seconds)`: see openingText(). `on.full(Refused)`: the
  // server has no room now, and is asked again.
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

  // Asks again while other clients take what it needs.
  async open(request, turn) {
    while (turn === this.turn) {
      const reply = this.connection.call("openStream", request);
      this.opening = reply.requestId;
      const began = performance.now();
      const watching = setInterval(() => this.progress(request.scene, reply.requestId, began), PROGRESS_MS);
      try {
        return await reply;
      } catch (fault) {
        if (turn !== this.turn) return null;
        if (!(fault.retryAfterS > 0)) throw fault;
        this.on.full(fault);
        await new Promise((resume) => setTimeout(resume, 1000 * fault.retryAfterS));
      } finally {
        clearInterval(watching);
        if (this.opening === reply.requestId) this.opening = null;
      }
    }
    return null;
  }

  async progress(scene, requestId, began) {
    const { opening } = await this.connection.call("listStreams").catch(() => ({ opening: [] }));
    if (this.opening !== requestId) return;
    this.on.waits(scene, opening.find((one) => one.requestId === requestId), (performance.now() - began) / 1000);
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
