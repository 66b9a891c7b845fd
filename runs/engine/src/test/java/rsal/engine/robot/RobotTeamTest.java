package rsal.engine.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.device.DriveBase;
import rsal.engine.arbitration.CommandArbiter;
import rsal.engine.arbitration.Teleoperation;
import rsal.engine.event.EventLog;
import rsal.engine.report.Teammate;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan.Spares;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

class RobotTeamTest {
    private final RobotTeam team = new RobotTeam();

    private void join(Robot robot) {
        var teleoperation = new Teleoperation(
                robot,
                new CommandArbiter(robot.require(DriveBase.class)),
                Spares.none("There is nothing to make."),
                (_, _) -> {
                    throw new AssertionError("Nothing is made.");
                },
                new EventLog(() -> Duration.ZERO, () -> {}));
        var spec = new RobotSpec(robot.id(), robot.role(), robot.model(), Optional.empty(), "#808080");
        team.join(robot, Optional.of(teleoperation), new Teammate(spec, Optional.empty()));
    }

    @Test
    void somebodyMayLeaveWhileAllAreInformed() {
        List<Robot> robots = FakeSystem.pioneers(new LockstepScheduler(), RobotBench.WORLD, RobotBench.START)
                .robots();
        Robot first = robots.getFirst();
        join(first);
        join(new Robot("other", first.role(), first.model(), first.devices()));
        var reported = new ArrayList<Teleoperation>();
        for (Teleoperation teleoperation : team.teleoperation()) {
            team.leave("other");
            reported.add(teleoperation);
        }
        assertThat(reported).hasSize(2);
        assertThat(team.teleoperation()).hasSize(1);
    }
}
