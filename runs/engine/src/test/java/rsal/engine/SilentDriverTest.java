package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.engine.arbitration.CommandArbiter;
import rsal.engine.arbitration.Teleoperation;
import rsal.engine.event.EventLog;
import rsal.engine.report.Answer;
import rsal.robot.Robot;
import rsal.scenario.RunPlan.Spare;
import rsal.scenario.RunPlan.Spares;
import rsal.testkit.contract.CommandTimeoutContract;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

/// Somebody who drives by keys, and of whom nothing is heard any more.
class SilentDriverTest implements CommandTimeoutContract {
    private static final Duration STEP = Duration.ofMillis(100);

    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final FakeSystem system = FakeSystem.pioneers(scheduler, RobotBench.WORLD, RobotBench.START);
    private final Robot robot = system.robots().getFirst();
    private final Teleoperation teleoperation = new Teleoperation(
            robot,
            new CommandArbiter(robot.require(DriveBase.class)),
            new Spares(new Spare(List.of(), "none"), new Spare(List.of(), "none")),
            (_, _) -> {
                throw new AssertionError("Nothing is asked for that has to be made.");
            },
            new EventLog(scheduler::elapsed, () -> {}));
    private long clock; // on the wall [ns]

    @BeforeEach
    void start() {
        assertThat(system.discover()).isCompleted();
    }

    @Override
    public void command() {
        assertThat(teleoperation.drive("me", Twist2d.drive(0, 0.3), clock)).isEqualTo(new Answer.Done());
        advanceRobot(Duration.ofSeconds(1));
    }

    @Override
    public void pass(Duration silence) {
        clock += silence.toNanos();
        advanceRobot(Duration.ofSeconds(1));
    }

    @Override
    public void advanceRobot(Duration time) {
        for (long step = 0; step < time.dividedBy(STEP); step++) {
            teleoperation.beat(clock);
            scheduler.advance(STEP);
        }
    }

    @Override
    public boolean isMoving() {
        return robot.require(DriveBase.class)
                .latest()
                .map(Stamped::value)
                .filter(odometry -> odometry.velocity().omega() > 0)
                .isPresent();
    }
}
