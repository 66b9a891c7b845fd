package rsal.navigation.nd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.nd.NearnessDiagram.Region;

class NearnessDiagramTest {
    private static final double RADIUS = 0.25;

    private final Obstacles obstacles = new Obstacles(5);
    private final NearnessDiagram diagram = new NearnessDiagram(RADIUS, 2 * RADIUS);

    @Test
    void aSeenGoalIsARegionEvenWhereNoGapIs() {
        arc(-180, 180, 2);
        assertThat(region(40, 1.5)).hasValueSatisfying(region -> {
            assertThat(region.goal()).isTrue();
            assertThat(region.direction()).isCloseTo(Math.toRadians(40), within(1e-9));
        });
        assertThat(region(40, 3)).isEmpty();
    }

    @Test
    void aHiddenGoalIsGoneToThroughTheNearestGap() {
        arc(-180, 180, 4);
        arc(-30, 50, 1);
        assertThat(region(0, 3)).hasValueSatisfying(region -> {
            assertThat(region.goal()).isFalse();
            assertThat(region.corner()).isCloseTo(Math.toRadians(-30), within(0.05));
            assertThat(region.side()).isEqualTo(-1);
            assertThat(region.cornerDistance()).isCloseTo(1, within(1e-3));
        });
    }

    @Test
    void aGapThatIsTooNarrowIsNone() {
        arc(-180, 180, 4);
        arc(-150, -5, 1);
        arc(15, 130, 1); // 20° at 1 m are 0.35 m
        assertThat(region(5, 3)).hasValueSatisfying(region -> {
            assertThat(region.goal()).isFalse();
            assertThat(region.corner()).isCloseTo(Math.toRadians(130), within(0.05));
        });
    }

    @Test
    void aDoorThatIsWideEnoughIsGoneThrough() {
        arc(-180, 180, 4);
        arc(-150, -20, 1);
        arc(20, 130, 1); // 0.7 m
        assertThat(region(5, 3))
                .hasValueSatisfying(region -> assertThat(region.goal()).isTrue());
    }

    private Optional<Region> region(double goalDegrees, double distance) {
        diagram.fill(obstacles);
        return diagram.region(Math.toRadians(goalDegrees), distance);
    }

    private void arc(int from, int to, double distance) {
        for (int degrees = from; degrees < to; degrees++) {
            var place = Pose2d.polar(distance, Math.toRadians(degrees)).position();
            obstacles.add(place.x(), place.y());
        }
    }
}
