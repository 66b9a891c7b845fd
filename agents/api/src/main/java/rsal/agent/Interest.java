package rsal.agent;

import java.time.Duration;
import java.util.function.Predicate;

/// What an agent wants to hear of a topic, so that one among a thousand need not hear all of the others. Messages that
/// it does not want are not delivered to it.
///
/// @param wanted asked on the run's thread whenever something is said: quick, without effects. One that throws ends
/// the agent
/// @param period least time between two messages of one sender; zero for all of them
public record Interest<M>(Predicate<? super Message<M>> wanted, Duration period) {
    /// In everything.
    public static <M> Interest<M> all() {
        return new Interest<>(_ -> true, Duration.ZERO);
    }

    public static <M> Interest<M> in(Predicate<? super M> content) {
        return new Interest<>(message -> content.test(message.content()), Duration.ZERO);
    }

    /// The same, and that as well.
    public Interest<M> and(Interest<M> other) {
        Duration longer = period.compareTo(other.period) > 0 ? period : other.period;
        return new Interest<>(message -> wanted.test(message) && other.wanted.test(message), longer);
    }

    /// The same, but of each sender at most so often.
    public Interest<M> atMostEvery(Duration least) {
        return new Interest<>(wanted, least);
    }
}
