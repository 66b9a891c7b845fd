package rsal.navigation.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.Pose2d;
import rsal.settings.Arguments;

/// What each progress checker of the installation owes.
class ProgressCheckersTest {
    static Stream<ProgressCheckerType> types() {
        return ServiceLoader.load(ProgressCheckerType.class).stream().map(ServiceLoader.Provider::get);
    }

    private static ProgressChecker make(ProgressCheckerType type) {
        return type.create(Arguments.defaults(type.parameters()));
    }

    private static Pose2d at(double x) {
        return new Pose2d(x, 0, Math.PI);
    }

    @Test
    void thereAreTwo() {
        assertThat(types().map(ProgressCheckerType::key)).containsExactlyInAnyOrder("path", "movement");
    }

    @ParameterizedTest
    @MethodSource("types")
    void whoStandsMakesNoProgress(ProgressCheckerType type) {
        ProgressChecker checker = make(type);
        assertThat(checker.isProgress(at(0), 10)).isTrue();
        for (int i = 0; i < 100; i++) {
            assertThat(checker.isProgress(at(0), 10)).isFalse();
        }
    }

    @ParameterizedTest
    @MethodSource("types")
    void whoDrivesSlowlyMakesProgressNowAndThen(ProgressCheckerType type) {
        ProgressChecker checker = make(type);
        checker.isProgress(at(0), 10);
        int times = 0;
        for (int i = 1; i <= 200; i++) {
            times += checker.isProgress(at(-0.01 * i), 10 - 0.01 * i) ? 1 : 0;
        }
        assertThat(times).isBetween(3, 20);
    }

    @Test
    void onlyLessOfThePathIsProgress() {
        ProgressChecker checker = make(new PathProgressCheckerType());
        checker.onNewPath(10);
        assertThat(checker.isProgress(at(5), 10.5)).isFalse();
        assertThat(checker.isProgress(at(5), 9.91)).isFalse();
        assertThat(checker.isProgress(at(5), 9.89)).isTrue();
        assertThat(checker.isProgress(at(5), 9.8)).isFalse();
        checker.onNewPath(20);
        assertThat(checker.isProgress(at(5), 19.95)).isFalse();
        assertThat(checker.isProgress(at(5), 19.89)).isTrue();
    }

    @Test
    void anyMoveIsProgressForTheOther() {
        var type = new MovementProgressCheckerType();
        ProgressChecker checker = type.create(Arguments.of(type.parameters(), Map.of("distance", 0.3, "angle", 20)));
        checker.isProgress(at(0), 10);
        assertThat(checker.isProgress(at(0.29), 11)).isFalse();
        assertThat(checker.isProgress(at(0.31), 11)).isTrue();
        assertThat(checker.isProgress(at(0.02), 11)).isFalse();
        double turned = Math.PI + Math.toRadians(21); // where angles wrap
        assertThat(checker.isProgress(new Pose2d(0.31, 0, turned), 11)).isTrue();
        checker.onNewPath(5);
        assertThat(checker.isProgress(new Pose2d(0.31, 0, turned), 5)).isFalse();
    }
}
