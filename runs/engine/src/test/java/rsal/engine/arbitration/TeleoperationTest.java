package rsal.engine.arbitration;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.behavior.PilotDriver;
import rsal.device.DriveBase;
import rsal.engine.event.EventLog;
import rsal.engine.report.Answer;
import rsal.engine.report.RunBroken;
import rsal.robot.Robot;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.Spare;
import rsal.scenario.RunPlan.Spares;
import rsal.settings.Arguments;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

class TeleoperationTest {
    private final Robot robot = FakeSystem.pioneers(new LockstepScheduler(), RobotBench.WORLD, RobotBench.START)
            .robots()
            .getFirst();

    @Test
    void whatCantBeMadeIsRefusedAndChangesNothing() {
        var pilot = new PilotDriver();
        var spare =
                new Spare(List.of(new PlannedDevice("pilot", pilot, Arguments.defaults(pilot.parameters()), 1)), "");
        var teleoperation = new Teleoperation(
                robot,
                new CommandArbiter(robot.require(DriveBase.class)),
                new Spares(spare, spare),
                (_, _) -> {
                    throw new RunBroken("Device 'r1/pilot'", new IllegalStateException("no batteries"));
                },
                new EventLog(() -> Duration.ZERO, () -> {}));
        assertThat(teleoperation.behave("stand", 0)).isEqualTo(new Answer.Done());
        var refused = new Answer.Refused("Device 'r1/pilot' failed: no batteries");
        assertThat(teleoperation.behave("wander", 0)).isEqualTo(refused);
        assertThat(teleoperation.behavior()).isEqualTo("stand");
        assertThat(teleoperation.navigator(0)).isEqualTo(new Teleoperation.Navigation.Refused(refused));
        assertThat(teleoperation.behavior()).isEqualTo("stand");
    }
}
