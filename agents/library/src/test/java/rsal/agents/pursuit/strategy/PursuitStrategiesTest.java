package rsal.agents.pursuit.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;

/// Hunts by points that turn in no time: what becomes of the prey.
class PursuitStrategiesTest {
    private static final double STEP = 0.5; // s
    private static final double SPEED = 0.4; // m/s, of all
    private static final double CATCH = 0.8; // m
    private static final double LONGEST = 120; // s

    private static PursuitStrategy strategy(PursuitStrategyType type, Map<String, ?> values) {
        return type.create(Arguments.of(type.parameters(), values));
    }

    private static final class Hunt {
        private final FloorGraph floor;
        private final PursuitModel flight;
        private final List<PursuitStrategy> strategies;
        private final List<Point2d> hunters = new ArrayList<>();
        private final TreeMap<String, Point2d> goals = new TreeMap<>();
        private final SplittableRandom random = new SplittableRandom(1);
        private final double sight; // m; 0: prey are heard of
        private Point2d prey;
        private double time;

        Hunt(OccupancyGrid map, List<PursuitStrategy> strategies, List<Point2d> hunters, Point2d prey, double sight) {
            this.floor = FloorGraph.of(map, prey, 0.3).orElseThrow();
            this.flight = new PursuitModel(floor, SPEED, SPEED, CATCH);
            this.strategies = strategies;
            this.hunters.addAll(hunters);
            this.prey = prey;
            this.sight = sight;
        }

        /// @param flees else the prey stands
        double captureTime(boolean flees) {
            for (; time < LONGEST; time += STEP) {
                if (isCaught()) {
                    return time;
                }
                for (int hunter = 0; hunter < hunters.size(); hunter++) {
                    decide(hunter);
                }
                if (flees) {
                    int[] at = hunters.stream().mapToInt(floor::nearest).toArray();
                    prey = towards(prey, floor.place(flight.preyStep(floor.nearest(prey), at)));
                }
            }
            return LONGEST;
        }

        private boolean isCaught() {
            return hunters.stream().anyMatch(hunter -> hunter.distanceTo(prey) < CATCH);
        }

        private boolean isSeen() {
            return sight == 0
                    || hunters.stream()
                            .anyMatch(hunter ->
                                    floor.seen(floor.nearest(hunter), sight).get(floor.nearest(prey)));
        }

        private void decide(int hunter) {
            var poses = new TreeMap<String, Pose2d>();
            IntStream.range(0, hunters.size()).forEach(i -> poses.put("h" + i, pose(hunters.get(i))));
            var known = new TreeMap<String, Pose2d>();
            if (isSeen()) {
                known.put("p", pose(prey));
            }
            var others = new TreeMap<>(goals);
            others.remove("h" + hunter);
            var view = new PursuitView(
                    time,
                    "h" + hunter,
                    pose(hunters.get(hunter)),
                    poses,
                    known,
                    known.isEmpty() ? Optional.empty() : Optional.of("p"),
                    others,
                    CATCH,
                    sight,
                    () -> Optional.of(floor),
                    random);
            Optional<PursuitOrder> order = strategies.get(hunter).decide(view);
            order.ifPresent(now -> {
                Point2d goal = now.mapFromGoal().position();
                if (strategies.get(hunter).sendsGoals()) {
                    goals.put("h" + hunter, goal);
                }
                int at = floor.nearest(hunters.get(hunter));
                int to = floor.next(at, floor.nearest(goal));
                hunters.set(hunter, towards(hunters.get(hunter), to == at ? goal : floor.place(to)));
            });
        }

        private static Pose2d pose(Point2d place) {
            return new Pose2d(place.x(), place.y(), 0);
        }

        private static Point2d towards(Point2d from, Point2d to) {
            double share = Math.min(1, SPEED * STEP / Math.max(1e-9, from.distanceTo(to)));
            return new Point2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
        }
    }

    private static double aroundTheBlock(PursuitStrategy one, PursuitStrategy other) {
        List<Point2d> hunters = List.of(new Point2d(2, 2), new Point2d(2, 3));
        return new Hunt(Maps.RING, List.of(one, other), hunters, new Point2d(2, 8), 0).captureTime(true);
    }

    @Test
    void aPreyAsFastAsItsHuntersRunsAroundABlockForEverUnlessOneOfThemGoesTheOtherWay() {
        assertThat(aroundTheBlock(strategy(new Direct(), Map.of()), strategy(new Direct(), Map.of())))
                .isEqualTo(LONGEST);
        Map<String, ?> equal = Map.of("hunterSpeed", SPEED, "preySpeed", SPEED);
        assertThat(aroundTheBlock(strategy(new Encircle(), equal), strategy(new Encircle(), equal)))
                .isLessThan(60);
    }

    @Test
    void huntersThatSearchByProbabilityFindAPreyBehindADoorSoonerThanThoseThatDriveAtRandom() {
        double clever = 0;
        double random = 0;
        for (Point2d prey : List.of(new Point2d(1.5, 6.5), new Point2d(7.5, 6.5), new Point2d(12.5, 6.5))) {
            List<Point2d> start = List.of(new Point2d(6, 2));
            clever += new Hunt(Maps.ROOMS, List.of(strategy(new Encircle(), Map.of())), start, prey, 10)
                    .captureTime(false);
            random += new Hunt(Maps.ROOMS, List.of(strategy(new RandomDrive(), Map.of())), start, prey, 10)
                    .captureTime(false);
        }
        assertThat(clever).isLessThan(0.7 * random);
    }

    @Test
    void theProbabilityOfUnseenPreyIsOneInAllAndNoneWhereHuntersSee() {
        FloorGraph floor = FloorGraph.of(Maps.ROOMS, new Point2d(6, 2), 0.3).orElseThrow();
        var search = new BeliefSearch(floor, SPEED, SPEED);
        var hunters = new TreeMap<>(Map.of("h", new Pose2d(6, 2, 0)));
        for (int time = 0; time < 60; time += 7) {
            search.update(new PursuitView(
                    time,
                    "h",
                    new Pose2d(6, 2, 0),
                    hunters,
                    new TreeMap<>(),
                    Optional.empty(),
                    new TreeMap<>(),
                    CATCH,
                    10,
                    () -> Optional.of(floor),
                    new SplittableRandom(1)));
            assertThat(IntStream.range(0, floor.size())
                            .mapToDouble(search::probability)
                            .sum())
                    .isCloseTo(1, within(1e-9));
            assertThat(floor.seen(floor.nearest(new Point2d(6, 2)), 10).stream()
                            .mapToDouble(search::probability)
                            .max())
                    .hasValue(0);
        }
    }
}
