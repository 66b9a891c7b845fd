package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Executors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.NavigationFunction;
import rsal.navigation.wavefront.Wavefront;
import rsal.robot.RobotSpec;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;

/// Robots that map the office from scratch, each time within a time that one robot less could not keep to.
/// `rsal bench navigation --only explore` measures how long they take, with two robots and other starts, too.
class ExploreIT {
    private static final OccupancyGrid OFFICE =
            new Maps(FileSource.resources(ExploreIT.class, "/")).read("office", Location.of("test"));
    private static final CostMap ROOM_TO_DRIVE =
            CostMap.of(OFFICE, DistanceField.toNotFree(OFFICE), new CostMap.Clearance(0.35, 0.7, 3));

    @LongTest
    @ParameterizedTest
    @CsvSource({"1, 1, 45", "3, 1, 16"})
    void theOfficeIsMappedFromScratch(int robots, long seed, int atMost) {
        var random = new SplittableRandom(seed);
        Pose2d first = start(random);
        var specs = new ArrayList<RobotSpec>();
        for (int i = 0; i < robots; i++) {
            Pose2d start = first;
            while (i > 0 && !beside(start, specs)) {
                start = start(random);
            }
            specs.add(NavigationRun.robot("r" + i, NavigationRun.pioneer("urg04lx"), start));
        }
        try (var workers = Executors.newFixedThreadPool(2)) {
            NavigationRun run = new NavigationRun(OFFICE, seed, workers, specs)
                    .with(new SlamDriver(), Map.of())
                    .with(new NavigatorDriver(), Map.of())
                    .with(new ExplorerDriver(), Map.of());
            double share = 0;
            int minutes = 0;
            while (share < 0.98 && minutes < atMost) {
                run.advance(60);
                minutes++;
                share = share(
                        run.robot("r0")
                                .require(Explorer.class)
                                .latest()
                                .orElseThrow()
                                .value(),
                        first);
            }
            assertThat(share)
                    .as("%d robots, seed %d, %d min", robots, seed, minutes)
                    .isGreaterThanOrEqualTo(0.98);
            assertThat(run.simulation.contacts()).isEmpty();
            assertThat(run.robots).allSatisfy(r -> assertThat(run.error(r.id())).isLessThan(0.3));
        }
    }

    private static Pose2d start(SplittableRandom random) {
        while (true) {
            var place = new Point2d(
                    OFFICE.originX() + random.nextDouble() * OFFICE.width() * OFFICE.resolution(),
                    OFFICE.originY() + random.nextDouble() * OFFICE.height() * OFFICE.resolution());
            if (ROOM_TO_DRIVE.isPassable(place)) {
                return new Pose2d(place.x(), place.y(), random.nextDouble(-3, 3));
            }
        }
    }

    private static boolean beside(Pose2d start, List<RobotSpec> others) {
        return others.stream().allMatch(o -> o.mapFromBase().orElseThrow().distanceTo(start) > 1);
    }

    /// How much of where a robot can be from its start is known to be free.
    private static double share(OccupancyGrid map, Pose2d start) {
        NavigationFunction from =
                new Wavefront(ROOM_TO_DRIVE).everywhere(start.position(), 0.5).orElseThrow();
        int all = 0;
        int known = 0;
        for (int row = 0; row < OFFICE.height(); row++) {
            for (int column = 0; column < OFFICE.width(); column++) {
                var place = new Point2d(OFFICE.x(column), OFFICE.y(row));
                if (from.cost(place) < Double.POSITIVE_INFINITY) {
                    all++;
                    known += map.isFree(place.x(), place.y()) ? 1 : 0;
                }
            }
        }
        return (double) known / all;
    }
}
