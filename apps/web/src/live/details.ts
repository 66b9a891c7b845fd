import type { Details } from '../api/messages';

/** All that is known after some news: entries that did not change stay the same objects. */
export function merged(before: Details | null, news: Details): Details {
  if (news.whole || before === null) return news;
  return {
    ...news,
    whole: true,
    robots: replaced(before.robots, news.robots, ({ id }) => id),
    agents: replaced(before.agents, news.agents, ({ name }) => name),
  };
}

function replaced<T>(all: T[], some: T[], name: (each: T) => string): T[] {
  if (some.length === 0) return all;
  const news = new Map(some.map((each) => [name(each), each]));
  const kept = all.map((each) => {
    const other = news.get(name(each));
    news.delete(name(each));
    return other ?? each;
  });
  return kept.concat(...news.values());
}
