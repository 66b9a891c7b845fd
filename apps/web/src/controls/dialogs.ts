/** Opens one to read in. It has the focus itself, and no button in it, so that Space stays the emergency stop. */
export function openToRead(dialog: HTMLDialogElement) {
  dialog.tabIndex = -1;
  dialog.showModal();
  dialog.focus();
}

/**
 * For the window's keys as they are captured: Esc, wherever the focus is, and before it means anything else. A dialog
 * that is open has it for itself.
 */
export function onEscape(action: () => void): (event: KeyboardEvent) => void {
  return (event) => {
    if (event.key === 'Escape' && !document.querySelector('dialog[open]')) {
      action();
      event.stopPropagation();
    }
  };
}

/**
 * Keeps a popover over all else, or hides it. A dialog keeps from fingers and readers what is outside of it: so the
 * popover is in the newest that is open, and leaves it before it closes.
 *
 * @returns ends it
 */
export function keepOver(popover: HTMLElement, shown: boolean): () => void {
  const show = () => {
    if (popover.matches(':popover-open')) {
      popover.hidePopover();
    }
    const place = [...document.querySelectorAll('dialog[open]')].at(-1) ?? document.body;
    if (popover.parentNode !== place) {
      place.append(popover);
    }
    if (shown) {
      popover.showPopover();
    }
  };
  const follow = ({ target }: Event) => {
    if (target instanceof HTMLDialogElement) {
      show();
    }
  };
  show();
  const ended = new AbortController();
  for (const kind of ['toggle', 'close']) {
    document.addEventListener(kind, follow, { capture: true, signal: ended.signal });
  }
  return () => ended.abort();
}
