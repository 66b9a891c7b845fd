/**
 * Whoever uses a button or a list by a pointer does not mean it to take the keys from then on: Space is the emergency
 * stop. The focus goes before the click is heard, so that a dialog that it opens gives none back. In dialogs, those that
 * one reads in have it then; forms keep it where it is.
 *
 * @returns ends it
 */
export function keepKeysFree(): () => void {
  let pointed = false;
  const ended = new AbortController();
  const options = { capture: true, signal: ended.signal };
  window.addEventListener('pointerdown', () => (pointed = true), options);
  window.addEventListener('keydown', () => (pointed = false), options);
  const letGo = () => {
    const focused = document.activeElement;
    if (pointed && focused instanceof HTMLElement && focused.matches('button, summary, a, select')) {
      const dialog = focused.closest('dialog');
      if (dialog === null) {
        focused.blur();
      } else if (dialog.tabIndex === -1) {
        dialog.focus();
      }
    }
  };
  window.addEventListener('click', letGo, options);
  window.addEventListener('change', letGo, options);
  return () => ended.abort();
}
