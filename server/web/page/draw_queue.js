// Packets that wait to be drawn. The newest win: what would take the page too long to draw is skipped.

const MAX_EVENTS = 1_500_000; // that wait, where a page is hidden
const MIN_BUDGET = 20_000; // events of one picture
const SLOW_MS = 50; // between two pictures; beyond, the next one gets fewer events

export class DrawQueue {
  // `skipped(events)` is called for each packet that is not drawn.
  constructor(skipped) {
    this.skipped = skipped;
    this.budget = MAX_EVENTS;
    this.last = null; // time of the last picture, in ms
    this.clear();
  }

  clear() {
    this.packets = [];
    this.events = 0;
  }

  add(packet) {
    this.packets.push(packet);
    this.events += packet.count;
    this.skipBeyond(MAX_EVENTS);
  }

  // The packets of the picture at `now`, in ms. The newest one is always among them.
  take(now) {
    const slow = this.last !== null && now - this.last > SLOW_MS;
    this.last = now;
    if (slow) this.budget = Math.max(MIN_BUDGET, Math.min(this.budget, this.events) * 0.7);
    else if (this.events > this.budget / 2) this.budget = Math.min(MAX_EVENTS, this.budget * 1.05);
    this.skipBeyond(this.budget);
    const { packets } = this;
    this.clear();
    return packets;
  }

  skipBeyond(events) {
    while (this.events > events && this.packets.length > 1) {
      const { count } = this.packets.shift();
      this.events -= count;
      this.skipped(count);
    }
  }
}
