package rsal.cli.log;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.log.LogMapper.Robot;
import rsal.cli.log.MapResult.Drawn;
import rsal.cli.log.MapResult.Merged;
import rsal.cli.log.MapResult.Residuals;
import rsal.cli.log.MapResult.ThroughWalls;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.data.OccupancyGrid;
import rsal.map.RosMap;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.log.RobotLog;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.slam.FreeSpaceViolation;
import rsal.navigation.slam.GraphResidual;
import rsal.navigation.slam.Slam;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.time.AllowedToReadWallClock;

/// `rsal map`
@Command(
        name = "map",
        description = "Make a map from the log of a robot, or one map from the logs of several robots.",
        footer = {
            "",
            LogOptions.LOGS + " The command writes: map.yaml and map.pgm in the format of ROS; picture.png with"
                    + " paths (blue) and loop closures (red); trajectory.txt in the format of TUM (time x y z qx"
                    + " qy qz qw); residuals.csv.",
            "Errors are relative to the poses in the log, or in that of --reference. In 'corrected' logs the odometry"
                    + " equals these poses, without any error: add noise by --odometry-noise.",
            "",
            "  rsal map lab.log.gz --out lab",
            "  rsal map lab-corrected.log.gz --odometry-noise 0.05,2,3 --seed 1 --out lab --json",
            "  rsal map first-robot.log second-robot.log --out both",
            ""
        })
@AllowedToReadWallClock("Tells how long it took.")
public final class MapCommand extends Subcommand {
    @Parameters(
            index = "0..*",
            arity = "1..*",
            converter = FileName.class,
            paramLabel = "LOG",
            description = "The log's file; one for each robot.")
    private List<String> files = List.of();

    @Option(names = "--out", required = true, paramLabel = "DIR", description = "The folder to write to.")
    private String out = "";

    @Option(names = "--force", description = "Overwrite existing files.")
    private boolean force;

    @Option(
            names = "--despite-contradictions",
            description = "Merge maps of several logs even if they contradict each other, for example because a box"
                    + " was moved between the runs.")
    private boolean despiteContradictions;

    @Option(names = "--known-poses", description = "The log's poses are right: only draw the map.")
    private boolean knownPoses;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private LogOptions recorded;

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "Seed of the noise (1). The same seed gives the same map.")
    private long seed = 1;

    @Option(names = "--resolution", paramLabel = "M", description = "Side of a cell of the map [m] (0.05).")
    private double resolution = 0.05;

    @Option(names = "--max-range", paramLabel = "M", description = "Longer ranges are ignored [m] (25).")
    private double maxRange = 25;

    @Option(
            names = "--free-range",
            paramLabel = "M",
            description =
                    "Length to which a beam without an echo draws free space [m] (0). With 0 such beams are ignored:"
                            + " many lasers get no echo from glass and dark walls.")
    private double freeRange;

    /// @param slam without scans when poses are known
    /// @param ways files of the robots' ways, by name
    private record Made(
            Slam slam, List<Drawn> logs, List<Merged> merged, OccupancyGrid grid, Map<String, byte[]> ways) {}

    @Override
    protected int run() throws IOException {
        checkOptions();
        long start = System.nanoTime();
        Destination folder = Destination.of(out, fileNames(), force);
        List<Robot> robots = robots();
        folder.prepare();
        Made made = knownPoses ? drawn(robots.getFirst()) : mapped(robots);
        Map<String, byte[]> contents = contents(made);
        folder.write(contents);
        GraphResidual residual = made.slam().graphResidual();
        Optional<FreeSpaceViolation> contradiction = made.slam().contradiction(); // of no scans when poses are known
        var result = new MapResult(
                made.logs(),
                made.merged(),
                knownPoses ? null : Residuals.of(residual),
                ThroughWalls.of(contradiction),
                made.grid().width(),
                made.grid().height(),
                resolution,
                Duration.ofNanos(System.nanoTime() - start).toMillis() / 1e3,
                contents.keySet().stream()
                        .map(f -> folder.resolve(f).toString())
                        .toList());
        robots.forEach(robot -> printOfLog(robot.file(), robot.log()));
        var report = new MapReport(out(), err());
        report.warn(result, made.slam(), residual, contradiction);
        if (json) {
            printJson(result);
        } else {
            report.print(result);
        }
        return Exit.SUCCESS;
    }

    private Made drawn(Robot robot) {
        return new Made(
                new Slam(Slam.Settings.DEFAULT),
                List.of(Drawn.ofKnownPoses(robot.file(), robot.drive(), robot.log())),
                List.of(),
                grid(robot, robot.drive().posed()),
                Map.of());
    }

    private Made mapped(List<Robot> robots) {
        var mapper = new LogMapper(robots, maxRange, despiteContradictions, err());
        mapper.map();
        var ways = new LinkedHashMap<String, byte[]>();
        for (int i = 0; i < robots.size(); i++) {
            ways.put(trajectoryName(i), text(mapper.trajectory(i)));
        }
        ways.put("residuals.csv", text(LogMapper.residuals(mapper.whole())));
        OccupancyGrid grid = grid(robots.getFirst(), mapper.whole().posedScans());
        return new Made(mapper.whole(), mapper.drawn(), mapper.merged(), grid, ways);
    }

    /// Of the files to be written, by name.
    private static Map<String, byte[]> contents(Made made) throws IOException {
        var contents = new LinkedHashMap<>(made.ways());
        contents.put("map.pgm", RosMap.pgm(made.grid()));
        contents.put("map.yaml", text(RosMap.yaml(made.grid(), "map.pgm")));
        contents.put("picture.png", MapPicture.png(made.grid(), made.slam()));
        return contents;
    }

    private void checkOptions() {
        check(
                resolution >= 0.005 && resolution <= 10,
                "--resolution must be 0.005 to 10 m, not '%s'.".formatted(resolution));
        check(maxRange > 0, "--max-range must be more than 0 m, not '%s'.".formatted(maxRange));
        check(freeRange >= 0, "--free-range must be 0 m or more, not '%s'.".formatted(freeRange));
        recorded.checkOptions();
        check(
                !knownPoses || (files.size() == 1 && !recorded.hasNoise()),
                "--known-poses goes with one log and without --odometry-noise.");
        check(
                !knownPoses || !recorded.isWithoutReference(),
                "--known-poses draws by poses that --no-reference says are not right.");
        check(!despiteContradictions || files.size() > 1, "--despite-contradictions goes with two logs or more.");
        check(!recorded.hasReference() || files.size() == 1, "--reference goes with one log.");
    }

    private void printOfLog(String file, RobotLog log) {
        LogOptions.printSkipped(err(), file, log);
        LogOptions.printWandering(err(), file, log);
        LogOptions.printOddities(err(), file, log);
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
            RobotLog log = recorded.read(file);
            RecordedDrive drive = recorded.drive(log, file);
            if (drive.stops().isEmpty() || (knownPoses && drive.posed().isEmpty())) {
                throw LogOptions.nothingKnown(file, knownPoses ? "pose" : "odometry", log);
            }
            LogOptions.checkReturns(file, drive);
            robots.add(new Robot(
                    file,
                    log,
                    noise.isPresent() ? drive.drifting(noise.get(), random.split()) : drive,
                    new ArrayList<>()));
        }
        return robots;
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

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
