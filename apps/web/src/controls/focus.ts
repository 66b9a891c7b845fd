/**
 * Whoever uses a button or a list by a pointer does not mean it to take the keys from then on: Space is the emergency
 * stop. The focus goes before the click is heard, so that a dialog that it opens gives none back. In dialogs, those that
 * one reads in have it then; forms keep it where it is.
 *
 * A list keeps it until something is chosen, as browsers close lists that lose it. Its `data-pointed` says meanwhile that
 * Space is not for it.
 *
 * @returns ends it
 */
export function keepKeysFree(): () => void {
  let pointed = false;
  const ended = new AbortController();
  const options = { capture: true, signal: ended.signal };
  const isFree = (element: Element) => (element.closest('dialog')?.tabIndex ?? -1) === -1;
  window.addEventListener(
    'pointerdown',
    ({ target }) => {
      pointed = true;
      if (target instanceof HTMLSelectElement && isFree(target)) {
        target.dataset.pointed = 'true';
      }
    },
    options,
  );
  window.addEventListener(
    'focusout',
    ({ target }) => {
      if (target instanceof HTMLSelectElement) {
        delete target.dataset.pointed;
      }
    },
    options,
  );
  window.addEventListener('keydown', () => (pointed = false), options);
  const letGo = (elements: string) => {
    const focused = document.activeElement;
    if (pointed && focused instanceof HTMLElement && focused.matches(elements)) {
      const dialog = focused.closest('dialog');
      if (dialog === null) {
        focused.blur();
      } else if (dialog.tabIndex === -1) {
        dialog.focus();
      }
    }
  };
  window.addEventListener('click', () => letGo('button, summary, a'), options);
  window.addEventListener('change', () => letGo('select'), options);
  return () => ended.abort();
}
