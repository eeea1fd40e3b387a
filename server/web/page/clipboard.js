// Copies a text; the button says so for a while. Browsers copy on localhost and with TLS alone: else a dialog shows it.
export async function copy(button, text) {
  const label = (button.dataset.label ??= button.textContent);
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = "Copied";
    setTimeout(() => (button.textContent = label), 1500);
  } catch {
    prompt("To copy:", text);
  }
}
