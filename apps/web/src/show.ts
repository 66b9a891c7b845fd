import { mount, type Component } from 'svelte';
import Refused from './Refused.svelte';
import { enter } from './api/enter';

/** Shows a page, or why it can't be shown. */
export async function show(page: Component) {
  const target = document.getElementById('app')!;
  const refused = location.protocol === 'https:' ? await enter() : null;
  if (refused === null) {
    mount(page, { target });
  } else {
    mount(Refused, { target, props: { why: refused } });
  }
}
