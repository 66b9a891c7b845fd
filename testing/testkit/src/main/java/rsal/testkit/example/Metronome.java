package rsal.testkit.example;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.FakeProvider;
import rsal.time.Scheduler;

/// Fakes whose time a test drives, as another simulator does. They are there from its first time on.
public final class Metronome implements RobotSystemProvider {
    private static final Parameter<Boolean> DRIVES =
            Parameter.flag("drives", true, "Whether it drives the time of the run.");
    private static final Parameter<String> NAME = Parameter.text("name", "", "Tells several apart.");
    private static final Set<Consumer<? super Instant>> LISTENERS = ConcurrentHashMap.newKeySet();

    /// All runs of such robots have that time from now on.
    public static void beat(Instant now) {
        LISTENERS.forEach(listener -> listener.accept(now));
    }

    @Override
    public String key() {
        return "metronome";
    }

    @Override
    public String description() {
        return "Robots whose time a test drives.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false;
    }

    @Override
    public boolean drivesTime(Arguments settings) {
        return settings.get(DRIVES);
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(DRIVES, NAME);
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        return new Driven(new FakeProvider().create(config, scheduler));
    }

    private static final class Driven implements RobotSystem {
        private final RobotSystem fakes;
        private final CompletableFuture<Void> begun = new CompletableFuture<>();
        private Consumer<? super Instant> listener = _ -> {};

        Driven(RobotSystem fakes) {
            this.fakes = fakes;
        }

        @Override
        public void onTime(Consumer<? super Instant> driven) {
            listener = now -> {
                driven.accept(now);
                begun.complete(null);
            };
            LISTENERS.add(listener);
        }

        @Override
        public CompletionStage<List<Robot>> discover() {
            return begun.thenCompose(_ -> fakes.discover());
        }

        @Override
        public Subscription onChange(Consumer<? super Change> changes) {
            return fakes.onChange(changes);
        }

        @Override
        public Optional<SimulationControl> simulation() {
            return Optional.empty();
        }

        @Override
        public void close() {
            LISTENERS.remove(listener);
            fakes.close();
        }
    }
}
