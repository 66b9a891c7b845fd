package rsal.agents.swarm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import rsal.data.Angles;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;

/// Rules on robots that turn and drive in a square, without noise: what becomes of the swarm, over seeds.
class SwarmRulesTest {
    private static final double STEP = 0.2; // s
    private static final double SPEED = 0.3; // m/s
    private static final int SEEDS = 5;

    private static final class World {
        private final double side;
        private final double radius;
        private final List<SwarmRule> rules = new ArrayList<>();
        private final List<RandomGenerator> randoms = new ArrayList<>();
        private List<Pose2d> poses = new ArrayList<>();
        private double time;

        /// @param within side of the square in the middle in which they start [m]
        World(
                SwarmRuleType type,
                Map<String, ?> values,
                long seed,
                int robots,
                double side,
                double within,
                double radius) {
            this.side = side;
            this.radius = radius;
            var random = new SplittableRandom(seed);
            double corner = (side - within) / 2;
            for (int robot = 0; robot < robots; robot++) {
                rules.add(type.create(Arguments.of(type.parameters(), values)));
                randoms.add(random.split());
                poses.add(new Pose2d(
                        corner + random.nextDouble(within),
                        corner + random.nextDouble(within),
                        random.nextDouble(-Math.PI, Math.PI)));
            }
        }

        void run(double seconds) {
            for (double end = time + seconds; time < end; time += STEP) {
                var next = new ArrayList<Pose2d>();
                for (int robot = 0; robot < poses.size(); robot++) {
                    next.add(moved(poses.get(robot), rules.get(robot).velocity(view(robot))));
                }
                poses = next;
            }
        }

        void lose(int robot) {
            poses.remove(robot);
            rules.remove(robot);
            randoms.remove(robot);
        }

        private SwarmView view(int robot) {
            Pose2d here = poses.get(robot);
            var neighbors = new ArrayList<SwarmView.Neighbor>();
            for (int other = 0; other < poses.size(); other++) {
                if (other != robot && poses.get(other).distanceTo(here) <= radius) {
                    neighbors.add(new SwarmView.Neighbor("r" + other, poses.get(other)));
                }
            }
            return new SwarmView(time, "r" + robot, here, SPEED, neighbors, wall(here), randoms.get(robot));
        }

        private Point2d wall(Pose2d here) {
            double x = here.x() < side / 2 ? -here.x() : side - here.x();
            double y = here.y() < side / 2 ? -here.y() : side - here.y();
            return Math.abs(x) < Math.abs(y) ? new Point2d(x, 0) : new Point2d(0, y);
        }

        private Pose2d moved(Pose2d pose, Point2d velocity) {
            if (velocity.equals(SwarmRule.STAND)) {
                return pose;
            }
            Point2d wanted = Vectors.atMost(velocity, SPEED);
            double error = Angles.wrap(Vectors.angle(wanted) - pose.theta());
            double turned = Angles.wrap(pose.theta() + Math.clamp(1.5 * error, -1, 1) * STEP);
            double way = Vectors.length(wanted) * Math.max(0, Math.cos(error)) * STEP;
            return new Pose2d(
                    Math.clamp(pose.x() + way * Math.cos(turned), 0, side),
                    Math.clamp(pose.y() + way * Math.sin(turned), 0, side),
                    turned);
        }
    }

    @Test
    void aFlockIsSoonAligned() {
        for (int seed = 1; seed <= SEEDS; seed++) {
            var world = new World(new Flocking(), Map.of(), seed, 12, 200, 8, 4);
            double before = SwarmMetric.polarization(world.poses);
            world.run(60);
            assertThat(SwarmMetric.polarization(world.poses))
                    .as("seed %d", seed)
                    .isGreaterThan(Math.max(0.9, before));
        }
    }

    @Test
    void muchNoiseLeavesNoOrder() {
        for (int seed = 1; seed <= SEEDS; seed++) {
            var world = new World(new Flocking(), Map.of("noise", 360), seed, 12, 200, 8, 4);
            world.run(60);
            assertThat(SwarmMetric.polarization(world.poses))
                    .as("seed %d", seed)
                    .isLessThan(0.8);
        }
    }

    @Test
    void robotsGather() {
        double sum = 0;
        for (int seed = 1; seed <= SEEDS; seed++) {
            var world = new World(new Aggregation(), Map.of(), seed, 12, 24, 22, 4);
            world.run(900);
            sum += SwarmMetric.largestCluster(world.poses, 1.8);
        }
        assertThat(sum / SEEDS).isGreaterThan(0.6);
    }

    @Test
    void robotsKeepAwayFromEachOther() {
        for (int seed = 1; seed <= SEEDS; seed++) {
            var world = new World(new Dispersion(), Map.of(), seed, 12, 24, 6, 6);
            world.run(90);
            assertThat(SwarmMetric.nearest(world.poses)).as("seed %d", seed).isGreaterThan(3);
            List<Pose2d> before = world.poses;
            world.run(10);
            assertThat(world.poses).as("seed %d: all stand", seed).isEqualTo(before);
        }
    }

    @Test
    void aFormationIsKeptWithoutALeaderAlsoWhenOneIsLost() {
        for (int seed = 1; seed <= SEEDS; seed++) {
            var world = new World(
                    new ConsensusFormation(),
                    Map.of("shape", "line", "spacing", 1.5, "route", "90 20"),
                    seed,
                    6,
                    40,
                    6,
                    1000);
            world.run(60);
            assertThat(lineError(world.poses)).as("seed %d", seed).isLessThan(0.2);
            double before = world.poses.getFirst().x();
            world.run(30);
            assertThat(world.poses.getFirst().x() - before).as("seed %d", seed).isGreaterThan(3);
            world.lose(3);
            world.run(40);
            assertThat(lineError(world.poses)).as("seed %d, one lost", seed).isLessThan(0.2);
        }
    }

    /// Greatest departure from a distance of 1.5 m between one and the next, side by side.
    private static double lineError(List<Pose2d> poses) {
        double worst = 0;
        for (int robot = 1; robot < poses.size(); robot++) {
            worst = Math.max(worst, Math.abs(poses.get(robot).distanceTo(poses.get(robot - 1)) - 1.5));
        }
        return worst;
    }

    @Test
    void metricsOfKnownSwarms() {
        var row = List.of(
                new Pose2d(0, 0, 0), new Pose2d(1, 0, Math.PI / 2), new Pose2d(2, 0, Math.PI), new Pose2d(9, 0, 0));
        assertThat(SwarmMetric.polarization(row))
                .isCloseTo(Math.hypot(1, 1) / 4, org.assertj.core.api.Assertions.within(1e-9));
        assertThat(SwarmMetric.largestCluster(row, 1.5)).isEqualTo(0.75);
        assertThat(SwarmMetric.largestCluster(row, 0.5)).isEqualTo(0.25);
        assertThat(SwarmMetric.nearest(row)).isEqualTo((1 + 1 + 1 + 7) / 4.0);
        assertThat(SwarmMetric.spread(List.of(new Pose2d(-2, 0, 0), new Pose2d(2, 0, 0))))
                .isEqualTo(2);
    }
}
