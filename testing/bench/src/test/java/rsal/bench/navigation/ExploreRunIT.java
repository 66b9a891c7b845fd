package rsal.bench.navigation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.bench.navigation.ExploreRun.Reached;
import rsal.testkit.LongTest;

class ExploreRunIT {
    @Test
    @LongTest
    void threeRobotsMapMoreThanOneInTheSameTime() {
        double alone = mapped(1);
        double together = mapped(3);

        assertThat(alone).isBetween(0.02, 0.5);
        assertThat(together).isGreaterThan(1.5 * alone);
    }

    private static double mapped(int robots) {
        try (var run = new ExploreRun(robots, 1, Runnable::run)) {
            List<Reached> course = run.run(0.98, 3);
            assertThat(course.getLast().minutes()).isEqualTo(3);
            assertThat(run.contacts()).isZero();
            return course.getLast().share();
        }
    }
}
