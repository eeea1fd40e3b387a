// Keeps the events that arrive from a press of Record until Stop, the end of the stream, or the bound.
import { columnsOf } from "./event_columns.js";

export const MOST_BYTES = 64 << 20; // of packets that are kept

export class Recorder {
  constructor() {
    this.running = false;
    this.clear();
  }

  clear() {
    Object.assign(this, { packets: [], bytes: 0, events: 0, lost: 0, due: null, width: 0, height: 0 });
  }

  start() {
    this.clear();
    this.running = true;
  }

  stop() {
    this.running = false;
  }

  // A packet of events. It must not be changed afterwards.
  add(packet) {
    if (!this.running) return;
    if (this.bytes + packet.payload.length > MOST_BYTES) return this.stop();
    this.lost += this.due === null ? 0 : packet.seq - this.due;
    this.due = packet.seq + 1;
    this.packets.push(packet);
    this.bytes += packet.payload.length;
    this.events += packet.count;
    [this.width, this.height] = [packet.width, packet.height];
  }

  get full() {
    return !this.running && this.bytes > 0.99 * MOST_BYTES;
  }

  // Stream time, in seconds: when the recording begins and ends.
  get span() {
    return this.packets.length ? [this.packets[0].t0Ns * 1e-9, this.packets.at(-1).t1Ns * 1e-9] : [0, 0];
  }

  // What a file holds: see columnsOf(), and the size of the picture.
  recording() {
    return { ...columnsOf(this.packets), width: this.width, height: this.height, beginUs: Math.floor(this.span[0] * 1e6) };
  }
}
