import { live } from './live.svelte';

/** Of what is asked, what more is known than what is now. */
interface Known {
  /** Whether it is known of what has been, too, in recordings and in runs that go on. */
  past?: boolean;
  /** Whether a run that is over goes on answering what it answered last. */
  atTheEnd?: boolean;
}

/**
 * Asks again and again while a component is there and the run goes on, each time a pause after the answer; of a run that
 * is over, once more, where that is known. It rests while the server is gone. To be called while the component is made.
 *
 * @param question its answer is null when there is none now
 * @param told is told each other answer
 */
export function keepAsking<T>(
  question: () => Promise<T | null>,
  pauseMillis: number,
  told: (answer: T) => void,
  { past = false, atTheEnd = false }: Known = {},
): void {
  $effect(() => {
    const over = live.over;
    void live.told; // what one run answers is nothing of another
    if (live.connection !== 'open' || (live.past ? !past : over && !atTheEnd)) {
      return;
    }
    return askAgain(question, pauseMillis, (answer) => {
      if (answer !== null) {
        told(answer);
      }
      return live.past || !over;
    });
  });
}

/**
 * Asks at once, and again and again, each time a pause after the answer, as an effect does: what the question reads
 * before it waits is what that depends on.
 *
 * @param told says after each answer whether to ask again
 * @returns ends it; what is answered afterwards counts no more
 */
export function askAgain<T>(
  question: () => Promise<T>,
  pauseMillis: number,
  told: (answer: T) => boolean,
): () => void {
  let timer: number | undefined;
  let left = false;
  async function ask() {
    const answer = await question();
    if (!left && told(answer)) {
      timer = window.setTimeout(() => void ask(), pauseMillis);
    }
  }
  void ask();
  return () => {
    left = true;
    clearTimeout(timer);
  };
}
