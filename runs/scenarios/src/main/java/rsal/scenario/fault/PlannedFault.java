package rsal.scenario.fault;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.fault.Fault;

/// Something that goes wrong in a run.
///
/// @param kind what the scenario calls it (`dead`)
/// @param targets what can have it
/// @param pick how many of them have it at a time, chosen at random each time; empty when each has it in its own
/// time
/// @param at when it begins; when it comes at random, the time before which it does not
/// @param every mean time until it begins, from when it could and again after each end; empty when it begins just
/// once, at `at`
/// @param lasts how long; empty for good
/// @param seed of its random streams
public record PlannedFault(
        String kind,
        List<Target> targets,
        Optional<Integer> pick,
        Duration at,
        Optional<Duration> every,
        Optional<Span> lasts,
        long seed) {
    public PlannedFault {
        targets = List.copyOf(targets);
    }

    /// Who or what can have a fault.
    public sealed interface Target {
        /// Unique among the targets of a fault: `hunter-1/laser`.
        String name();

        /// What is wrong with it, for people: `biased by 0.10 m`.
        default String words() {
            return FaultWords.of(this);
        }
    }

    /// A robot or one of its devices.
    ///
    /// @param device name; empty when it is the whole robot
    public record OfRobot(String robot, String device, Fault fault) implements Target {
        @Override
        public String name() {
            return device.isEmpty() ? robot : robot + "/" + device;
        }
    }

    /// Messages on their way from one agent to another.
    ///
    /// @param topics names or patterns; empty for all
    /// @param from names of agents; empty for all, people too
    /// @param to names of agents; empty for all
    /// @param share how likely it is for each message and each agent that should hear it, 0–1
    public record OfMessages(
            List<String> topics, Optional<Set<String>> from, Optional<Set<String>> to, double share, Mishap mishap)
            implements Target {
        public OfMessages {
            topics = List.copyOf(topics);
            from = from.map(Set::copyOf);
            to = to.map(Set::copyOf);
        }

        @Override
        public String name() {
            return "messages";
        }

        /// Whether it can happen to messages of a topic between two agents.
        public boolean concerns(String topic, String sender, String listener) {
            return (topics.isEmpty() || topics.stream().anyMatch(pattern -> Wildcard.matches(pattern, topic)))
                    && from.filter(names -> !names.contains(sender)).isEmpty()
                    && to.filter(names -> !names.contains(listener)).isEmpty();
        }
    }

    /// What becomes of a message.
    public sealed interface Mishap {
        record Lost() implements Mishap {}

        /// @param delay of all of its copies
        record Late(Span delay) implements Mishap {}

        /// @param delay of the second copy after the first
        record Doubled(Span delay) implements Mishap {}
    }
}
