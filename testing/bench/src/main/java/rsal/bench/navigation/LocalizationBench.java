package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Lines.Point;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.bench.navigation.Drive.Tick;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.map.Maps;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.Amcl.Settings;
import rsal.navigation.amcl.Beams;
import rsal.navigation.amcl.Kld;
import rsal.navigation.amcl.LocalizationMap;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.amcl.SensorModel;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.replay.Replay;
import rsal.navigation.replay.Verdict;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Localization by particles.
///
/// Names are `amcl.<case>.<what>`:
/// * `amcl.<particles>x<beams>.ms`: an update in the office, on one core; `.ns` the same by particle and beam that
///   hit something, and `.beam.ns` what more of these cost each particle: those that 180 have more.
/// * `amcl.100robots.<sensor>.cores`: share of a core that 100 robots in the office take which measure ten times a
///   second, driven for half a minute from where they were told to start; `.always.cores` with an update each time, as
///   far as they go and turn or not.
/// * `amcl.office.<sensor>.<what>`: how far off a robot is that drives through the office and was told where it
///   starts; 20 drives of a minute. `sure` is the share of the time in which it says to be localized and is: who
///   never says so is never wrong either.
/// * `amcl.office.simulated.<sensor>.<what>`: the same of a simulated Pioneer and its device `amcl`, told where it
///   starts, with the laser or sonars of the simulator, their noise and that of its wheels.
/// * `amcl.kidnap.recovered`: share of 40 robots that, carried elsewhere in the office, are right and say
///   to be localized within half a minute.
/// * `amcl.corridor.falseConfidence`: share of the time in which a robot in a corridor that looks the same from both
///   ends, not told where it is, says to be localized and is not; 20 drives.
/// * `amcl.<log>.<what>`: the log's map is drawn from every other of its scans; on the rest, 50 robots with erring
///   wheels begin anywhere in the log without being told where: share of those right within 10 scans, who know it
///   later; of all scans from where each is right on the errors, and those of the robot that has the largest; and the
///   share of scans at which they say to be localized and are not. Robots that never are right have no part in the
///   errors.
public final class LocalizationBench implements Bench {
    private static final List<String> OF_LOGS = List.of("converged", "rmse", "worst", "p95", "falseConfidence");
    private static final List<String> OF_TOURS = List.of("median", "p95", "sure");
    private static final List<String> SENSORS = List.of("laser", "sonar16", "sonar8");
    private static final List<int[]> SIZES = List.of(new int[] {500, 18}, new int[] {1000, 50}, new int[] {1000, 180});
    private static final int MANY_BEAMS = 180;
    private static final int ROBOTS = 100;
    private static final List<String> SENSORS_OF_MANY = List.of("laser", "sonar16");
    private static final int SEEDS = 50;
    private static final int SCANS = 40;
    private static final int DRIVES = 20;
    private static final int KIDNAPPED = 40;
    private static final int MINUTE = 600; // ticks
    private static final int HALF_A_MINUTE = 300;
    private static final double WARM = 2; // [s]

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        for (int[] size : SIZES) {
            names.add(name(size, "ms"));
            names.add(name(size, "ns"));
            if (size[1] < MANY_BEAMS) {
                names.add(name(size, "beam.ns"));
            }
        }
        for (String sensor : SENSORS_OF_MANY) {
            names.add(nameOfMany(sensor));
            names.add(nameOfAlways(sensor));
        }
        SENSORS.forEach(sensor -> OF_TOURS.forEach(what -> names.add(nameOfTours(sensor) + what)));
        SENSORS.forEach(sensor -> OF_TOURS.forEach(what -> names.add(nameOfSimulated(sensor) + what)));
        names.add("amcl.kidnap.recovered");
        names.add("amcl.corridor.falseConfidence");
        for (String log : PublicLogs.NAMES) {
            OF_LOGS.forEach(what -> names.add(name(log) + what));
        }
        return names;
    }

    private static String name(int[] size, String what) {
        return "amcl.%dx%d.%s".formatted(size[0], size[1], what);
    }

    private static String nameOfTours(String sensor) {
        return "amcl.office.%s.".formatted(sensor);
    }

    private static String nameOfSimulated(String sensor) {
        return "amcl.office.simulated.%s.".formatted(sensor);
    }

    private static String nameOfMany(String sensor) {
        return "amcl.%drobots.%s.cores".formatted(ROBOTS, sensor);
    }

    private static String nameOfAlways(String sensor) {
        return "amcl.%drobots.%s.always.cores".formatted(ROBOTS, sensor);
    }

    private static String name(String log) {
        return "amcl.%s.".formatted(PublicLogs.label(log));
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var office = new Drive(new Maps(FileSource.disk()).read("office", Location.of("office")));
        for (int[] size : SIZES) {
            measure(office, size[0], size[1], assignment);
        }
        if (SIZES.stream().anyMatch(size -> assignment.wants(name(size, "ms")))) {
            assignment.show(timesBySize(office));
        }
        for (String sensor : SENSORS_OF_MANY) {
            measureMany(office, sensor, assignment);
        }
        for (String sensor : SENSORS) {
            publishBeliefs(nameOfTours(sensor), () -> tours(office, sensor), assignment);
            publishBeliefs(nameOfSimulated(sensor), () -> simulated(sensor), assignment);
        }
        if (assignment.wants("amcl.kidnap.recovered")) {
            assignment.report(Result.more("amcl.kidnap.recovered", "", recovered(office)));
        }
        if (assignment.wants("amcl.corridor.falseConfidence")) {
            assignment.report(Result.less("amcl.corridor.falseConfidence", "", falseConfidence()));
        }
        var overTime = new ArrayList<Point>();
        for (String log : PublicLogs.NAMES) {
            if (OF_LOGS.stream().anyMatch(what -> assignment.wants(name(log) + what))) {
                PublicLogs.drive(log, assignment).ifPresent(drive -> {
                    List<List<Replay.Step>> runs = onLog(name(log), drive, assignment);
                    assignment.report(judge(name(log), runs));
                    overTime.addAll(errorsOverTime(log, runs));
                });
            }
        }
        if (!overTime.isEmpty()) {
            assignment.show(new Plot.Lines(
                    "Localization on recorded logs, begun anywhere without being told where",
                    "scans",
                    "median error [m]",
                    overTime));
        }
    }

    private static void measure(Drive office, int particles, int beams, BenchmarkRequest assignment) {
        int[] size = {particles, beams};
        String name = name(size, "");
        if (Stream.of("ms", "ns", "beam.ns").noneMatch(what -> assignment.wants(name + what))) {
            return;
        }
        Updates few = updates(office, particles, beams, assignment.repeats());
        double[] ms = few.ms();
        double each = 1e6 / particles / few.hits();
        assignment.report(
                Result.less(name + "ms", "ms", ms),
                Result.less(
                        name + "ns",
                        "ns",
                        Arrays.stream(ms).map(one -> one * each).toArray()));
        if (assignment.wants(name + "beam.ns")) {
            Updates many = updates(office, particles, MANY_BEAMS, assignment.repeats());
            double eachMore = 1e6 / particles / (many.hits() - few.hits());
            assignment.report(Result.less(
                    name + "beam.ns",
                    "ns",
                    IntStream.range(0, ms.length)
                            .mapToDouble(i -> (many.ms()[i] - ms[i]) * eachMore)
                            .toArray()));
        }
    }

    private static void measureMany(Drive office, String sensor, BenchmarkRequest assignment) {
        if (!assignment.wants(nameOfMany(sensor)) && !assignment.wants(nameOfAlways(sensor))) {
            return;
        }
        var fleet = new LocalizedFleet(
                office,
                map(office, sensor),
                ROBOTS,
                HALF_A_MINUTE,
                (pose, random) -> look(office, sensor, pose, random));
        if (assignment.wants(nameOfMany(sensor))) {
            assignment.report(Result.less(nameOfMany(sensor), "cores", cores(fleet, settings(sensor), assignment)));
        }
        if (assignment.wants(nameOfAlways(sensor))) {
            assignment.report(
                    Result.less(nameOfAlways(sensor), "cores", cores(fleet, eachTime(settings(sensor)), assignment)));
        }
    }

    /// Of a first run, only for the machine to learn the code, nothing is told.
    private static double[] cores(LocalizedFleet fleet, Settings settings, BenchmarkRequest assignment) {
        fleet.cores(settings);
        return IntStream.range(0, assignment.repeats())
                .mapToDouble(_ -> fleet.cores(settings))
                .toArray();
    }

    /// As the device `amcl` has them if nobody says otherwise.
    private static Settings settings(String sensor) {
        return isLaser(sensor)
                ? settings(150, 5000, 15, SensorModel.Kind.FIELD)
                : settings(150, 5000, 3, SensorModel.Kind.BEAM);
    }

    private static Settings settings(int fewest, int most, double independentBeams, SensorModel.Kind model) {
        return new Settings(
                fewest,
                most,
                independentBeams,
                0.1,
                Math.toRadians(6),
                new OdometryModel(0.06, 0.05, 0.08),
                new Kld(0.05, 2.33),
                model);
    }

    private static Settings eachTime(Settings settings) {
        return new Settings(
                settings.minParticles(),
                settings.maxParticles(),
                settings.independentBeams(),
                0,
                0,
                settings.odometry(),
                settings.kld(),
                settings.model());
    }

    private static boolean isLaser(String sensor) {
        return sensor.equals("laser");
    }

    private static LocalizationMap map(Drive drive, String sensor) {
        return new LocalizationMap(drive.map(), isLaser(sensor) ? 0.1 : 0.25, 0.05);
    }

    private static Beams look(Drive drive, String sensor, Pose2d mapFromBase, SplittableRandom random) {
        return isLaser(sensor)
                ? Beams.of(drive.laser(mapFromBase, random), 60, 30)
                : Beams.of(drive.sonars(mapFromBase, sensor.equals("sonar16") ? 16 : 8, random), 5);
    }

    private static Plot timesBySize(Drive office) {
        var points = new ArrayList<Point>();
        for (int beams : List.of(18, 50, 180)) {
            for (int particles : List.of(100, 250, 500, 1000, 2000)) {
                double ms = updates(office, particles, beams, 1).ms()[0];
                points.add(new Point("%d beams".formatted(beams), particles, ms));
            }
        }
        return new Plot.Lines(
                "Localization in the office", "particles", "an update, time of the processor [ms]", points);
    }

    /// @param ms time of each repeat
    /// @param hits how many of a scan's beams hit something, in the mean: all that are looked at
    private record Updates(double[] ms, double hits) {}

    private static Updates updates(Drive office, int particles, int beams, int repeats) {
        var random = new SplittableRandom(1);
        List<Tick> ticks = office.tour(office.anywhere(random), MINUTE, random);
        List<Beams> seen = ticks.stream()
                .map(tick -> Beams.of(office.laser(tick.mapFromBase(), random), beams, 30))
                .toList();
        var map = new LocalizationMap(office.map(), 0.1, 0.05);
        var sinceStart = new Stopwatch();
        while (sinceStart.cpu() < WARM) {
            updateTime(map, ticks, seen, particles);
        }
        double[] ms = IntStream.range(0, repeats)
                .mapToDouble(_ -> updateTime(map, ticks, seen, particles))
                .toArray();
        return new Updates(ms, seen.stream().mapToInt(Beams::count).average().orElseThrow());
    }

    /// [ms]
    private static double updateTime(LocalizationMap map, List<Tick> ticks, List<Beams> seen, int particles) {
        var amcl = new Amcl(map, settings(particles, particles, 15, SensorModel.Kind.FIELD), new SplittableRandom(1));
        amcl.start(about(ticks.getFirst().mapFromBase()));
        var watch = new Stopwatch();
        for (int i = 0; i < ticks.size(); i++) {
            amcl.update(ticks.get(i).odomFromBase(), seen.get(i));
        }
        return watch.thread() * 1e3 / ticks.size(); // that of all threads is told in steps of 10 ms
    }

    static PoseEstimate about(Pose2d pose) {
        return PoseEstimate.of(pose, Covariance2d.ofDeviations(0.2, 0.2, Math.toRadians(10)));
    }

    /// What a robot believed at a tick.
    private record Belief(PoseEstimate estimate, Pose2d truth) {
        double error() {
            return estimate.mapFromBase().distanceTo(truth);
        }

        boolean near() {
            return estimate.mapFromBase().isNear(truth, Verdict.NEAR, Verdict.NEARLY);
        }

        boolean sure() {
            return estimate.quality() == Quality.LOCALIZED;
        }

        boolean falselySure() {
            return sure() && !near();
        }

        boolean rightlySure() {
            return sure() && near();
        }
    }

    private static List<Belief> follow(List<Tick> ticks, Amcl amcl, Function<Pose2d, Beams> look) {
        var beliefs = new ArrayList<Belief>();
        PoseEstimate estimate = amcl.update(
                ticks.getFirst().odomFromBase(), look.apply(ticks.getFirst().mapFromBase()));
        Pose2d odometry = ticks.getFirst().odomFromBase();
        for (Tick tick : ticks) {
            Supplier<Beams> beams = () -> look.apply(tick.mapFromBase());
            estimate = amcl.due(tick.odomFromBase(), beams)
                    ? amcl.update(tick.odomFromBase(), beams.get())
                    : estimate.moved(odometry.inverse().compose(tick.odomFromBase()));
            odometry = tick.odomFromBase();
            beliefs.add(new Belief(estimate, tick.mapFromBase()));
        }
        return beliefs;
    }

    private static double share(List<Belief> beliefs, Predicate<Belief> which) {
        return (double) beliefs.stream().filter(which).count() / beliefs.size();
    }

    private static void publishBeliefs(String name, Supplier<List<Belief>> drives, BenchmarkRequest assignment) {
        if (OF_TOURS.stream().noneMatch(what -> assignment.wants(name + what))) {
            return;
        }
        List<Belief> beliefs = drives.get();
        double[] errors = beliefs.stream().mapToDouble(Belief::error).sorted().toArray();
        assignment.report(
                Result.less(name + "median", "m", errors[errors.length / 2]),
                Result.less(name + "p95", "m", errors[(int) (0.95 * errors.length)]),
                Result.more(name + "sure", "", share(beliefs, Belief::rightlySure)));
    }

    /// Of all drives.
    private static List<Belief> simulated(String sensor) {
        Map<String, String> sensors = switch (sensor) {
            case "laser" -> Map.of("laser", "urg04lx");
            case "sonar16" -> Map.of("sonar", "front8rear8dx");
            default -> Map.of("sonar", "front8");
        };
        return IntStream.rangeClosed(1, DRIVES)
                .boxed()
                .flatMap(seed -> SimulatedDrive.run(sensors, seed, MINUTE).stream())
                .map(reported -> new Belief(reported.estimate(), reported.truth()))
                .toList();
    }

    /// Of all drives.
    private static List<Belief> tours(Drive office, String sensor) {
        LocalizationMap map = map(office, sensor);
        var beliefs = new ArrayList<Belief>();
        for (int seed = 1; seed <= DRIVES; seed++) {
            var random = new SplittableRandom(seed);
            List<Tick> ticks = office.tour(office.anywhere(random), MINUTE, random);
            var amcl = new Amcl(map, settings(sensor), random);
            amcl.start(about(ticks.getFirst().mapFromBase()));
            beliefs.addAll(follow(ticks, amcl, pose -> look(office, sensor, pose, random)));
        }
        return beliefs;
    }

    private static double recovered(Drive office) {
        var map = new LocalizationMap(office.map(), 0.1, 0.05);
        int recovered = 0;
        for (int seed = 1; seed <= KIDNAPPED; seed++) {
            var random = new SplittableRandom(seed);
            List<Tick> before = office.tour(office.anywhere(random), HALF_A_MINUTE, random);
            List<Tick> after = office.tour(office.anywhere(random), HALF_A_MINUTE, random);
            var amcl = new Amcl(map, settings(150, 5000, 15, SensorModel.Kind.FIELD), random);
            amcl.start(about(before.getFirst().mapFromBase()));
            List<Belief> beliefs =
                    follow(Drive.kidnapped(before, after), amcl, pose -> Beams.of(office.laser(pose, random), 60, 30));
            List<Belief> last = beliefs.subList(beliefs.size() - 10, beliefs.size());
            recovered += last.stream().allMatch(Belief::rightlySure) ? 1 : 0;
        }
        return (double) recovered / KIDNAPPED;
    }

    private static double falseConfidence() {
        var corridor = new Drive(corridor());
        var map = new LocalizationMap(corridor.map(), 0.1, 0.05);
        var beliefs = new ArrayList<Belief>();
        for (int seed = 1; seed <= DRIVES; seed++) {
            var random = new SplittableRandom(seed);
            List<Tick> ticks = corridor.shuttle(new Point2d(8, 2), new Point2d(32, 2), MINUTE, random);
            var amcl = new Amcl(map, settings(150, 5000, 15, SensorModel.Kind.FIELD), random);
            beliefs.addAll(follow(ticks, amcl, pose -> Beams.of(corridor.laser(pose, random), 60, 30)));
        }
        return share(beliefs, Belief::falselySure);
    }

    /// 40 m × 2 m, with recesses of doors that lie where half a turn puts them.
    private static OccupancyGrid corridor() {
        int width = 800;
        int height = 80;
        var cells = new byte[width * height];
        Arrays.fill(cells, OccupancyGrid.OCCUPIED);
        for (int column = 2; column < width - 2; column++) {
            boolean door = column % 200 >= 90 && column % 200 < 110;
            boolean doorOfTurned = (width - 1 - column) % 200 >= 90 && (width - 1 - column) % 200 < 110;
            for (int row = doorOfTurned ? 16 : 20; row < (door ? 64 : 60); row++) {
                cells[row * width + column] = OccupancyGrid.FREE;
            }
        }
        return new OccupancyGrid(width, height, 0.05, 0, 0, cells);
    }

    /// Steps of each run.
    private static List<List<Replay.Step>> onLog(String name, RecordedDrive drive, BenchmarkRequest assignment) {
        var map = new LocalizationMap(
                ScanMapper.draw(drive.only(i -> i % 2 == 0).posed(), ScanMapper.Settings.of(0.05)), 0.1, 0.05);
        RecordedDrive rest = drive.only(i -> i % 2 == 1);
        var runs = new ArrayList<List<Replay.Step>>();
        for (int seed = 1; seed <= SEEDS; seed++) {
            var random = new SplittableRandom(seed);
            int first = random.nextInt(rest.stops().size() - SCANS + 1);
            RecordedDrive driven =
                    rest.only(i -> i >= first && i < first + SCANS).drifting(Drive.WHEELS, random);
            var amcl = new Amcl(map, Settings.of(150, 5000), random);
            runs.add(Replay.run(driven, amcl, new Replay.Look(60, 30), () -> 0));
            assignment.reach(name + "runs", seed, SEEDS);
        }
        return runs;
    }

    private static List<Point> errorsOverTime(String log, List<List<Replay.Step>> runs) {
        return IntStream.range(0, SCANS)
                .mapToObj(scan -> new Point(
                        log,
                        scan + 1.0,
                        Verdict.median(runs.stream()
                                .mapToDouble(run -> run.get(scan).error().orElse(Double.NaN))
                                .toArray())))
                .toList();
    }

    private static List<Result> judge(String name, List<List<Replay.Step>> runs) {
        List<Verdict> verdicts = runs.stream().map(Verdict::of).toList();
        Verdict.Pooled pooled = Verdict.pooled(verdicts);
        return List.of(
                Result.more(
                        name + "converged",
                        "",
                        share(verdicts, v -> v.converged().orElse(SCANS) <= 10 ? 1 : 0)),
                Result.less(name + "rmse", "m", pooled.rmse()),
                Result.less(name + "worst", "m", pooled.worstRmse()),
                Result.less(name + "p95", "m", pooled.p95()),
                Result.less(name + "falseConfidence", "", share(verdicts, v -> (double) v.falselySure() / v.judged())));
    }

    private static double share(List<Verdict> verdicts, Function<Verdict, Number> of) {
        return verdicts.stream()
                .mapToDouble(verdict -> of.apply(verdict).doubleValue())
                .average()
                .orElseThrow();
    }
}
