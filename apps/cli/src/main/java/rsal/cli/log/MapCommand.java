package rsal.cli.log;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.map.RosMap;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.carmen.CarmenLog;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.replay.Course;
import rsal.navigation.slam.FreeSpaceViolation;
import rsal.navigation.slam.GraphResidual;
import rsal.navigation.slam.Merge;
import rsal.navigation.slam.Relation;
import rsal.navigation.slam.RelationError;
import rsal.navigation.slam.Shared;
import rsal.navigation.slam.Slam;
import rsal.navigation.slam.Turns;
import rsal.scenario.text.Counted;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.time.AllowedToReadWallClock;

/// `rsal map`
@Command(
        name = "map",
        description = "Draw a map from a robot's log, or one from those of several robots.",
        footer = {
            "",
            LogOptions.LOGS + " Written are"
                    + " map.yaml and map.pgm as ROS reads them, picture.png with ways (blue) and places that were"
                    + " known again (red), trajectory.txt as TUM writes it (time x y z qx qy qz qw), and residuals.csv.",
            "Errors are told against the poses in the log, or in that of --reference. In 'corrected' logs the"
                    + " odometry is these poses, without any error: add some with --odometry-noise.",
            "",
            "  rsal map lab.log.gz --out lab",
            "  rsal map lab-corrected.log.gz --odometry-noise 0.05,2,3 --seed 1 --out lab --json",
            "  rsal map first-robot.log second-robot.log --out both",
            ""
        })
@AllowedToReadWallClock("Tells how long it took.")
public final class MapCommand extends Subcommand {
    private static final double NEAR = 2; // m; relations between poses that do not follow on each other

    @Parameters(index = "0..*", arity = "1..*", paramLabel = "LOG", description = "The log's file; one for each robot.")
    private List<String> files = List.of();

    @Option(names = "--out", required = true, paramLabel = "DIR", description = "The folder to write to.")
    private String out = "";

    @Option(names = "--force", description = "Overwrite files that are there.")
    private boolean force;

    @Option(
            names = "--despite-contradictions",
            description = "Join maps of several logs, too, when what one robot saw contradicts what another did, as"
                    + " where a box was moved between their runs.")
    private boolean despiteContradictions;

    @Option(names = "--known-poses", description = "The log's poses are right: only draw.")
    private boolean knownPoses;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private LogOptions recorded;

    @Option(names = "--seed", paramLabel = "N", description = "Of the noise (1). The same seed gives the same map.")
    private long seed = 1;

    @Option(names = "--resolution", paramLabel = "M", description = "Side of a cell of the map [m] (0.05).")
    private double resolution = 0.05;

    @Option(names = "--max-range", paramLabel = "M", description = "Ranges beyond this are not looked at [m] (25).")
    private double maxRange = 25;

    @Option(
            names = "--free-range",
            paramLabel = "M",
            description =
                    "How far a beam that hit nothing makes the map free [m] (0). With 0 such beams say nothing: many"
                            + " lasers lose the echo of glass and of dark walls.")
    private double freeRange;

    /// Errors against poses that are right.
    ///
    /// @param relations looked at
    /// @param meters mean
    /// @param degrees mean
    record Errors(int relations, double meters, double degrees) {
        static Optional<Errors> of(RelationError error) {
            return error.count() == 0
                    ? Optional.empty()
                    : Optional.of(new Errors(error.count(), error.meters(), Math.toDegrees(error.radians())));
        }
    }

    /// What became of a log.
    ///
    /// @param kept scans in the graph
    /// @param loops places known again
    /// @param odometry error of the wheels from a scan to the next; null when nothing tells
    /// @param next likewise of the map
    /// @param near error between scans near each other that do not follow on each other
    /// @param turns at which both wheels and scans tell; null when poses were known
    /// @param wandering null when the laser stays where it is mounted
    record Drawn(
            String log,
            int scans,
            int untold,
            Map<String, Integer> skipped,
            int kept,
            long loops,
            @Nullable Errors odometry,
            @Nullable Errors next,
            @Nullable Errors near,
            @Nullable Turned turns,
            @Nullable Wandered wandering) {}

    /// Whether scans say that the robot turned as its wheels do.
    ///
    /// @param count of steps at which both tell
    /// @param opposed of them, at which they turned different ways
    /// @param reversed whether that is so at most of them, as with a laser that is upside down
    record Turned(int count, int opposed, boolean reversed) {
        static Turned of(Turns turns) {
            return new Turned(turns.count(), turns.opposed(), turns.isReversed());
        }
    }

    /// How far a laser moves on its robot, as a log has it: its poses were taken for corrected ones of the robot.
    record Wandered(double meters, double degrees) {
        static @Nullable Wandered of(CarmenLog log) {
            return log.wandering()
                    .map(by -> new Wandered(by.meters(), Math.toDegrees(by.radians())))
                    .orElse(null);
        }
    }

    /// A step of a robot's way, by numbers of the scans that were kept, and how far off the map is what was told of it.
    ///
    /// @param deviations as whoever told it errs
    record Bent(int from, int to, double meters, double degrees, double deviations) {
        static @Nullable Bent of(Optional<GraphResidual.Step> step) {
            return step.map(s -> new Bent(s.from(), s.to(), s.meters(), Math.toDegrees(s.radians()), s.deviations()))
                    .orElse(null);
        }
    }

    /// How much the map bends what it was told.
    ///
    /// @param wheels the step that is farthest off what the wheels say
    /// @param scans likewise of what scans say
    /// @param all the step that is farthest off all that was told of it
    /// @param tooMuch whether that is so far that the map is probably wrong
    /// @param steps of the way
    /// @param blind of them, told by wheels alone
    record Strained(
            @Nullable Bent wheels,
            @Nullable Bent scans,
            @Nullable Bent all,
            boolean tooMuch,
            int steps,
            int blind) {
        static Strained of(GraphResidual strain) {
            return new Strained(
                    Bent.of(strain.wheels()),
                    Bent.of(strain.scans()),
                    Bent.of(strain.all()),
                    strain.tooMuch().isPresent(),
                    strain.steps(),
                    strain.blind());
        }
    }

    /// Beams that go through what other scans saw as walls.
    ///
    /// @param share of the beams of the scans from one to another, where it is most
    /// @param from number of the first of these, of those that were kept
    /// @param to number of the last
    /// @param tooMuch whether that is so much that the map is probably wrong there
    record ThroughWalls(double share, int from, int to, boolean tooMuch) {
        static @Nullable ThroughWalls of(Optional<FreeSpaceViolation> most) {
            return most.map(c -> new ThroughWalls(c.share(), c.from(), c.to(), c.isTooMuch()))
                    .orElse(null);
        }
    }

    /// Where the map of a log lies in that of the first, and what spoke for it when it was joined to those before it.
    ///
    /// @param x of its frame in that of the first, now that all are joined [m]
    /// @param y likewise
    /// @param degrees likewise, the heading
    /// @param squareMeters of floor that both saw
    /// @param against share of the cells hit by either, within that floor, that the other saw as free
    /// @param tooMuch whether that is so much that they are joined only as that was asked for
    /// @param worst where most of that is; null when there is none
    /// @param throughWalls share of the beams of either that go through what the other hit
    record Merged(
            String log,
            double x,
            double y,
            double degrees,
            double squareMeters,
            double against,
            boolean tooMuch,
            @Nullable Clash worst,
            double throughWalls) {
        static Merged of(String log, Pose2d at, Shared shared, @Nullable Clash worst) {
            return new Merged(
                    log,
                    at.x(),
                    at.y(),
                    Math.toDegrees(at.theta()),
                    shared.squareMeters(),
                    shared.against(),
                    shared.isContradicted(),
                    worst,
                    shared.through());
        }
    }

    /// A place in the first log's map where one log saw something stand, and another free floor.
    ///
    /// @param hitBy that log
    /// @param freeBy the other
    record Clash(double x, double y, String hitBy, String freeBy) {
        String words() {
            return "at (%.1f, %.1f), where (%s) hit what (%s) saw free".formatted(x, y, hitBy, freeBy);
        }
    }

    /// @param merged the logs after the first
    /// @param columns of the map
    /// @param rows of the map
    /// @param strain null when poses were known
    /// @param contradiction likewise, and when there were too few scans to tell
    record Result(
            List<Drawn> logs,
            List<Merged> merged,
            @Nullable Strained strain,
            @Nullable ThroughWalls contradiction,
            int columns,
            int rows,
            double resolution,
            double seconds,
            List<String> files) {}

    /// One robot's scans and, while they are mapped, where they are in the graph.
    private record Robot(String file, CarmenLog log, Course course, List<Slam.Located> located) {}

    @Override
    protected int run() throws IOException {
        check(
                resolution >= 0.005 && resolution <= 10,
                "--resolution must be 0.005 to 10 m, not (%s).".formatted(resolution));
        check(maxRange > 0, "--max-range must be more than 0 m, not (%s).".formatted(maxRange));
        check(freeRange >= 0, "--free-range must be 0 m or more, not '%s'.".formatted(freeRange));
        recorded.checkOptions();
        if (knownPoses && (files.size() > 1 || recorded.hasNoise())) {
            throw new ParameterException(
                    spec.commandLine(), "--known-poses goes with one log and without --odometry-noise.");
        }
        if (knownPoses && recorded.isWithoutReference()) {
            throw new ParameterException(
                    spec.commandLine(), "--known-poses draws by poses that --no-reference says are not right.");
        }
        check(!despiteContradictions || files.size() > 1, "--despite-contradictions goes with two logs or more.");
        if (recorded.hasReference() && files.size() > 1) {
            throw new ParameterException(spec.commandLine(), "--reference goes with one log.");
        }
        long start = System.nanoTime();
        Destination folder = Destination.of(out, fileNames(), force);
        List<Robot> robots = robots();
        folder.prepare();
        Slam slam;
        var contents = new LinkedHashMap<String, byte[]>();
        OccupancyGrid grid;
        List<Drawn> drawn;
        var merged = new ArrayList<Merged>();
        if (knownPoses) {
            Robot robot = robots.getFirst();
            slam = new Slam(Slam.Settings.DEFAULT);
            grid = grid(robot, robot.course().posed());
            drawn = List.of(new Drawn(
                    robot.file(),
                    robot.course().stops().size(),
                    robot.course().untold(),
                    robot.log().skipped().counts(),
                    robot.course().stops().size(),
                    0,
                    null,
                    null,
                    null,
                    null,
                    Wandered.of(robot.log())));
        } else {
            var slams = new ArrayList<Slam>();
            var all = new ArrayList<Drawn>();
            for (Robot robot : robots) {
                Slam own = mapped(robot);
                slams.add(own);
                all.add(drawn(robot, own));
            }
            drawn = all;
            slam = slams.getFirst();
            var starts = new ArrayList<>(List.of(0)); // numbers of the robots' first scans in the whole graph
            var shared = new ArrayList<Shared>();
            for (int i = 1; i < slams.size(); i++) {
                starts.add(slam.frameCount());
                shared.add(merge(slam, slams.get(i), starts));
            }
            for (int i = 1; i < slams.size(); i++) { // not before: each that joins moves the others a little
                Shared both = shared.get(i - 1);
                merged.add(Merged.of(
                        files.get(i),
                        mapFromOwn(slam, slams.get(i), starts.get(i)),
                        both,
                        worst(both, starts).orElse(null)));
            }
            grid = grid(robots.getFirst(), slam.posedScans());
            for (int i = 0; i < robots.size(); i++) {
                contents.put(trajectoryName(i), text(trajectory(robots.get(i), slams.get(i), slam, starts.get(i))));
            }
            contents.put("residuals.csv", text(residuals(slam)));
        }
        contents.put("map.pgm", RosMap.pgm(grid));
        contents.put("map.yaml", text(RosMap.yaml(grid, "map.pgm")));
        contents.put("picture.png", MapPicture.png(grid, slam));
        folder.write(contents);
        GraphResidual strain = slam.strain();
        Optional<FreeSpaceViolation> contradiction = slam.contradiction();
        double seconds = Duration.ofNanos(System.nanoTime() - start).toMillis() / 1e3;
        var result = new Result(
                drawn,
                merged,
                knownPoses ? null : Strained.of(strain),
                ThroughWalls.of(contradiction), // of no scans when poses are known
                grid.width(),
                grid.height(),
                resolution,
                seconds,
                contents.keySet().stream()
                        .map(f -> folder.resolve(f).toString())
                        .toList());
        robots.forEach(robot -> LogOptions.tellSkipped(err(), robot.file(), robot.log()));
        robots.forEach(robot -> LogOptions.tellWandering(err(), robot.file(), robot.log()));
        robots.forEach(robot -> LogOptions.tellOddities(err(), robot.file(), robot.log()));
        drawn.forEach(this::warn);
        merged.stream().filter(Merged::tooMuch).forEach(this::warn);
        contradiction.filter(FreeSpaceViolation::isTooMuch).ifPresent(most -> warn(most, slam));
        strain.tooMuch().ifPresent(step -> warn(step, slam));
        if (json) {
            printJson(result);
        } else {
            tell(result);
        }
        return Exit.SUCCESS;
    }

    private String trajectoryName(int log) {
        return files.size() == 1 ? "trajectory.txt" : "trajectory-%d.txt".formatted(log + 1);
    }

    private List<String> fileNames() {
        var names = new ArrayList<>(List.of("map.yaml", "map.pgm", "picture.png"));
        if (!knownPoses) {
            names.add("residuals.csv");
            IntStream.range(0, files.size()).forEach(i -> names.add(trajectoryName(i)));
        }
        return names;
    }

    private List<Robot> robots() {
        Optional<OdometryModel> noise = recorded.noise();
        var random = new SplittableRandom(seed);
        var robots = new ArrayList<Robot>();
        for (String file : files) {
            CarmenLog log = recorded.read(file);
            Course course = recorded.course(log, file);
            if (course.stops().isEmpty() || (knownPoses && course.posed().isEmpty())) {
                throw LogOptions.nothingKnown(file, knownPoses ? "pose" : "odometry", log);
            }
            LogOptions.checkReturns(file, course);
            robots.add(new Robot(
                    file,
                    log,
                    noise.isPresent() ? course.drifting(noise.get(), random.split()) : course,
                    new ArrayList<>()));
        }
        return robots;
    }

    private Slam mapped(Robot robot) {
        var slam = new Slam(Slam.Settings.DEFAULT.within(maxRange));
        List<Course.Stop> stops = robot.course().stops();
        long told = System.nanoTime();
        for (Course.Stop stop : stops) {
            robot.located().add(slam.add(stop.odomFromBase(), stop.scan()));
            if (System.nanoTime() - told > 2_000_000_000L) {
                told = System.nanoTime();
                err().println("%s: %d of %d scans, %d kept, %d places known again so far"
                        .formatted(robot.file(), robot.located().size(), stops.size(), slam.frameCount(), loops(slam)));
            }
        }
        slam.polish(2);
        return slam;
    }

    private static long loops(Slam slam) {
        return slam.relations().stream()
                .filter(r -> r.source() == Relation.Source.LOOP)
                .count();
    }

    /// @param starts of the robots so far, the other's last
    private Shared merge(Slam slam, Slam other, List<Integer> starts) {
        String file = files.get(starts.size() - 1);
        String before = String.join(", ", files.subList(0, starts.size() - 1));
        Merge merged;
        try {
            merged = despiteContradictions ? slam.mergeDespiteContradictions(other) : slam.merge(other);
        } catch (IllegalArgumentException e) {
            throw new InvalidSettings(
                    Location.of(file), String.valueOf(e.getMessage()), "Map fewer logs, or parts of them.");
        }
        return switch (merged) {
            case Merge.Done done -> done.shared();
            case Merge.Contradicted(Pose2d place, Shared shared) ->
                throw new InvalidSettings(
                        Location.of(file),
                        "Its map fits that of (%s), moved by (%s), but they contradict each other: %s."
                                .formatted(before, words(place), against(shared.against(), worst(shared, starts))),
                        "Maybe these are two places that look alike. If something was moved there between the runs,"
                                + " join them with --despite-contradictions.");
            case Merge.Apart _ ->
                throw new InvalidSettings(
                        Location.of(file),
                        "Nothing tells that its map shares a place with that of (%s).".formatted(before),
                        "Maybe the robots saw different places, or too little of the same: let one drive through"
                                + " more of what the other saw.");
            case Merge.Ambiguous(Pose2d one, Pose2d rival) ->
                throw new InvalidSettings(
                        Location.of(file),
                        "Its map fits that of (%s) in two ways: moved by (%s), or by (%s)."
                                .formatted(before, words(one), words(rival)),
                        "Maybe the place looks the same from two sides; let the robots see more of what tells them"
                                + " apart, or map the logs one by one.");
        };
    }

    private static String against(double share, Optional<Clash> worst) {
        return ("of what either hit in the floor that both saw, %.2f%% stands in what the other saw free, %.1f m and"
                        + " more from all it hit (at most %.1f%% in maps that share a place)%s")
                .formatted(
                        100 * share,
                        Shared.NEAR,
                        100 * Shared.MOST_AGAINST,
                        worst.map(c -> ", most of it " + c.words()).orElse(""));
    }

    private Optional<Clash> worst(Shared shared, List<Integer> starts) {
        return shared.worst().map(c -> new Clash(c.x(), c.y(), fileOf(c.hitBy(), starts), fileOf(c.freeBy(), starts)));
    }

    private String fileOf(int scan, List<Integer> starts) {
        int robot = starts.size() - 1;
        while (starts.get(robot) > scan) {
            robot--;
        }
        return files.get(robot);
    }

    /// Where the frame of a robot's own map is in the whole one.
    ///
    /// @param start number of its first scan there
    private static Pose2d mapFromOwn(Slam whole, Slam own, int start) {
        int last = own.frameCount() - 1;
        return whole.poses().get(start + last).compose(own.poses().get(last).inverse());
    }

    private static String words(Pose2d pose) {
        return "%.1f m, %.1f m, %.0f°".formatted(pose.x(), pose.y(), Math.toDegrees(pose.theta()));
    }

    private static Drawn drawn(Robot robot, Slam slam) {
        var right = new ArrayList<Pose2d>();
        var wheels = new ArrayList<Pose2d>();
        var judged = new ArrayList<Pose2d>();
        List<Course.Stop> stops = robot.course().stops();
        for (int i = 0; i < stops.size(); i++) {
            Course.Stop stop = stops.get(i);
            Slam.Located located = robot.located().get(i);
            stop.mapFromBase().ifPresent(pose -> {
                right.add(pose);
                wheels.add(stop.odomFromBase());
                judged.add(slam.pose(located));
            });
        }
        return new Drawn(
                robot.file(),
                stops.size(),
                robot.course().untold(),
                robot.log().skipped().counts(),
                slam.frameCount(),
                loops(slam),
                Errors.of(RelationError.ofNext(right, wheels)).orElse(null),
                Errors.of(RelationError.ofNext(right, judged)).orElse(null),
                Errors.of(RelationError.ofNear(right, judged, NEAR)).orElse(null),
                Turned.of(slam.turns()),
                Wandered.of(robot.log()));
    }

    private OccupancyGrid grid(Robot robot, List<ScanMapper.PosedScan> scans) {
        try {
            return ScanMapper.draw(
                    scans,
                    ScanMapper.Settings.of(resolution)
                            .upTo(Math.min(maxRange, ScanMapper.Settings.FARTHEST), Math.min(maxRange, freeRange)));
        } catch (IllegalArgumentException e) {
            throw new InvalidSettings(
                    Location.of(robot.file()), String.valueOf(e.getMessage()), "Try a larger --resolution.");
        }
    }

    /// @param offset number of the robot's first frame in the whole graph
    private static String trajectory(Robot robot, Slam own, Slam whole, int offset) {
        var text = new StringBuilder("# time x y z qx qy qz qw\n");
        List<Course.Stop> stops = robot.course().stops();
        for (int i = 0; i < stops.size(); i++) {
            Slam.Located at = robot.located().get(i);
            Pose2d pose =
                    whole == own ? own.pose(at) : whole.pose(new Slam.Located(at.frame() + offset, at.frameFromBase()));
            Instant time = stops.get(i).time();
            text.append("%d.%06d %.6f %.6f 0 0 0 %.9f %.9f%n"
                    .formatted(
                            time.getEpochSecond(),
                            time.getNano() / 1000,
                            pose.x(),
                            pose.y(),
                            Math.sin(pose.theta() / 2),
                            Math.cos(pose.theta() / 2)));
        }
        return text.toString();
    }

    private static String residuals(Slam slam) {
        var text = new StringBuilder("from,to,source,x,y,degrees,meters_off,degrees_off,deviations_off\n");
        for (Relation relation : slam.relations()) {
            Pose2d told = relation.fromFromTo();
            Pose2d off = told.inverse()
                    .compose(slam.poses()
                            .get(relation.from())
                            .inverse()
                            .compose(slam.poses().get(relation.to())));
            text.append("%d,%d,%s,%.4f,%.4f,%.3f,%.4f,%.3f,%.2f%n"
                    .formatted(
                            relation.from(),
                            relation.to(),
                            relation.source().name().toLowerCase(Locale.ROOT),
                            told.x(),
                            told.y(),
                            Math.toDegrees(told.theta()),
                            Math.hypot(off.x(), off.y()),
                            Math.toDegrees(off.theta()),
                            slam.residual(relation)));
        }
        return text.toString();
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private void tell(Result result) {
        for (Drawn log : result.logs()) {
            out().println("%s: %s, %d kept, %s known again"
                    .formatted(
                            log.log(), Counted.of(log.scans(), "scan"), log.kept(), Counted.of(log.loops(), "place")));
            tell("wheels, scan to scan", log.odometry());
            tell("map, scan to scan", log.next());
            tell("map, scans within %.0f m".formatted(NEAR), log.near());
        }
        for (Merged one : result.merged()) {
            out().println(
                            ("%s lies at %.2f m, %.2f m, %.1f° in the map of %s: both saw %.0f m² of floor, %.2f%% of what was"
                                            + " hit there stands in what the other saw free, %.0f%% of the beams go through walls")
                                    .formatted(
                                            one.log(),
                                            one.x(),
                                            one.y(),
                                            one.degrees(),
                                            files.getFirst(),
                                            one.squareMeters(),
                                            100 * one.against(),
                                            100 * one.throughWalls()));
            if (one.tooMuch() && one.worst() != null) {
                out().println("  they contradict each other: %.2f%% is more than %.1f%%, most of it %s"
                        .formatted(
                                100 * one.against(),
                                100 * Shared.MOST_AGAINST,
                                one.worst().words()));
            }
        }
        if (result.strain() != null) {
            tell(result.strain());
        }
        if (result.contradiction() != null) {
            out().println("  %-24s %.0f%% of the beams (scan %d to %d)"
                    .formatted(
                            "through walls, at most",
                            100 * result.contradiction().share(),
                            result.contradiction().from(),
                            result.contradiction().to()));
        }
        out().println("%d × %d cells of %s m, %.1f s"
                .formatted(result.columns(), result.rows(), result.resolution(), result.seconds()));
        result.files().forEach(out()::println);
        out().flush();
    }

    private void warn(GraphResidual.Step step, Slam slam) {
        Pose2d place = slam.poses().get(step.to());
        err().println(("The map is probably wrong: at (%.1f, %.1f), from scan (%d) to (%d) of those kept, it is off"
                        + " all that was told of the robot's way, by (%.2f m) and (%.0f°) at least, %.0f times as much"
                        + " as that errs. Maybe places that look alike were taken for one: look at picture.png, and map"
                        + " the log in parts. Or the robot was carried there; then the map may be right.")
                .formatted(
                        place.x(),
                        place.y(),
                        step.from(),
                        step.to(),
                        step.meters(),
                        Math.toDegrees(step.radians()),
                        step.deviations()));
    }

    private void warn(Merged one) {
        err().println(("The map is probably wrong: (%s) contradicts what it was joined to, %s. Maybe these are two"
                        + " places that look alike, or something was moved there between the runs; then the map may be"
                        + " right.")
                .formatted(one.log(), against(one.against(), Optional.ofNullable(one.worst()))));
    }

    private void warn(Drawn log) {
        if (log.turns() != null && log.turns().reversed()) {
            err().println(("The map is probably mirrored: at %d of %d turns of (%s) scans say that the robot turned the"
                            + " other way than its wheels do. Maybe the laser is mounted upside down: try --upside-down.")
                    .formatted(log.turns().opposed(), log.turns().count(), log.log()));
        }
    }

    private void warn(FreeSpaceViolation most, Slam slam) {
        Pose2d from = slam.poses().get(most.from());
        Pose2d to = slam.poses().get(most.to());
        err().println(("The map is probably wrong: from (%.1f, %.1f) to (%.1f, %.1f), scans (%d) to (%d) of those kept,"
                        + " %.0f%% of the beams go through what others saw as walls, so parts of the place were laid onto"
                        + " each other. Maybe the robot was carried, or places that look alike were taken for one: look"
                        + " at picture.png, and map the log in parts.")
                .formatted(from.x(), from.y(), to.x(), to.y(), most.from(), most.to(), 100 * most.share()));
    }

    private void tell(Strained strain) {
        tell("wheels, at most", strain.wheels());
        tell("scans, at most", strain.scans());
        tell("all that was told", strain.all());
        if (strain.blind() > 0) {
            out().println("  no scan tells of %d of %d steps: there the map is as right as the wheels"
                    .formatted(strain.blind(), strain.steps()));
        }
    }

    private void tell(String what, @Nullable Bent bent) {
        if (bent != null) {
            out().println("  %-24s bent by %.2f m, %.1f°, %.1f deviations (scan %d to %d)"
                    .formatted(what, bent.meters(), bent.degrees(), bent.deviations(), bent.from(), bent.to()));
        }
    }

    private void tell(String what, @Nullable Errors errors) {
        if (errors != null) {
            out().println("  %-24s off %.3f m, %.2f° (%d relations)"
                    .formatted(what, errors.meters(), errors.degrees(), errors.relations()));
        }
    }
}
