// Counts what has come, what is lost, and how late it is.
import { Kind } from "./packet.js";

const WINDOW_MS = 2000; // of rates
const BEST_MS = 10000; // of the earliest packet, to which delays refer

export class Meters {
  constructor() {
    this.reset();
  }

  // `refractory`: whether the sensor has a refractory period, so that withheld events are normal.
  reset(speed = 1, refractory = false) {
    Object.assign(this, { speed, refractory, lost: 0, notDrawn: 0, withheld: 0, events: 0, streamS: 0, lagMs: 0, due: null });
    this.recent = []; // {at, events, ns, delay} of packets; ns of stream time
    this.offsets = []; // {at, ms}: arrival against stream time
    this.frames = []; // times of drawn pictures
  }

  // A packet that arrives `at`, in ms. The delay is against the earliest packet lately: how much later this one came.
  take(packet, at) {
    if (packet.kind !== Kind.HEARTBEAT) this.count(packet);
    this.lagMs = packet.lagMs;
    const ms = at - (packet.t1Ns * 1e-6) / this.speed;
    this.offsets = this.offsets.filter((o) => o.at > at - BEST_MS && o.ms < ms).concat({ at, ms });
    this.recent.push({ at, events: packet.count, ns: packet.t1Ns - packet.t0Ns, delay: ms - this.offsets[0].ms });
  }

  // A gap of seq holds the packets that the server says it dropped.
  count(packet) {
    if (this.due !== null) this.lost += packet.seq - this.due;
    this.due = packet.seq + 1;
    this.withheld += packet.suppressed;
    this.streamS = packet.t1Ns * 1e-9;
    this.events += packet.count;
  }

  drawn(at) {
    this.frames.push(at);
  }

  skipped(events) {
    this.notDrawn += events;
  }

  // Lately: events per second of stream time and of the clock on the wall, mean delay, pictures per second.
  read(now) {
    const lately = ({ at }) => at > now - WINDOW_MS;
    this.recent = this.recent.filter(lately);
    this.frames = this.frames.filter((at) => at > now - WINDOW_MS);
    const sum = (key) => this.recent.reduce((total, packet) => total + packet[key], 0);
    return {
      rate: sum("ns") > 0 ? sum("events") / (sum("ns") * 1e-9) : null,
      received: (sum("events") * 1000) / WINDOW_MS,
      delayMs: this.recent.length ? sum("delay") / this.recent.length : null,
      pictures: (this.frames.length * 1000) / WINDOW_MS,
    };
  }
}
