package rsal.agent;

import java.time.Duration;
import java.util.List;

/// What becomes of a message on its way from the one who says it to one who listens.
@FunctionalInterface
public interface ChannelModel {
    /// One copy at once.
    List<Duration> AT_ONCE = List.of(Duration.ZERO);

    /// Everybody hears everything at once.
    ChannelModel PERFECT = (_, _) -> AT_ONCE;

    /// After how long each copy of a message arrives; none when it is lost. Asked once for each message and
    /// listener, in the order in which they subscribed, at the instant at which it was said.
    ///
    /// @param listener name of the agent that listens
    List<Duration> copies(Message<?> message, String listener);

    /// Whether a copy that comes late still reaches the listener. Asked when it arrives.
    ///
    /// @param listener name of the agent that listens
    default boolean reaches(Message<?> message, String listener) {
        return true;
    }

    /// Told when an agent hears a message: when the first copy reaches it, once however many copies and ears there
    /// are. What agents say to themselves is not told.
    ///
    /// @param listener name of the agent that hears it
    default void heard(Message<?> message, String listener) {}

    /// Told when none of the copies on their way [reached][#reaches] an agent: when the last has come in vain.
    ///
    /// @param listener name of the agent that does not hear it
    default void unheard(Message<?> message, String listener) {}
}
