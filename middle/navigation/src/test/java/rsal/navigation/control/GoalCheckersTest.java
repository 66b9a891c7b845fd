package rsal.navigation.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Arguments;

/// What each goal checker of the installation owes.
class GoalCheckersTest {
    private static final Pose2d GOAL = new Pose2d(2, 1, Math.PI); // where angles wrap
    private static final Tolerance TOLERANCE = new Tolerance(0.4, Math.toRadians(10));

    static Stream<GoalCheckerType> types() {
        return ServiceLoader.load(GoalCheckerType.class).stream().map(ServiceLoader.Provider::get);
    }

    private static GoalChecker make(GoalCheckerType type) {
        return type.create(Arguments.defaults(type.parameters()), GOAL, TOLERANCE);
    }

    private static Pose2d at(double distance, double degrees) {
        return new Pose2d(2 - distance, 1, Math.PI + Math.toRadians(degrees));
    }

    @Test
    void thereAreTwo() {
        assertThat(types().map(GoalCheckerType::key)).containsExactlyInAnyOrder("stopped", "tolerance");
    }

    @ParameterizedTest
    @MethodSource("types")
    void theyKeepTheToleranceOfTheGoal(GoalCheckerType type) {
        assertThat(make(type).isAtPlace(at(0.41, 0), Twist2d.STOP)).isFalse();
        assertThat(make(type).isAtPlace(at(0.39, 90), Twist2d.STOP)).isTrue();
        for (double degrees : new double[] {-9.9, 9.9, 0}) {
            assertThat(make(type).isReached(at(0, degrees), Twist2d.STOP))
                    .as("%s°", degrees)
                    .isTrue();
        }
        for (double degrees : new double[] {-10.1, 10.1, 180}) {
            assertThat(make(type).isReached(at(0, degrees), Twist2d.STOP))
                    .as("%s°", degrees)
                    .isFalse();
        }
    }

    /// A robot that turns at its goal and is pushed a bit by that does not begin to drive again.
    @ParameterizedTest
    @MethodSource("types")
    void whoIsThereStaysUntilItIsFartherAway(GoalCheckerType type) {
        GoalChecker checker = make(type);
        assertThat(checker.isAtPlace(at(0.5, 0), Twist2d.STOP)).isFalse();
        assertThat(checker.isAtPlace(at(0.39, 0), Twist2d.STOP)).isTrue();
        assertThat(checker.isAtPlace(at(0.5, 0), Twist2d.STOP)).isTrue();
        assertThat(checker.isAtPlace(at(0.53, 0), Twist2d.STOP)).isFalse();
        assertThat(checker.isAtPlace(at(0.5, 0), Twist2d.STOP)).isFalse();
    }

    @Test
    void theOneThatWantsTheRobotToStandSeesHowItMoves() {
        var type = new StoppedGoalCheckerType();
        assertThat(make(type).isReached(at(0, 0), Twist2d.drive(0.03, 0))).isFalse();
        assertThat(make(type).isReached(at(0, 0), Twist2d.drive(-0.03, 0))).isFalse();
        assertThat(make(type).isReached(at(0, 0), Twist2d.drive(0, Math.toRadians(3))))
                .isFalse();
        assertThat(make(type).isReached(at(0, 0), Twist2d.drive(0.01, Math.toRadians(1))))
                .isTrue();
        Arguments slack = Arguments.of(type.parameters(), Map.of("speed", 0.1));
        assertThat(type.create(slack, GOAL, TOLERANCE).isReached(at(0, 0), Twist2d.drive(0.03, 0)))
                .isTrue();
    }
}
