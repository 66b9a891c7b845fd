package rsal.python;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SequencedMap;
import org.jspecify.annotations.Nullable;
import rsal.frame.ToWords;

/// The turns of agents in Python: what has happened to them goes there, and what they ask for is done.
///
/// In simulated time, events of one instant are gathered, and go to Python in one frame. Ten agents then need a tenth
/// of the frames, and of the times that one process waits for the other. What an agent asks for is done on its own
/// lane. What agents hear of each other by that is gathered for the next round, which goes to Python when this one is
/// over.
///
/// On the thread that exchanges frames.
final class PythonTurns {
    private final PythonProcess process;
    private final Map<Integer, Life> lives = new HashMap<>(); // by number of the agent
    private final SequencedMap<Integer, List<Event>> gathered = new LinkedHashMap<>(); // for the next round
    private final Deque<Integer> round = new ArrayDeque<>(); // agents whose turns are not over, in order
    private final Map<Integer, Map<?, ?>> over = new HashMap<>(); // what Python has said at the ends of turns
    private final List<Integer> ended = new ArrayList<>(); // agents of whose ends Python does not know
    private @Nullable Map<?, ?> question; // which Python waits for

    /// What Python asks for in an agent's turn.
    interface Peer {
        /// Does what needs no answer.
        ///
        /// @param asked verbs with their arguments, in order
        void perform(List<?> asked);

        /// @return what Python gets as an answer
        /// @throws RuntimeException what Python gets as an error of its own
        @Nullable
        Object answer(List<?> asked);
    }

    /// What an agent hears under a number.
    private record Event(int id, Optional<Object> value) {}

    /// What has happened to an agent.
    private record Turn(int agent, List<Event> events) {}

    /// An agent that has not ended.
    private static final class Life {
        private final Peer peer;
        private @Nullable RuntimeException refused; // of a turn that was over before its agent was asked

        Life(Peer peer) {
            this.peer = peer;
        }
    }

    PythonTurns(PythonProcess process) {
        this.process = process;
    }

    /// The first turn of an agent.
    ///
    /// @param words by which it starts
    void start(int agent, Instant now, Map<String, Object> words, Peer peer) {
        lives.put(agent, new Life(peer));
        exchange(agent, now, words);
    }

    /// The last turn of an agent, unless it has ended.
    ///
    /// @param peer which does what it asks for now
    void stop(int agent, Instant now, Peer peer) {
        if (lives.containsKey(agent)) {
            lives.put(agent, new Life(peer));
            exchange(agent, now, Map.of("agent", agent, "stop", true));
        }
    }

    /// An agent has ended. What Python still asks for in its name is not done.
    void end(int agent) {
        if (lives.remove(agent) != null) {
            gathered.remove(agent);
            ended.add(agent);
        }
    }

    /// An agent has ended, and Python learns that now. It may be gone itself.
    void endNow(int agent, Instant now) {
        end(agent);
        if (!ended.isEmpty()) {
            try {
                write(now, List.of());
                process.read();
            } catch (PythonFailure _) {
                ended.clear(); // other agents learn that at their next turns
            }
        }
    }

    /// A turn at once.
    void hear(int agent, Instant now, int id, Optional<Object> value) {
        if (lives.containsKey(agent)) {
            exchange(agent, now, new Turn(agent, List.of(new Event(id, value))));
        }
    }

    /// Something has happened to an agent: it takes a turn for it at this instant.
    ///
    /// @return whether it has to [#take] one more turn than was known before
    boolean gather(int agent, int id, Optional<Object> value) {
        List<Event> known = gathered.get(agent);
        if (known != null) {
            known.add(new Event(id, value));
            return false;
        }
        var events = new ArrayList<Event>(2);
        events.add(new Event(id, value));
        gathered.put(agent, events);
        return true;
    }

    /// Does what an agent asks for in its turn, on its lane.
    ///
    /// @return false when others have their turns first: it has to come again
    /// @throws RuntimeException by which the agent ends
    boolean take(int agent, Instant now) {
        RuntimeException refused = Objects.requireNonNull(lives.get(agent)).refused;
        if (refused != null) {
            throw refused;
        }
        settleEnded();
        if (!round.contains(agent)) {
            if (!gathered.containsKey(agent)) {
                return true; // that turn is over
            }
            if (!round.isEmpty()) {
                return false;
            }
            send(now);
        }
        if (round.getFirst() != agent) {
            return false;
        }
        finish(agent);
        return true;
    }

    private void send(Instant now) {
        var turns = new ArrayList<Turn>(gathered.size());
        gathered.forEach((agent, events) -> turns.add(new Turn(agent, events)));
        round.addAll(gathered.keySet());
        gathered.clear();
        try {
            write(now, turns);
        } catch (RuntimeException e) {
            for (int agent : round) { // none of them hears what has happened
                Optional.ofNullable(lives.get(agent)).ifPresent(life -> life.refused = e);
            }
            round.clear();
            throw e;
        }
    }

    private void write(Instant now, List<?> turns) {
        var left = List.copyOf(ended);
        ended.clear();
        process.write(
                to -> to.put("time", ToWords.seconds(now)).put("ended", left).put("turns", turns));
    }

    /// Turns of agents that have ended meanwhile, before those of others.
    private void settleEnded() {
        while (!round.isEmpty() && !lives.containsKey(round.getFirst())) {
            finish(round.getFirst());
        }
    }

    /// After the turns of the round that is on its way, whose agents learn later what was refused.
    private void exchange(int agent, Instant now, Object turn) {
        while (!round.isEmpty()) {
            Life other = lives.get(round.getFirst());
            try {
                finish(round.getFirst());
            } catch (RuntimeException e) {
                if (other != null) {
                    other.refused = e;
                }
            }
        }
        write(now, List.of(turn));
        round.add(agent);
        finish(agent);
    }

    /// The turn of the first agent of the round, to its end.
    private void finish(int agent) {
        Life life = lives.get(agent);
        try {
            RuntimeException refused = life == null ? new IllegalStateException("The agent has ended.") : null;
            for (Map<?, ?> said = next(agent); ; said = next(agent)) {
                try {
                    if (life != null && refused == null) {
                        life.peer.perform(FromWords.list(said.get("do")));
                    }
                } catch (RuntimeException e) {
                    refused = e;
                }
                if (said.get("ask") instanceof List<?> asked) {
                    question = null;
                    answer(asked, refused, life);
                } else if (life == null) {
                    return;
                } else if (refused != null) {
                    throw refused;
                } else if (said.get("failed") instanceof Map<?, ?> failure) {
                    throw PythonFailure.of(failure);
                } else {
                    return;
                }
            }
        } finally {
            round.remove(agent);
            over.remove(agent);
        }
    }

    /// What Python says next for the first agent of the round.
    private Map<?, ?> next(int agent) {
        while (question == null && !over.containsKey(agent)) {
            Map<?, ?> frame = process.read();
            for (Object each : FromWords.list(frame.get("turns"))) {
                Map<?, ?> turn = (Map<?, ?>) each;
                over.put(FromWords.integer(turn.get("agent")), turn);
            }
            question = frame.containsKey("ask") ? frame : null;
        }
        Map<?, ?> turn = over.get(agent);
        return turn == null ? Objects.requireNonNull(question) : turn;
    }

    private void answer(List<?> asked, @Nullable RuntimeException refused, @Nullable Life life) {
        Object value = null;
        RuntimeException why = refused;
        if (why == null && life != null) {
            try {
                value = life.peer.answer(asked);
            } catch (RuntimeException e) {
                why = e;
            }
        }
        var answer = Optional.ofNullable(value);
        String error = why == null ? null : String.valueOf(why.getMessage());
        if (error != null) {
            process.write(to -> to.put("error", error));
            return;
        }
        try {
            process.write(to -> to.put("value", answer));
        } catch (IllegalArgumentException e) { // it is too long
            String tooLong = String.valueOf(e.getMessage());
            process.write(to -> to.put("error", tooLong));
        }
    }
}
