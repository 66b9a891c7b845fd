package rsal.engine.arbitration;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.device.DriveBase;
import rsal.robot.Robot;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

class CommandArbiterTest {
    private final Robot robot = FakeSystem.pioneers(new LockstepScheduler(), RobotBench.WORLD, RobotBench.START)
            .robots()
            .getFirst();
    private final DriveBase base = robot.require(DriveBase.class);
    private final CommandArbiter arbiter = new CommandArbiter(base);
    private final DriveBase agents =
            arbiter.steering(robot, CommandArbiter.Source.AGENTS).require(DriveBase.class);
    private final DriveBase orders =
            arbiter.steering(robot, CommandArbiter.Source.ORDERS).require(DriveBase.class);

    @Test
    void nobodySwitchesMotorsOnInAnEmergency() {
        arbiter.stop();
        assertThat(base.enabled()).isFalse();
        agents.enable(true);
        orders.enable(true);
        assertThat(agents.enabled()).isFalse();
        assertThat(base.enabled()).isFalse();
        arbiter.rearm();
        assertThat(base.enabled()).isTrue();
    }

    @Test
    void motorsThatWereOffStayOffAfterAnEmergency() {
        agents.enable(false);
        arbiter.stop();
        arbiter.stop();
        arbiter.rearm();
        assertThat(base.enabled()).isFalse();
        agents.enable(true);
        assertThat(base.enabled()).isTrue();
    }

    @Test
    void whatPeopleSwitchedOffAloneStaysOffAfterAnEmergency() {
        arbiter.switchOff();
        arbiter.stop();
        agents.enable(true);
        arbiter.rearm();
        assertThat(base.enabled()).isFalse();
        arbiter.stop();
        arbiter.switchOn();
        assertThat(base.enabled()).isTrue();
    }

    @Test
    void whatWasWantedInAnEmergencyCountsAfterIt() {
        arbiter.stop();
        agents.enable(false);
        arbiter.rearm();
        assertThat(base.enabled()).isFalse();
        arbiter.stop();
        agents.enable(true);
        arbiter.rearm();
        assertThat(base.enabled()).isTrue();
    }
}
