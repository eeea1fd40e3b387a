// Shortcuts of one key, where no control takes it.

// `actions`: functions by key.
export function listen(actions) {
  addEventListener("keydown", (event) => {
    const taken = event.target.closest("select, button") || event.ctrlKey || event.metaKey || event.altKey;
    if (!actions[event.key] || taken) return;
    event.preventDefault();
    actions[event.key]();
  });
}
