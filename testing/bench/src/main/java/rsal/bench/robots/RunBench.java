package rsal.bench.robots;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.robots.WanderingRobots.Kind;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.RobotModel.Part;

/// What people get: whole processes of `rsal run … --headless --speed max` ([WholeRun]), of worlds with the robots of
/// [SwarmBench], which wander by the agent that the command line gives them, and of scenarios.
///
/// Names are `run.<subject>.<what>`. What: `rtf`, seconds simulated per second, and `cpu`, seconds simulated per second
/// of a processor, both after the first step: two runs are made, a long one and one of a step, and their differences
/// count, which has in it what the JVM compiles. `ratio`, processor time per simulated second divided by that of the
/// same robots in [SwarmBench] on one core; `start.line` and `start.step`, real time until the first line is printed,
/// and until a run of one step has ended; `start.cpu`, processor time of the latter.
public final class RunBench implements Bench {
    private static final Duration STEP = Duration.ofMillis(100);
    private static final double GOAL_RATIO = 1.3;
    private static final double GOAL_LINE = 0.4; // [s]
    private static final double GOAL_STEP = 0.8; // [s]

    /// @param label in the names of its results
    /// @param scenario empty: a world of robots
    /// @param robots as in [SwarmBench]; empty for those of the scenario
    /// @param length of the long run, in its own time
    /// @param goal what `rtf` is to reach
    private record Case(
            String label, String scenario, Optional<Kind> robots, int count, Duration length, OptionalDouble goal) {
        static Case of(Kind kind, int count, int seconds) {
            return new Case(
                    "%s.%d".formatted(kind.label(), count),
                    "",
                    Optional.of(kind),
                    count,
                    Duration.ofSeconds(seconds),
                    OptionalDouble.empty());
        }

        static Case of(String label, String scenario, int seconds, OptionalDouble goal) {
            return new Case(label, scenario, Optional.empty(), 0, Duration.ofSeconds(seconds), goal);
        }

        String name(String what) {
            return "run.%s.%s".formatted(label, what);
        }

        List<String> names() {
            var names = new ArrayList<>(List.of(name("rtf"), name("cpu")));
            if (robots.isPresent()) {
                names.add(name("ratio"));
            }
            names.addAll(List.of(name("start.line"), name("start.step"), name("start.cpu")));
            return names;
        }
    }

    private static final List<Case> CASES = List.of(
            Case.of(Kind.LASER180, 100, 300),
            Case.of(Kind.LASER180, 1000, 40),
            Case.of(Kind.SONAR16, 100, 300),
            Case.of(Kind.SONAR16, 1000, 60),
            Case.of(Kind.IR12, 1000, 60),
            Case.of("hunt", "hunt-and-prey", 50, OptionalDouble.of(120)),
            Case.of("advanced", "hunt-and-prey:advanced", 30, OptionalDouble.empty()),
            Case.of("swarm.100", "swarm:hundred", 60, OptionalDouble.of(10)));

    @Override
    public List<String> names() {
        return CASES.stream().flatMap(one -> one.names().stream()).toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (Case one : CASES) {
            if (assignment.wantsAny(one.names())) {
                measure(one, assignment);
            }
        }
    }

    private static void measure(Case one, BenchmarkRequest assignment) {
        try {
            Path folder = Files.createTempDirectory("rsal-bench-");
            Path file = folder.resolve("robots.world.yaml");
            try {
                if (one.robots.isPresent()) {
                    Files.writeString(file, world(one.robots.get(), one.count));
                    measure(one, file.toString(), assignment);
                } else {
                    measure(one, one.scenario, assignment);
                }
            } finally {
                Files.deleteIfExists(file);
                Files.delete(folder);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("The world of a benchmark can't be written.", e);
        }
    }

    private static void measure(Case one, String subject, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        double[] rtf = new double[repeats];
        double[] cpu = new double[repeats];
        double[] ratio = new double[repeats];
        double[] line = new double[repeats];
        double[] step = new double[repeats];
        double[] startCpu = new double[repeats];
        double simulated = one.length.minus(STEP).toMillis() * 1e-3;
        for (int i = 0; i < repeats; i++) {
            assignment.reach(one.name("runs"), i, repeats);
            WholeRun start = WholeRun.of(subject, STEP);
            WholeRun whole = WholeRun.of(subject, one.length);
            line[i] = start.firstLine();
            step[i] = start.wall();
            startCpu[i] = start.cpu();
            rtf[i] = simulated / (whole.wall() - start.wall());
            cpu[i] = simulated / (whole.cpu() - start.cpu());
            if (assignment.wants(one.name("ratio"))) { // right beside, as machines get slower and faster
                ratio[i] = SwarmBench.simulatedPerProcessorSecond(one.robots.orElseThrow(), one.count) / cpu[i];
            }
        }
        var reported = new ArrayList<>(List.of(
                Result.more(one.name("cpu"), "s/s", cpu),
                Result.less(one.name("start.line"), "s", line).toReach(GOAL_LINE),
                Result.less(one.name("start.step"), "s", step).toReach(GOAL_STEP),
                Result.less(one.name("start.cpu"), "s", startCpu)));
        Result speed = Result.more(one.name("rtf"), "s/s", rtf);
        reported.addFirst(one.goal.isPresent() ? speed.toReach(one.goal.getAsDouble()) : speed);
        if (one.robots.isPresent()) {
            reported.add(Result.less(one.name("ratio"), "", ratio).toReach(GOAL_RATIO));
        }
        assignment.report(reported);
    }

    /// A file of a world: robots that wander in the cave of [SwarmBench], which is a map of RSAL, too.
    static String world(Kind kind, int count) {
        var drive = kind.model().drive();
        var box = kind.model().footprint().corners();
        return String.format(
                Locale.ROOT,
                """
                rsal: 1
                step: 0.1
                walls: [{map: cave}]
                models:
                  wanderer:
                    body: {length: %s, width: %s}
                    drive:
                      maxSpeed: [%s, %s]
                      maxTurnRate: %s
                      maxAcceleration: %s
                      maxTurnAcceleration: %s
                      odometryNoise: {distancePerMeter: 0.02, headingPerMeter: 1, headingPerDegree: 0.05}
                    mounts: {sensor: [0, 0, 0]}
                    sensors: {sensor: sensor}
                parts:
                  sensor: %s
                robots:
                  wanderer: {model: wanderer, count: %d, pose: {free: true, clearance: 0.3}, program: wander}
                """,
                2 * box.stream().mapToDouble(Point2d::x).max().orElseThrow(),
                2 * box.stream().mapToDouble(Point2d::y).max().orElseThrow(),
                drive.forward().speed().least(),
                drive.forward().speed().most(),
                Math.toDegrees(drive.turn().speed().most()),
                drive.forward().acceleration().most(),
                Math.toDegrees(drive.turn().acceleration().most()),
                part(kind),
                count);
    }

    private static String part(Kind kind) {
        Part part = kind.model().sensors().values().iterator().next();
        return switch (part) {
            case Part.Laser laser ->
                "{type: laser, fieldOfView: %s, samples: %d, range: [%s, %s], noise: %s, period: 0.1}"
                        .formatted(
                                Math.toDegrees(laser.angleIncrement() * (laser.samples() - 1)),
                                laser.samples(),
                                laser.rangeMin(),
                                laser.rangeMax(),
                                laser.noise().deviation());
            case Part.Sonars ring ->
                "{type: sonars, sensors: %s, fieldOfView: %s, range: [%s, %s], noise: %s, period: 0.1}"
                        .formatted(
                                ring.baseFromSensors().stream()
                                        .map(RunBench::pose)
                                        .toList(),
                                Math.toDegrees(ring.fieldOfView()),
                                ring.rangeMin(),
                                ring.rangeMax(),
                                ring.noise().deviation());
            default -> throw new IllegalArgumentException("No robot here has a '%s'.".formatted(part));
        };
    }

    private static String pose(Pose2d baseFromSensor) {
        return "[%s, %s, %s]".formatted(baseFromSensor.x(), baseFromSensor.y(), Math.toDegrees(baseFromSensor.theta()));
    }
}
