// Asks for pictures of the newest frame again and again, and shows them.
import { paintBrightness, paintChange, paintFrame } from "./pictures.js";

const PAUSE_MS = 250;

export class FramePictures {
  // `settings()` gives those that the pictures depend on.
  constructor(connection, watch, settings) {
    Object.assign(this, { connection, watch, settings, paused: false });
    this.run();
  }

  async run() {
    const { stream } = this.watch;
    if (stream?.token && !document.hidden && !this.paused) {
      // It fails where there is no frame yet, and where the stream has just been closed.
      await this.connection.call("getFrame", { streamId: stream.id, token: stream.token }).then(
        (frame) => this.show(frame),
        () => {},
      );
    }
    setTimeout(() => this.run(), PAUSE_MS);
  }

  show(frame) {
    const { bias, colours } = this.settings();
    paintFrame(document.getElementById("frame"), frame);
    paintBrightness(document.getElementById("brightness"), frame, bias);
    const full = paintChange(document.getElementById("change"), frame, colours);
    document.getElementById("change-scale").value = full > 1e-5 ? `± ${full.toPrecision(2)}` : "none";
  }
}
