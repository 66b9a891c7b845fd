package rsal.agents.foraging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.behavior.Percept;
import rsal.behavior.Surroundings;
import rsal.data.Angles;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

class AimTest {
    private static final double STEP = 0.1; // s

    private static Twist2d act(Aim aim, Pose2d odomFromBase) {
        var nothing = new float[Surroundings.SECTORS];
        Arrays.fill(nothing, Float.NaN);
        return aim.act(
                new Percept(Instant.EPOCH, new Odometry(odomFromBase, Twist2d.STOP, false), new Surroundings(nothing)),
                Twist2d.STOP);
    }

    @ParameterizedTest
    @CsvSource({"1, 0.6", "0.2, 0.3", "-0.2, -0.3", "-2, -0.6"})
    void turnsFirstToWhereItShouldBe(double bearing, double omega) {
        var aim = new Aim(Pose2d.polar(2, 0.5 + bearing).position());
        Twist2d command = act(aim, new Pose2d(0, 0, 0.5));
        assertThat(command.vx()).isZero();
        assertThat(command.omega()).isCloseTo(omega, within(1e-9));
    }

    /// From then on, when it faces the place, a whole turn and 60° more.
    @ParameterizedTest
    @ValueSource(doubles = {0, 1.5, -1.5})
    void looksAllAroundBeforeItGivesUp(double bearing) {
        var aim = new Aim(Pose2d.polar(2, bearing).position());
        double heading = 0;
        double turned = 0;
        for (int step = 0; step < 1000 && !aim.inVain(); step++) {
            double turn = act(aim, new Pose2d(0, 0, Angles.wrap(heading))).omega() * STEP;
            heading += turn;
            turned += Math.abs(turn);
        }
        assertThat(aim.inVain()).isTrue();
        assertThat(aim.seen()).isFalse();
        assertThat(turned - Math.abs(bearing)).isCloseTo(2 * Math.PI + Math.toRadians(60), within(0.3));
    }

    /// Slower the nearer it is; straight on for the last 0.35 m; no driving while 20° are missing.
    @ParameterizedTest
    @CsvSource({
        "1, 0, 0.25, 0",
        "0.4, 0, 0.168, 0",
        "0.3, 0, 0.108, 0",
        "0.15, 0, 0.06, 0",
        "1, 0.3, 0.25, 0.45",
        "1, -0.3, 0.25, -0.45",
        "1, 0.4, 0, 0.6",
        "1, -2, 0, -0.6",
        "0.3, 0.5, 0.108, 0"
    })
    void drivesAtWhatItSees(double distance, double bearing, double speed, double omega) {
        var aim = new Aim(new Point2d(9, 9));
        Point2d there = Pose2d.polar(distance, bearing).position();
        aim.spot(there);
        Twist2d command = act(aim, Pose2d.ORIGIN);
        assertThat(command.vx()).isCloseTo(speed, within(1e-9));
        assertThat(command.omega()).isCloseTo(omega, within(1e-9));
        assertThat(aim.odomFromTarget()).isEqualTo(there);
        assertThat(aim.inVain()).isFalse();
    }

    @Test
    void wasInVainWhenItDrovePastIt() {
        var aim = new Aim(new Point2d(1, 0));
        aim.spot(new Point2d(1, 0));
        act(aim, new Pose2d(0.87, 0, 0));
        assertThat(aim.inVain()).isFalse();
        act(aim, new Pose2d(0.89, 0, 0));
        assertThat(aim.inVain()).isTrue();
        assertThat(aim.seen()).isTrue();
    }
}
