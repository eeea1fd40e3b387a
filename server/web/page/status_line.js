// The line that says how the stream is.

const element = document.getElementById("state");

// `kind`: "live", "fault", or nothing.
export function say(text, kind = "") {
  if (element.textContent === text) return; // else a screen reader would say it for every packet
  element.textContent = text;
  element.className = kind;
}

// Such as a browser that cannot draw.
addEventListener("error", ({ message }) => say(message, "fault"));
