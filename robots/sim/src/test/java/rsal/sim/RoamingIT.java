package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import rsal.behavior.Pilot;
import rsal.behavior.PilotDriver;
import rsal.behavior.PioneerStack;
import rsal.behavior.Subsumption;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.model.RobotModels;
import rsal.model.RobotModels.Choice;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.Trials;

/// Pioneers of all kinds follow the walls of the office for ten minutes, through doors, around furniture and pillars,
/// into rooms and out of them; or they wander about.
class RoamingIT {
    private static final Location HERE = Location.of("test");
    private static final FileSource FILES = FileSource.resources(RoamingIT.class, "/");
    private static final Duration STEP = Duration.ofMillis(100);
    private static final int STEPS = 6000;

    @Trials(
            value = {
                "pioneer2dx, urg04lx, front8, 1",
                "pioneer2dx, none, front8, 1",
                "pioneer2dx, none, front8rear8dx, 2",
                "pioneer3at, utm30lx, front8rear8, 1",
                "pioneer3at, utm30lx, none, 2",
                "pioneer2dx, urg04lx, front8, 2",
            },
            landing = 2)
    void followsTheWallForTenMinutesAndTouchesNothing(String model, String laser, String sonar, long seed) {
        Walk walk = tenMinutes(model(model, laser, sonar), PioneerStack::followLeftWall, seed, 120);
        assertThat(walk.following).as("steps beside a wall").isGreaterThan(STEPS * 3 / 4);
    }

    @Trials(
            value = {
                "pioneer2dx, urg04lx, front8, 1",
                "pioneer2dx, none, front8, 3",
                "pioneer2dx, urg04lx, none, 2",
                "pioneer3at, utm30lx, front8rear8, 4",
            },
            landing = 2)
    void wandersForTenMinutesAndTouchesNothing(String model, String laser, String sonar, long seed) {
        tenMinutes(model(model, laser, sonar), PioneerStack::wander, seed, 100);
    }

    /// @param leastDistance that it should make [m]
    private static Walk tenMinutes(
            RobotModel model, Function<RobotModel, Subsumption> stack, long seed, double leastDistance) {
        var walk = new Walk(model, stack, seed);
        walk.tenMinutes();
        assertThat(walk.run.simulation.contacts()).isEmpty();
        assertThat(walk.longestRest).as("time in one place").isLessThan(Duration.ofSeconds(90));
        assertThat(walk.distance).as("way made [m]").isGreaterThan(leastDistance);
        assertThat(walk.squareMeters).as("places visited").hasSizeGreaterThan(15);
        return walk;
    }

    private static RobotModel model(String model, String laser, String sonar) {
        return new RobotModels(FILES)
                .read(model, HERE, Map.of("laser", new Choice(laser, HERE), "sonar", new Choice(sonar, HERE)));
    }

    private static final class Walk {
        final SimRun run;
        final LinkedHashSet<String> squareMeters = new LinkedHashSet<>();
        double distance;
        Duration longestRest = Duration.ZERO;
        int following;

        private final Pilot pilot;
        private Pose2d last;
        private Pose2d anchor;
        private Instant anchored = Instant.EPOCH;

        Walk(RobotModel model, Function<RobotModel, Subsumption> stack, long seed) {
            OccupancyGrid office = new Maps(FILES).read("office", HERE);
            run = SimRun.seeded(office, seed, Runnable::run, List.of(SimRun.anywhere("r1", model)));
            Robot robot = run.robots.getFirst();
            var driver = new PilotDriver();
            pilot = driver.create(
                    new DeviceDriver.Context("pilot", robot, office, Optional.empty(), run.scheduler, new Random(seed)),
                    Arguments.defaults(driver.parameters()));
            pilot.engage(stack.apply(model));
            pilot.subscribe(decision -> {
                if (decision.value().opinions().getFirst().state().equals("following")) {
                    following++;
                }
            });
            last = truth();
            anchor = last;
        }

        void tenMinutes() {
            for (int step = 0; step < STEPS; step++) {
                run.scheduler.advance(STEP);
                Pose2d now = truth();
                distance += last.distanceTo(now);
                last = now;
                squareMeters.add(Math.floor(now.x()) + ", " + Math.floor(now.y()));
                if (now.distanceTo(anchor) > 0.5) {
                    anchor = now;
                    anchored = run.scheduler.instant();
                }
                Duration rest = Duration.between(anchored, run.scheduler.instant());
                longestRest = rest.compareTo(longestRest) > 0 ? rest : longestRest;
            }
        }

        private Pose2d truth() {
            return run.simulation.truth("r1").orElseThrow();
        }
    }
}
