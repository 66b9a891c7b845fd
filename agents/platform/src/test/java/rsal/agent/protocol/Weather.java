package rsal.agent.protocol;

import java.time.Duration;
import java.util.List;
import java.util.random.RandomGenerator;
import rsal.agent.ChannelModel;
import rsal.agent.Message;

/// Loses, delays and doubles messages at random.
///
/// @param loss share of messages that nobody hears
/// @param doubled share of those heard that come twice
/// @param latest longest delay
public record Weather(RandomGenerator random, double loss, double doubled, Duration latest) implements ChannelModel {
    @Override
    public List<Duration> copies(Message<?> message, String listener) {
        if (random.nextDouble() < loss) {
            return List.of();
        }
        return random.nextDouble() < doubled ? List.of(delay(), delay()) : List.of(delay());
    }

    private Duration delay() {
        return latest.isZero() ? Duration.ZERO : Duration.ofNanos(random.nextLong(latest.toNanos()));
    }
}
