package rsal.ros2.bridge;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongSupplier;
import rsal.ros2.record.BagWriter;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.RobotRecorder;
import rsal.time.Scheduler;

/// Records a run's robots in a bag. All of its times are those of the run, so that equal runs make equal bytes.
final class Ros2Recorder implements RobotRecorder {
    private final AtomicReference<Optional<Scheduler>> time = new AtomicReference<>(Optional.empty());
    private final BagPublisher bag;

    Ros2Recorder(Path folder, boolean force, String program) throws IOException {
        LongSupplier clock = this::now;
        bag = new BagPublisher(BagWriter.folder(folder, force, program, clock), clock);
    }

    /// The run's time, since 1970 [ns]; simulated runs begin there.
    private long now() {
        return time.get()
                .map(scheduler ->
                        Duration.between(Instant.EPOCH, scheduler.instant()).toNanos())
                .orElse(0L);
    }

    @Override
    public Bridge open(BridgeContext context, Scheduler scheduler) {
        time.set(Optional.of(scheduler));
        return new RecordedRobots(bag, context, scheduler);
    }

    @Override
    public Optional<IOException> failure() {
        return bag.failure();
    }

    @Override
    public void close() {
        bag.close();
    }
}
