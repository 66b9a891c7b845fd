package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.SimulationControl;
import rsal.model.RobotModels;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.DrawnMap;
import rsal.time.LockstepScheduler;

/// A robot on the bench: what all contract tests of devices start from. One robot, a Pioneer 2-DX with laser and
/// sonars unless a test takes another [#model], `r1`, stands at `@` of [#WORLD], looking along +x.
///
/// ```java
/// class SimDriveBaseTest extends DriveBaseContract {
///     @Override
///     protected RobotSystemProvider provider() {
///         return new SimProvider();
///     }
/// }
/// ```
///
/// Those that make a software device name a robot system that can carry it and its driver in [#drivers]; the fake
/// system will do for most.
public abstract class RobotBench {
    /// 16 m × 8 m, with corners that look different from everywhere. `a`, `b`, `c` can be reached in a straight
    /// line from `@`; `w` is next to a wall, `x` behind one.
    public static final DrawnMap WORLD = DrawnMap.grid(0.25, """
            ################################################################
            #..............................................................#
            #..............................................................#
            #..............................................................#
            #....................c.........................######..........#
            #..............................................######..........#
            #..............................................######..........#
            #..............................................................#
            #..............................................................#
            #..............................................................#
            #..............................................................#
            #..........####................................................#
            #..........####................................................#
            #..............................................................#
            #..............................................................#
            #..............................................................#
            #...........@...............a.................................w#
            #..............................................................#
            #..............................................................#
            #..............................................................#
            #..............................................................#
            #..............................................................#
            #.............................................................##
            #................................................########......#
            #...................b............................#......#......#
            #................................................#..x...#......#
            #................................................#......#......#
            #.............####...............................########......#
            #.............####.............................................#
            #.............####.............................................#
            #.............####.............................................#
            ################################################################""");

    /// Where `r1` starts.
    public static final Pose2d START = WORLD.pose('@', 0);

    protected static final Duration STEP = Duration.ofMillis(100);

    /// The run's time. Only [#advance] moves it.
    protected LockstepScheduler run = new LockstepScheduler();

    private @Nullable RobotSystem system;
    private @Nullable Robot robot;

    /// The robot system that carries the device.
    protected abstract RobotSystemProvider provider();

    /// How the system is set.
    protected Map<String, Object> settings() {
        return Map.of();
    }

    /// What the system cannot do.
    protected Set<Capability> cannot() {
        return Set.of();
    }

    /// What the robot carries besides laser and sonars: parts by device name.
    protected Map<String, String> parts() {
        return Map.of();
    }

    /// Software devices that the robot gets, in this order.
    protected List<DeviceDriver> drivers() {
        return List.of();
    }

    /// How a software device is set.
    protected Map<String, Object> settings(DeviceDriver driver) {
        return Map.of();
    }

    @BeforeEach
    final void setUpTheBench() {
        system = create(List.of(spec("r1", START)), 7);
        Robot made = await(system.discover()).getFirst();
        for (DeviceDriver driver : drivers()) {
            for (Class<? extends Device> needed : driver.needs()) {
                made.require(needed);
            }
            made = made.with(driver.create(
                    new DeviceDriver.Context(
                            driver.key(), made, WORLD.grid(), Optional.of(START), run, new SplittableRandom(7)),
                    Arguments.of(driver.parameters(), settings(driver))));
        }
        robot = made;
    }

    @AfterEach
    final void clearTheBench() {
        if (system != null) {
            system.close();
        }
    }

    /// A system of its own on the bench's clock.
    protected final RobotSystem create(List<RobotSpec> robots, long seed) {
        return create(robots, seed, run);
    }

    /// A system of its own.
    protected final RobotSystem create(List<RobotSpec> robots, long seed, LockstepScheduler scheduler) {
        var config = new RobotSystemProvider.Config(
                Arguments.of(provider().parameters(), settings()), Scene.of(WORLD.grid()), robots, seed);
        return provider().create(config, scheduler);
    }

    /// A robot of the [#model].
    protected final RobotSpec spec(String id, Pose2d mapFromBase) {
        return new RobotSpec(id, "tested", model(), Optional.of(mapFromBase), "#3366cc");
    }

    /// A Pioneer 2-DX with laser, sonars and [#parts].
    protected RobotModel model() {
        return model(parts());
    }

    /// A Pioneer 2-DX with laser, sonars and parts by device name.
    protected static RobotModel model(Map<String, String> parts) {
        Location here = Location.of("contract");
        var choices = new LinkedHashMap<String, RobotModels.Choice>();
        choices.put("laser", new RobotModels.Choice("urg04lx", here));
        parts.forEach((device, part) -> choices.put(device, new RobotModels.Choice(part, here)));
        return new RobotModels(FileSource.resources(RobotBench.class, "/")).read("pioneer2dx", here, choices);
    }

    protected final RobotSystem system() {
        return java.util.Objects.requireNonNull(system);
    }

    protected final Robot robot() {
        return java.util.Objects.requireNonNull(robot);
    }

    protected final SimulationControl simulation() {
        needs(Capability.TRUTH);
        return system().simulation().orElseThrow();
    }

    /// Where the robot really is.
    protected final Pose2d truth() {
        return simulation().truth("r1").orElseThrow();
    }

    /// Puts a thing into the world, where there is room.
    protected final void put(SimulationControl.Thing thing) {
        needs(Capability.THINGS);
        assertThat(simulation().add(thing)).isEqualTo(new SimulationControl.Placement.Placed());
    }

    /// Skips the test when the system cannot do this.
    protected final void needs(Capability capability) {
        assumeTrue(!cannot().contains(capability), () -> "The system can't do: " + capability);
    }

    protected final void advance(double seconds) {
        run.advance(Duration.ofNanos(Math.round(seconds * 1e9)));
    }

    /// Commands the base again and again, as those who drive do.
    protected final void drive(Twist2d velocity, double seconds) {
        DriveBase base = robot().require(DriveBase.class);
        for (int step = 0; step < Math.round(seconds * 10); step++) {
            base.command(velocity);
            run.advance(STEP);
        }
    }

    /// Lets time pass until an answer is there, at most a minute.
    protected final <T> T await(CompletionStage<T> stage) {
        return await(stage, 60);
    }

    /// Lets time pass until an answer is there.
    protected final <T> T await(CompletionStage<T> stage, double seconds) {
        var answers = new ArrayList<T>();
        var errors = new ArrayList<Throwable>();
        stage.whenComplete((answer, error) -> {
            if (error == null) {
                answers.add(answer);
            } else {
                errors.add(error);
            }
        });
        run.runPending();
        for (int step = 0; step < seconds * 10 && answers.isEmpty() && errors.isEmpty(); step++) {
            run.advance(STEP);
        }
        assertThat(errors).isEmpty();
        assertThat(answers).as("an answer within %s s", seconds).hasSize(1);
        return answers.getFirst();
    }
}
