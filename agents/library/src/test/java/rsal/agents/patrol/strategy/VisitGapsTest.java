package rsal.agents.patrol.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class VisitGapsTest {
    @Test
    void meanIdlenessIsThatOfManySamples() {
        for (int seed = 0; seed < 10; seed++) {
            var random = new SplittableRandom(seed);
            var gaps = new VisitGaps(3, 40);
            var last = new double[3];
            double sum = 0;
            double worst = 0;
            int samples = 0;
            for (int tick = 1; tick <= 20_000; tick++) {
                double now = tick / 100.0;
                for (int place = 0; place < 3; place++) {
                    double idle = now - last[place];
                    if (now > 40) {
                        sum += idle;
                        samples++;
                        worst = Math.max(worst, idle);
                    }
                    if (random.nextInt(700 * (place + 1)) == 0) {
                        gaps.visit(place, now);
                        last[place] = now;
                    }
                }
            }
            assertThat(gaps.meanIdleness(200)).as("seed %d", seed).isCloseTo(sum / samples, within(0.05));
            assertThat(gaps.worst(200)).as("seed %d", seed).isCloseTo(worst, within(0.05));
        }
    }

    @Test
    void meanTimeBetweenVisitsCountsEachPlaceTheSame() {
        var gaps = new VisitGaps(2, 0);
        for (int time = 10; time <= 100; time += 10) {
            gaps.visit(0, time);
        }
        gaps.visit(1, 50);
        gaps.visit(1, 80);
        assertThat(gaps.meanGap(100)).isEqualTo((10 + 40) / 2.0);
        assertThat(gaps.deviation(100)).isEqualTo(15);
        assertThat(gaps.worst(100)).isEqualTo(50);
        assertThat(gaps.visits()).isEqualTo(12);
    }

    @Test
    void whoStaysMakesNoVisitAndLeavesNothingAlone() {
        var gaps = new VisitGaps(1, 0);
        gaps.visit(0, 10);
        for (int time = 11; time <= 60; time++) {
            gaps.stay(0, time);
        }
        gaps.visit(0, 80);
        assertThat(gaps.visits()).isEqualTo(2);
        assertThat(gaps.meanGap(80)).isEqualTo((10 + 20) / 2.0);
        assertThat(gaps.worst(80)).isEqualTo(20);
        assertThat(gaps.meanIdleness(80)).isCloseTo((10 * 10 + 20 * 20) / 2.0 / 80, within(1e-9));
    }
}
