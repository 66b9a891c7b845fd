import { live } from './live.svelte';

/**
 * Asks again and again while a component is there and the run goes on, each time a pause after the answer. To be called
 * while the component is made.
 *
 * @param question its answer is null when there is none now
 * @param told is told each other answer
 * @param recorded whether recordings answer it, too; what is now answers nothing about what has been
 */
export function keepAsking<T>(
  question: () => Promise<T | null>,
  pauseMillis: number,
  told: (answer: T) => void,
  recorded = false,
): void {
  $effect(() => {
    if (live.past ? !(recorded && live.recording) : live.over) {
      return;
    }
    let timer: number | undefined;
    let left = false;
    async function ask() {
      const answer = await question();
      if (left) {
        return;
      }
      if (answer !== null) {
        told(answer);
      }
      timer = window.setTimeout(() => void ask(), pauseMillis);
    }
    void ask();
    return () => {
      left = true;
      clearTimeout(timer);
    };
  });
}
