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
