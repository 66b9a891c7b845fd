package rsal.navigation.traffic;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;
import rsal.device.Subscription;
import rsal.robot.TeamLink;

/// Links of robots that all hear each other, but for chance.
public final class LossyLinks {
    private final Map<String, List<BiConsumer<String, Record>>> listeners = new LinkedHashMap<>();
    private final SplittableRandom random;
    private final double loss;
    private int said;

    /// @param loss how likely it is for each message and each robot that should hear it, 0–1
    public LossyLinks(long seed, double loss) {
        this.random = new SplittableRandom(seed);
        this.loss = loss;
    }

    public TeamLink link(String robot) {
        return new TeamLink() {
            @Override
            public void publish(Record message) {
                listeners.keySet().forEach(other -> send(other, message));
            }

            @Override
            public void send(String other, Record message) {
                said++;
                if (!other.equals(robot) && random.nextDouble() >= loss) {
                    listeners.getOrDefault(other, List.of()).forEach(listener -> listener.accept(robot, message));
                }
            }

            @Override
            public <M extends Record> Subscription onMessage(Class<M> type, BiConsumer<String, M> listener) {
                listeners.computeIfAbsent(robot, _ -> new ArrayList<>()).add((sender, message) -> {
                    if (type.isInstance(message)) {
                        listener.accept(sender, type.cast(message));
                    }
                });
                return () -> {};
            }
        };
    }

    /// From now on it hears nothing.
    void silence(String robot) {
        listeners.remove(robot);
    }

    /// Messages so far, one for each robot that was to hear it.
    int said() {
        return said;
    }
}
