/** Whether this page is one of several side by side: what they share is around it, in the page that shows them. */
export const framed = window.parent !== window;

/** Goes to the page that shows all runs side by side. */
export function goBeside(): void {
  location.assign('/beside.html');
}
