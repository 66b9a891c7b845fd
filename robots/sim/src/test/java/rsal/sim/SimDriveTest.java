package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static rsal.sim.SimRun.robot;

import org.junit.jupiter.api.Test;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.SimulationControl.Contact;
import rsal.scene.Scene;
import rsal.scene.Touch;

class SimDriveTest {
    private final SimRun run = SimRun.of(SimRun.room(10, 4), robot("r1", Models.box(), new Pose2d(2, 2, 0)));

    private Odometry odometry() {
        return run.base("r1").latest().orElseThrow().value();
    }

    private void drive(Twist2d velocity, double seconds) {
        for (double t = 0; t < seconds - 1e-9; t += 0.1) {
            run.base("r1").command(velocity);
            run.advance(0.1);
        }
    }

    @Test
    void aCommandTakesEffectInTheNextStep() {
        run.advance(0.1);
        run.base("r1").command(Twist2d.drive(0.4, 0));
        assertThat(run.truth("r1")).isEqualTo(new Pose2d(2, 2, 0));
        run.advance(0.1);
        assertThat(run.truth("r1").x()).isGreaterThan(2);
    }

    @Test
    void speedsUpNoFasterThanItCan() {
        drive(Twist2d.drive(0.4, 0), 0.4);
        assertThat(odometry().velocity().vx()).isCloseTo(0.2, within(1e-12)); // 0.5 m/s² for 0.4 s
        assertThat(run.truth("r1").x()).isCloseTo(2.04, within(1e-12)); // a t²/2
    }

    @Test
    void stopsWhenNoCommandCameForHalfASecond() {
        drive(Twist2d.drive(0.4, 0), 1);
        run.advance(0.3); // the last command is 0.4 s old
        assertThat(odometry().velocity()).isEqualTo(Twist2d.drive(0.4, 0));
        run.advance(0.9); // 0.4 m/s take 0.8 s at 0.5 m/s²
        assertThat(odometry().velocity()).isEqualTo(Twist2d.STOP);
        Pose2d stopped = run.truth("r1");
        run.advance(1);
        assertThat(run.truth("r1")).isEqualTo(stopped);
    }

    @Test
    void cutsSpeedButKeepsTheCurvature() {
        drive(Twist2d.drive(1.6, 1), 2);
        assertThat(odometry().velocity()).isEqualTo(Twist2d.drive(0.8, 0.5));
    }

    @Test
    void disabledMotorsStandStill() {
        drive(Twist2d.drive(0.4, 0), 1);
        run.base("r1").enable(false);
        Pose2d before = run.truth("r1");
        drive(Twist2d.drive(0.4, 0), 1);
        assertThat(run.truth("r1")).isEqualTo(before);
        run.base("r1").enable(true);
        run.advance(0.1);
        assertThat(run.truth("r1")).isEqualTo(before); // commands that were ignored stay so
        drive(Twist2d.drive(0.4, 0), 1);
        assertThat(run.truth("r1").x()).isGreaterThan(before.x());
    }

    @Test
    void slidesAlongAWallWhereTheWorldSaysSo() {
        var scene = Scene.of(SimRun.room(10, 4)).with(Touch.SLIDE);
        var sliding = SimRun.in(scene, robot("r1", Models.box(), new Pose2d(2, 3, Math.toRadians(20))));
        for (int i = 0; i < 80; i++) {
            sliding.base("r1").command(Twist2d.drive(0.5, 0));
            sliding.advance(0.1);
        }
        Odometry odometry = sliding.base("r1").latest().orElseThrow().value();
        Pose2d truth = sliding.truth("r1");
        assertThat(truth.x()).as("goes on along the wall").isBetween(4.5, 6.0);
        assertThat(truth.y()).as("at the wall").isBetween(3.4, 3.8);
        assertThat(odometry.stalled()).isFalse();
        assertThat(odometry.odomFromBase().x())
                .as("wheels slip")
                .isGreaterThan(truth.distanceTo(new Pose2d(2, 3, 0)) + 0.1);
        assertThat(sliding.simulation.contacts()).as("one touch").hasSize(1);
    }

    @Test
    void stallsAtAWallAndBacksOffAgain() {
        drive(Twist2d.drive(0.8, 0), 12);
        assertThat(run.truth("r1").x()).isCloseTo(9.9 - 0.25, within(0.003));
        assertThat(odometry().stalled()).isTrue();
        assertThat(odometry().velocity()).isEqualTo(Twist2d.STOP);
        assertThat(odometry().odomFromBase().x()).isCloseTo(run.truth("r1").x() - 2, within(1e-9));
        assertThat(run.simulation.contacts())
                .extracting(Contact::robot, Contact::other)
                .containsExactly(org.assertj.core.groups.Tuple.tuple("r1", "wall"));
        drive(Twist2d.drive(-0.4, 0), 1);
        assertThat(odometry().stalled()).isFalse();
        assertThat(run.truth("r1").x()).isLessThan(9.5);
        drive(Twist2d.drive(0.8, 0), 3);
        assertThat(run.simulation.contacts()).hasSize(2);
    }

    @Test
    void refusesVelocitiesThatAreNotFinite() {
        assertThatThrownBy(() -> run.base("r1").command(new Twist2d(Double.NaN, 0, 0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("r1/base");
    }

    @Test
    void resettingOdometryDoesNotMoveTheRobot() {
        run.base("r1").resetOdometry(new Pose2d(5, 5, 1));
        run.advance(0.1);
        assertThat(odometry().odomFromBase()).isEqualTo(new Pose2d(5, 5, 1));
        assertThat(run.truth("r1")).isEqualTo(new Pose2d(2, 2, 0));
    }
}
