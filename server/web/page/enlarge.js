// Pictures that a click makes large, and the whole on the full screen.

// A click, or Enter, on a picture makes it the large one; another makes it small again. `may()`: whether clicks do so.
export function enlargeOnClick(pictures, may) {
  for (const figure of pictures.querySelectorAll("figure")) {
    const canvas = figure.querySelector("canvas");
    canvas.tabIndex = 0;
    canvas.addEventListener("click", () => may() && toggle(pictures, figure));
    canvas.addEventListener("keydown", ({ key }) => key === "Enter" && toggle(pictures, figure));
  }
}

function toggle(pictures, figure) {
  const large = !figure.classList.contains("large");
  for (const other of pictures.querySelectorAll("figure")) other.classList.toggle("large", large && other === figure);
  pictures.classList.toggle("one-large", large);
}

// Throws nothing: a browser may refuse, as on some phones.
export function toggleFullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.().catch(() => {});
}
