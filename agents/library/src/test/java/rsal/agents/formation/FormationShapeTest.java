package rsal.agents.formation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.data.Point2d;

class FormationShapeTest {
    private static final double SPACING = 1.5;

    @ParameterizedTest
    @EnumSource
    void nobodyStandsNearerThanTheSpacingAndEverybodyHasANeighborAboutAtThatDistance(FormationShape shape) {
        for (int robots = 2; robots <= 30; robots++) {
            List<Point2d> places = shape.places(robots, SPACING);
            assertThat(places).hasSize(robots);
            for (Point2d one : places) {
                double nearest = places.stream()
                        .filter(other -> !other.equals(one))
                        .mapToDouble(one::distanceTo)
                        .min()
                        .orElseThrow();
                assertThat(nearest).as("%s of %d", shape, robots).isBetween(SPACING - 1e-9, 1.2 * SPACING);
            }
        }
    }

    @Test
    void shapesAreWhatTheirNamesSay() {
        assertThat(FormationShape.LINE.places(5, 1)).extracting(Point2d::x).containsOnly(0.0);
        assertThat(FormationShape.COLUMN.places(5, 1)).extracting(Point2d::y).containsOnly(0.0);
        assertThat(FormationShape.WEDGE.places(5, 1).getFirst().distanceTo(new Point2d(0, 0)))
                .isZero();
        assertThat(FormationShape.WEDGE.places(5, 1))
                .allMatch(place -> Math.abs(Math.abs(place.y()) + place.x()) < 1e-9);
        var middle = new Point2d(0, 0);
        double radius = FormationShape.CIRCLE.places(7, 1).getFirst().distanceTo(middle);
        assertThat(FormationShape.CIRCLE.places(7, 1))
                .allMatch(place -> Math.abs(place.distanceTo(middle) - radius) < 1e-9);
        assertThat(FormationShape.GRID.places(9, 1)).extracting(Point2d::x).containsOnly(0.0, -1.0, -2.0);
        assertThat(FormationShape.GRID.places(9, 1)).extracting(Point2d::y).containsOnly(-1.0, 0.0, 1.0);
    }

    @ParameterizedTest
    @EnumSource
    void oneRobotAloneLeads(FormationShape shape) {
        assertThat(shape.places(1, SPACING)).singleElement().satisfies(place -> {
            assertThat(place.x()).isZero();
            assertThat(place.y()).isZero();
        });
    }
}
