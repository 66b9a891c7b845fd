package rsal.engine.communication;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import rsal.agent.ChannelModel;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.device.Subscription;
import rsal.robot.TeamLink;
import rsal.scenario.Communication;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Carries messages between software devices of robots. The same limits hold as for agents, but a robot's devices have
/// a channel of their own: what they say takes no bandwidth from its agents, and draws nothing from their chance, which
/// has another seed. All calls on the run's thread.
public final class RobotRadio {
    private final Optional<Radio> radio;
    private final Scheduler scheduler;
    private final Predicate<String> isGone;
    private final Map<String, List<Listener<?>>> listeners = new LinkedHashMap<>(); // by robot

    /// @param limits of the run; empty when all hear all
    /// @param placeOf where a robot is, in the map frame
    /// @param isGone whether a robot is gone, so that it says and hears nothing
    public RobotRadio(
            Optional<Communication> limits,
            OccupancyGrid map,
            Scheduler scheduler,
            Function<String, Optional<Point2d>> placeOf,
            Predicate<String> isGone) {
        this.radio = limits.map(some -> new Radio(withOwnSeed(some), map, UnaryOperator.identity(), placeOf));
        this.scheduler = scheduler;
        this.isGone = isGone;
    }

    /// Another one than that of the agents' radio, so that the same draws do not decide about both.
    private static Communication withOwnSeed(Communication limits) {
        return new Communication(
                limits.range(),
                limits.behindWalls(),
                limits.loss(),
                limits.delay(),
                limits.bandwidth(),
                new SplittableRandom(limits.seed()).split().nextLong());
    }

    private record Listener<M extends Record>(
            Class<M> type, BiConsumer<String, M> heard, UnaryOperator<Runnable> guard) {
        void hear(String sender, Record message) {
            if (type.isInstance(message)) {
                guard.apply(() -> heard.accept(sender, type.cast(message))).run();
            }
        }
    }

    /// That of one of a robot's devices.
    ///
    /// @param guard of what the device does when it hears something: the speaker is not to blame for it
    public TeamLink link(String robot, UnaryOperator<Runnable> guard) {
        return new TeamLink() {
            @Override
            public void publish(Record message) {
                say(robot, "", message);
            }

            @Override
            public void send(String to, Record message) {
                say(robot, to, message);
            }

            @Override
            public <M extends Record> Subscription onMessage(Class<M> type, BiConsumer<String, M> listener) {
                var added = new Listener<>(type, listener, guard);
                listeners.computeIfAbsent(robot, _ -> new ArrayList<>()).add(added);
                return () -> listeners.getOrDefault(robot, new ArrayList<>()).remove(added);
            }
        };
    }

    /// A robot has left: it hears nothing any more.
    public void leave(String robot) {
        listeners.remove(robot);
    }

    private void say(String sender, String to, Record content) {
        if (isGone.test(sender)) {
            return;
        }
        var message = new Message<>(new Topic<>("devices", Record.class), sender, to, scheduler.instant(), content);
        for (String listener : to.isEmpty() ? List.copyOf(listeners.keySet()) : List.of(to)) {
            if (!listener.equals(sender) && listeners.containsKey(listener) && !isGone.test(listener)) {
                carry(message, listener);
            }
        }
    }

    private void carry(Message<Record> message, String listener) {
        for (Duration late :
                radio.map(channel -> channel.copies(message, listener)).orElse(ChannelModel.AT_ONCE)) {
            if (late.isZero()) {
                deliver(message, listener);
            } else {
                scheduler.after(late, Phase.DEVICES, () -> deliver(message, listener));
            }
        }
    }

    private void deliver(Message<Record> message, String listener) {
        for (Listener<?> each : List.copyOf(listeners.getOrDefault(listener, List.of()))) {
            each.hear(message.sender(), message.content());
        }
    }
}
