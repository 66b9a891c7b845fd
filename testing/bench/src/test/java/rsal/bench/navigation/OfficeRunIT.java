package rsal.bench.navigation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import rsal.bench.navigation.OfficeRun.Errand;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

class OfficeRunIT {
    @Trials({"vfh, 1", "nd, 2", "snd, 2"})
    @LongTest
    void threeRobotsReachTheirGoalsInTimeWithoutTouchingAnything(String planner, long seed) {
        try (var run = new OfficeRun(Map.of("controller", planner), seed, Runnable::run)) {
            List<Errand> goals = run.run(15);
            assertThat(goals).hasSize(15).allMatch(Errand::reached);
            assertThat(run.contacts()).isZero();
            double took = goals.stream().mapToDouble(Errand::seconds).sum();
            double shortest = goals.stream().mapToDouble(Errand::shortest).sum();
            assertThat(took / shortest).isLessThan(1.5);
        }
    }
}
