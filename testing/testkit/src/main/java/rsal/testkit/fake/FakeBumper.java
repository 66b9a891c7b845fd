package rsal.testkit.fake;

import java.time.InstantSource;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import rsal.data.BumperState;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Bumper;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;

/// Feels walls and obstacles within 5 cm, as fake robots stop that far away from them, or what a test makes it
/// feel.
public final class FakeBumper extends FakeSensor<BumperState> implements Bumper {
    private static final double TOUCH = 0.05; // m
    private static final int SPOTS = 5;

    private final Part.Bumper part;
    private final FakeDriveBase base;
    private final FakeWorld world;
    private final InstantSource clock;
    private @Nullable List<Boolean> shown;

    FakeBumper(DeviceInfo info, Part.Bumper part, FakeDriveBase base, FakeWorld world, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.world = world;
        this.clock = clock;
    }

    /// From now on the bumpers are pressed or not as given.
    public void show(Boolean... pressed) {
        shown = List.of(pressed);
    }

    @Override
    void sense() {
        List<Boolean> pressed =
                shown != null ? shown : part.pads().stream().map(this::touches).toList();
        deliver(new Stamped<>(
                clock.instant(),
                info().robot() + "/base_link",
                new BumperState(
                        part.pads().stream().map(Part.Bumper.Pad::baseFromPad).toList(), pressed)));
    }

    private boolean touches(Part.Bumper.Pad pad) {
        Pose2d mapFromPad = base.mapFromBase().compose(pad.baseFromPad());
        return IntStream.range(0, SPOTS)
                .mapToDouble(i -> pad.length() * ((double) i / (SPOTS - 1) - 0.5))
                .mapToObj(y -> mapFromPad.compose(new Pose2d(0, y, 0)))
                .anyMatch(spot -> world.clearance(spot.x(), spot.y()) < TOUCH);
    }
}
