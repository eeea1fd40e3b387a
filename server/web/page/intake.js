// Gives the packets of the watched stream to those who count, draw and keep them.
import { EndReason, Kind, messageOf, readPacket } from "./packet.js";
import { say } from "./status_line.js";

export class Intake {
  // `parts`: watch, meters, chart, queue, recorder. `live()` is called for each packet of a stream that goes on.
  constructor(parts, live) {
    Object.assign(this, parts, { live });
  }

  receive(buffer) {
    try {
      const packet = readPacket(buffer);
      if (packet.streamId === this.watch.stream?.id) this.take(packet);
    } catch (fault) {
      say(`A packet cannot be read: ${fault.message}.`, "fault");
    }
  }

  take(packet) {
    if (packet.kind === Kind.ERROR) return say(messageOf(packet), "fault");
    const lostBefore = this.meters.lost;
    this.meters.take(packet, performance.now());
    if (packet.kind === Kind.END) return this.end(packet);
    if (packet.kind === Kind.EVENTS) {
      this.chart.add(packet, this.meters.lost - lostBefore);
      this.queue.add(packet);
      this.recorder.add(packet);
    }
    this.live();
  }

  end({ endReason }) {
    this.recorder.stop();
    say(`The stream has ended: ${EndReason[endReason]}.`);
  }
}
