package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.device.DriveBase;
import rsal.robot.Robot;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

class HelmTest {
    private final Robot robot = FakeSystem.pioneers(new LockstepScheduler(), RobotBench.WORLD, RobotBench.START)
            .robots()
            .getFirst();
    private final DriveBase base = robot.require(DriveBase.class);
    private final Helm helm = new Helm(base);
    private final DriveBase agents = helm.steering(robot, Helm.Hand.AGENTS).require(DriveBase.class);
    private final DriveBase orders = helm.steering(robot, Helm.Hand.ORDERS).require(DriveBase.class);

    @Test
    void nobodySwitchesMotorsOnInAnEmergency() {
        helm.stop();
        assertThat(base.enabled()).isFalse();
        agents.enable(true);
        orders.enable(true);
        assertThat(agents.enabled()).isFalse();
        assertThat(base.enabled()).isFalse();
        helm.rearm();
        assertThat(base.enabled()).isTrue();
    }

    @Test
    void motorsThatWereOffStayOffAfterAnEmergency() {
        agents.enable(false);
        helm.stop();
        helm.stop();
        helm.rearm();
        assertThat(base.enabled()).isFalse();
        agents.enable(true);
        assertThat(base.enabled()).isTrue();
    }

    @Test
    void whatPeopleSwitchedOffAloneStaysOffAfterAnEmergency() {
        helm.switchOff();
        helm.stop();
        agents.enable(true);
        helm.rearm();
        assertThat(base.enabled()).isFalse();
        helm.stop();
        helm.switchOn();
        assertThat(base.enabled()).isTrue();
    }

    @Test
    void whatWasWantedInAnEmergencyCountsAfterIt() {
        helm.stop();
        agents.enable(false);
        helm.rearm();
        assertThat(base.enabled()).isFalse();
        helm.stop();
        agents.enable(true);
        helm.rearm();
        assertThat(base.enabled()).isTrue();
    }
}
