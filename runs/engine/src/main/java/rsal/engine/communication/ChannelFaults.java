package rsal.engine.communication;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.random.RandomGenerator;
import rsal.agent.ChannelModel;
import rsal.agent.Message;
import rsal.device.Subscription;
import rsal.scenario.fault.PlannedFault.Mishap;
import rsal.scenario.fault.PlannedFault.OfMessages;

/// What happens to messages now. Several mishaps come one after the other, in the order in which they began.
final class ChannelFaults implements ChannelModel {
    private static final int MOST_COPIES = 64; // of a message for a listener

    private final Lost lost;
    private final List<Active> active = new ArrayList<>();
    private final Counter silent = new Counter(); // agents

    /// Told of each message that a mishap keeps an agent from hearing.
    @FunctionalInterface
    interface Lost {
        void note(Message<?> message, String listener);
    }

    private static final class Active {
        private final OfMessages messages;
        private final RandomGenerator random;

        Active(OfMessages messages, RandomGenerator random) {
            this.messages = messages;
            this.random = random;
        }

        boolean strikes(Message<?> message, String listener) {
            return messages.concerns(message.topic().name(), message.sender(), listener)
                    && random.nextDouble() < messages.share();
        }
    }

    ChannelFaults(Lost lost) {
        this.lost = lost;
    }

    /// @param random a stream of its own
    /// @return ends it
    Subscription begin(OfMessages messages, RandomGenerator random) {
        var begun = new Active(messages, random);
        active.add(begun);
        return () -> active.remove(begun);
    }

    /// Some agents neither hear nor are heard.
    ///
    /// @return ends it
    Subscription silence(Set<String> agents) {
        agents.forEach(silent::add);
        return () -> agents.forEach(silent::remove);
    }

    boolean isSilent(String agent) {
        return silent.contains(agent);
    }

    /// Whether all that an agent says to another is lost now, whatever it is about.
    boolean blocks(String sender, String listener) {
        return isSilent(sender)
                || isSilent(listener)
                || active.stream()
                        .map(each -> each.messages)
                        .anyMatch(messages -> messages.mishap() instanceof Mishap.Lost
                                && messages.share() >= 1
                                && messages.topics().isEmpty()
                                && messages.concerns("", sender, listener));
    }

    @Override
    public List<Duration> copies(Message<?> message, String listener) {
        List<Duration> copies = AT_ONCE;
        for (Active each : active) {
            if (each.strikes(message, listener)) {
                copies = after(each, copies);
            }
        }
        if (copies.isEmpty()) {
            lost.note(message, listener);
        }
        return copies;
    }

    @Override
    public boolean reaches(Message<?> message, String listener) {
        return !isSilent(listener);
    }

    private static List<Duration> after(Active active, List<Duration> copies) {
        return switch (active.messages.mishap()) {
            case Mishap.Lost _ -> List.of();
            case Mishap.Late(var delay) -> {
                Duration late = delay.draw(active.random);
                yield copies.stream().map(late::plus).toList();
            }
            case Mishap.Doubled(var delay) -> {
                Duration late = delay.draw(active.random);
                var both = new ArrayList<>(copies);
                copies.stream().limit(MOST_COPIES - copies.size()).forEach(copy -> both.add(copy.plus(late)));
                yield both;
            }
        };
    }
}
