package rsal.engine.event;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.agent.Message;
import rsal.agent.protocol.Act;
import rsal.engine.report.SpeechAct;
import rsal.engine.report.Words;

/// What agents have said lately in conversations, for people to read. Words are made only for those who ask.
public final class ConversationLog {
    /// How many acts of one agent and its partners are kept.
    static final int MOST = 100;

    /// How many agents' words are kept: acts may be for names that nobody has.
    private static final int MOST_AGENTS = 4_000;

    private final RunClock clock;
    private final Map<String, Deque<Line>> byAgent = new LinkedHashMap<>(16, 0.75f, true) { // by who spoke last
                @Override
                protected boolean removeEldestEntry(Map.Entry<String, Deque<Line>> eldest) {
                    return size() > MOST_AGENTS;
                }
            };

    private static final class Line {
        private final Message<?> message;
        private final Act act;
        private int times = 1;

        Line(Message<?> message, Act act) {
            this.message = message;
            this.act = act;
        }

        boolean isSame(Act other) {
            return act.number() == other.number()
                    && act.from() == other.from()
                    && act.conversation().equals(other.conversation());
        }
    }

    public ConversationLog(RunClock clock) {
        this.clock = clock;
    }

    /// Something is said for the first time.
    public void said(Message<?> message, Act act) {
        var line = new Line(message, act);
        keep(message.sender(), line);
        if (!message.to().equals(message.sender())) {
            keep(message.to(), line);
        }
    }

    private void keep(String agent, Line line) {
        Deque<Line> lines = byAgent.computeIfAbsent(agent, _ -> new ArrayDeque<>());
        lines.addLast(line);
        if (lines.size() > MOST) {
            lines.removeFirst();
        }
    }

    /// Something is said again.
    public void repeated(Message<?> message, Act act) {
        Iterator<Line> newestFirst =
                byAgent.getOrDefault(message.sender(), new ArrayDeque<>()).descendingIterator();
        while (newestFirst.hasNext()) {
            Line line = newestFirst.next();
            if (line.isSame(act) && line.message.to().equals(message.to())) {
                line.times++;
                return;
            }
        }
    }

    /// What an agent and its partners said, oldest first.
    public List<SpeechAct> of(String agent) {
        return byAgent.getOrDefault(agent, new ArrayDeque<>()).stream()
                .map(this::spoken)
                .toList();
    }

    private SpeechAct spoken(Line line) {
        Message<?> message = line.message;
        return new SpeechAct(
                clock.at(message.time()),
                message.sender(),
                message.to(),
                line.act.conversation(),
                line.act.protocol(),
                line.act.performative().toString(),
                Words.about(line.act),
                line.times);
    }
}
