package rsal.navigation.explore;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;

class FrontierAssignmentTest {
    private static final double FAR = Double.POSITIVE_INFINITY;

    private static Frontier at(double x, double y) {
        return new Frontier(new Point2d(x, y), 2);
    }

    @Test
    void oneRobotGoesToTheNearest() {
        assertThat(FrontierAssignment.assign(List.of(at(0, 0), at(5, 0)), new double[][] {{7, 2}}, 4))
                .containsExactly(Optional.of(1));
    }

    @Test
    void aLongerFrontierIsWorthADetour() {
        var frontiers = List.of(new Frontier(new Point2d(0, 0), 0.5), new Frontier(new Point2d(9, 0), 5));

        assertThat(FrontierAssignment.assign(frontiers, new double[][] {{3, 4}}, 4))
                .containsExactly(Optional.of(1));
    }

    @Test
    void twoRobotsGoDifferentWays() {
        double[][] costs = {{2, 8}, {3, 8}};

        assertThat(FrontierAssignment.assign(List.of(at(0, 0), at(10, 0)), costs, 4))
                .containsExactly(Optional.of(0), Optional.of(1));
    }

    @Test
    void nobodyGoesWhereNoWayLeadsOrAnotherGoes() {
        assertThat(FrontierAssignment.assign(List.of(at(0, 0)), new double[][] {{FAR}}, 4))
                .containsExactly(Optional.empty());
        assertThat(FrontierAssignment.assign(List.of(at(0, 0)), new double[][] {{3}, {2}}, 4))
                .containsExactly(Optional.empty(), Optional.of(0));
        assertThat(FrontierAssignment.assign(List.of(), new double[2][0], 4))
                .containsExactly(Optional.empty(), Optional.empty());
    }
}
