// The controls of the recorder: Record, what is kept, and the files.
import { FILE_FORMATS } from "./file_formats.js";
import { MOST_BYTES } from "./recorder.js";
import { amount } from "./texts.js";

const MIB = 1 << 20;

// The browser saves the parts as a file.
function download(name, parts) {
  const url = URL.createObjectURL(new Blob(parts));
  Object.assign(document.createElement("a"), { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);
}

export class RecordPanel {
  // `nameOf()`: of the files, without their ending.
  constructor(recorder, nameOf) {
    Object.assign(this, { recorder, nameOf });
    this.button = document.getElementById("record");
    this.text = document.getElementById("recorded");
    this.files = document.getElementById("files");
    for (const ending of Object.keys(FILE_FORMATS)) {
      const save = Object.assign(document.createElement("button"), { type: "button", textContent: `.${ending}` });
      save.addEventListener("click", () => this.save(ending));
      this.files.append(save);
    }
    this.button.addEventListener("click", () => this.toggle());
    this.show();
  }

  toggle() {
    if (this.recorder.running) this.recorder.stop();
    else this.recorder.start();
    this.show();
  }

  save(ending) {
    download(`${this.nameOf()}.${ending}`, FILE_FORMATS[ending](this.recorder.recording()));
  }

  show() {
    const { running, events, bytes, lost, span, full } = this.recorder;
    this.button.textContent = running ? "Stop" : "Record";
    this.button.setAttribute("aria-pressed", running);
    this.files.hidden = running || events === 0;
    const kept = `${amount(events)} events, ${(bytes / MIB).toFixed(1)} of ${MOST_BYTES / MIB} MiB, stream time ${span
      .map((time) => time.toFixed(2)).join(" to ")} s`;
    const gap = lost > 0 ? `; ${lost} packets are lost` : "";
    this.text.textContent = running || events > 0 ? kept + gap + (full ? "; the page keeps no more" : "") : "";
  }
}
