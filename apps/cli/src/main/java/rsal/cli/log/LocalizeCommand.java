package rsal.cli.log;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.log.LocalizeResult.RunView;
import rsal.cli.log.LocalizeResult.Summary;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileError;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.map.Maps;
import rsal.map.RosMap;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.LocalizationMap;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.amcl.SensorModel;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.log.RobotLog;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.replay.Replay;
import rsal.navigation.replay.Verdict;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.time.AllowedToReadWallClock;

/// `rsal localize`
@Command(
        name = "localize",
        description = "Localize a robot on a map by its log: print the pose, its confidence and its error for each"
                + " scan.",
        footer = {
            "",
            LogOptions.LOGS + " Errors are relative to the poses in the log, or in that of --reference. In"
                    + " 'corrected' logs the odometry equals these poses, without any error: add noise by"
                    + " --odometry-noise.",
            "",
            "  rsal localize lab.log.gz --map lab.yaml --global",
            "  rsal localize lab.log.gz --map-from-half --global --odometry-noise 0.05,2,3 --seeds 50 --vary-start",
            ""
        })
@AllowedToReadWallClock("Tells how long updates take.")
public final class LocalizeCommand extends Subcommand {
    private static final int MOST_PARTICLES = 1_000_000;
    private static final double OFF_MAP = 5; // m; how far off a map a start may be

    @Parameters(index = "0", converter = FileName.class, paramLabel = "LOG", description = "The log's file.")
    private String file = "";

    @ArgGroup(multiplicity = "1")
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private MapChoice map;

    @Option(
            names = "--save-map",
            paramLabel = "MAP.yaml",
            description = "Write the map of --map-from-half to this file, and its image into the same folder.")
    private @Nullable String saveMap;

    @Option(names = "--force", description = "Overwrite existing files of --save-map.")
    private boolean force;

    @ArgGroup
    private @Nullable Start start;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private LogOptions recorded;

    @Mixin
    private LocalizerTuning tuning = new LocalizerTuning();

    @Option(names = "--seeds", paramLabel = "N", description = "Number of runs, with the seeds 1 to N (1).")
    private int seeds = 1;

    @Option(
            names = "--vary-start",
            description = "Each run begins at a scan that is drawn by its seed, not at the first scan of the log.")
    private boolean varyStart;

    @Option(names = "--scans", paramLabel = "N", description = "Maximum number of scans in each run.")
    private int scans = Integer.MAX_VALUE;

    @Option(names = "--beams", paramLabel = "N", description = "Number of beams of a scan to use (60).")
    private int beams = 60;

    @Option(names = "--max-range", paramLabel = "M", description = "Longer ranges are ignored [m] (30).")
    private double maxRange = 30;

    @Option(
            names = "--max-particles",
            paramLabel = "N",
            description = "Number of particles when the pose is most uncertain (5000).")
    private int maxParticles = 5000;

    @Option(
            names = "--min-particles",
            paramLabel = "N",
            description = "Number of particles when the pose is most certain (150).")
    private int minParticles = 150;

    @Option(
            names = "--model",
            paramLabel = "MODEL",
            description = "Sensor model: field, by the distance of a beam's end from walls (the default); beam, by"
                    + " the expected range.")
    private SensorModel.Kind model = SensorModel.Kind.FIELD;

    static final class MapChoice {
        @Option(
                names = "--map",
                paramLabel = "MAP",
                required = true,
                description = "YAML file of a map of ROS, in the frame of the log's poses; or the name of a map of"
                        + " RSAL.")
        @Nullable
        String map;

        @Option(
                names = "--map-from-half",
                required = true,
                description = "Draw the map from every other scan, at the right poses, and localize with the rest.")
        boolean fromHalf;
    }

    static final class Start {
        @Option(
                names = "--global",
                required = true,
                description = "The robot may start anywhere on the map. This is the default.")
        boolean global;

        @Option(
                names = "--pose",
                arity = "3",
                required = true,
                paramLabel = "X Y DEG",
                hideParamSyntax = true,
                description = "The robot starts near this pose [m, m, deg].")
        double @Nullable [] pose;

        @Option(
                names = "--right-pose",
                required = true,
                description = "The robot starts near the pose of the reference.")
        boolean right;
    }

    @Override
    protected int run() throws IOException {
        checkOptions();
        Arguments tuned = tuning.arguments();
        Optional<Destination> target = Optional.ofNullable(saveMap).map(this::target);
        Optional<OdometryModel> noise = recorded.noise();
        RobotLog log = recorded.read(file);
        RecordedDrive drive = recorded.drive(log, file);
        if (drive.stops().isEmpty()) {
            throw LogOptions.nothingKnown(file, "odometry", log);
        }
        LogOptions.checkReturns(file, drive);
        target.ifPresent(Destination::prepareExisting);
        OccupancyGrid grid = grid(drive);
        checkStart(grid);
        LocalizationMap localizationMap = LocalizerTuning.map(grid, tuned);
        checkSize(localizationMap, grid);
        target.ifPresent(folder -> save(grid, folder));
        if (map.fromHalf) {
            drive = drive.only(i -> i % 2 == 1);
        }
        var report = new LocalizeReport(out(), err());
        var runs = new ArrayList<RunView>();
        var verdicts = new ArrayList<Verdict>();
        for (int seed = 1; seed <= seeds; seed++) {
            List<Replay.Step> steps = follow(drive, localizationMap, tuned, noise, seed);
            Verdict verdict = Verdict.of(steps);
            RunView run = RunView.of(seed, steps, verdict);
            runs.add(run);
            verdicts.add(verdict);
            if (!json) {
                report.print(run, seeds == 1);
            }
        }
        Summary summary = Summary.of(runs, Verdict.pooled(verdicts));
        if (json) {
            printJson(new LocalizeResult(
                    file,
                    map.map == null ? "from half" : map.map,
                    drive.stops().size(),
                    drive.omitted(),
                    log.skipped().counts(),
                    summary,
                    runs));
        } else {
            LogOptions.printSkipped(err(), file, log);
            report.print(summary);
        }
        LogOptions.printWandering(err(), file, log);
        LogOptions.printOddities(err(), file, log);
        report.printDoubts(file, drive, runs);
        return Exit.SUCCESS;
    }

    private void checkOptions() {
        check(seeds >= 1, "--seeds must be at least 1, not '%d'.".formatted(seeds));
        check(scans >= 1, "--scans must be at least 1, not '%d'.".formatted(scans));
        check(beams >= 5, "--beams must be at least 5, not '%d'.".formatted(beams));
        check(maxRange > 0, "--max-range must be more than 0 m, not '%s'.".formatted(maxRange));
        check(minParticles >= 20, "--min-particles must be at least 20, not '%d'.".formatted(minParticles));
        check(
                maxParticles >= minParticles && maxParticles <= MOST_PARTICLES,
                "--max-particles must be from --min-particles (%d) to %d, not (%d)."
                        .formatted(minParticles, MOST_PARTICLES, maxParticles));
        check(
                start == null || start.pose == null || Arrays.stream(start.pose).allMatch(Double::isFinite),
                "--pose takes three finite numbers, as 3.2 -1.5 90; not '%s'."
                        .formatted(start == null ? "" : Arrays.toString(start.pose)));
        check(
                saveMap == null || map.fromHalf,
                "--save-map goes with --map-from-half: with --map no other map is made.");
        check(saveMap == null || saveMap.endsWith(".yaml"), "--save-map '%s' must end with .yaml.".formatted(saveMap));
        recorded.checkOptions();
    }

    private Destination target(String yaml) {
        Path folder = Destination.path(yaml).toAbsolutePath().getParent();
        return Destination.of(String.valueOf(folder), List.of(fileName(yaml), imageName(yaml)), force);
    }

    /// A robot is not expected far off the map, where nothing could tell where it is.
    private void checkStart(OccupancyGrid grid) {
        if (start == null || start.pose == null) {
            return;
        }
        double x = start.pose[0];
        double y = start.pose[1];
        double right = grid.originX() + grid.width() * grid.resolution();
        double top = grid.originY() + grid.height() * grid.resolution();
        if (x < grid.originX() - OFF_MAP || x > right + OFF_MAP || y < grid.originY() - OFF_MAP || y > top + OFF_MAP) {
            throw new InvalidSettings(
                    Location.of("--pose"),
                    "The start (%s, %s) is far off the map, which reaches from (%.1f, %.1f) to (%.1f, %.1f)."
                            .formatted(x, y, grid.originX(), grid.originY(), right, top),
                    "Poses are in meters in the map's frame, as the 'origin' of its YAML says.");
        }
    }

    private void checkSize(LocalizationMap localizationMap, OccupancyGrid grid) {
        if ((start == null || start.global) && !localizationMap.isSearchable()) {
            throw new InvalidSettings(
                    Location.of(map.map == null ? file : map.map),
                    "The map has %.0f m² of free floor; a robot that may be anywhere is searched for on %.0f m² at most."
                            .formatted(localizationMap.freeFloor(), LocalizationMap.MOST_SEARCHED),
                    "Give its start (--pose), or check whether cells of %s m are right.".formatted(grid.resolution()));
        }
    }

    private List<Replay.Step> follow(
            RecordedDrive drive,
            LocalizationMap localizationMap,
            Arguments tuned,
            Optional<OdometryModel> noise,
            int seed) {
        var random = new SplittableRandom(seed);
        int last = drive.stops().size() - 1;
        int first = varyStart ? random.nextInt(Math.max(1, last + 2 - Math.min(scans, last + 1))) : 0;
        RecordedDrive part = drive.only(i -> i >= first && i - first < scans);
        RecordedDrive driven = noise.isPresent() ? part.drifting(noise.get(), random) : part;
        var amcl =
                new Amcl(localizationMap, LocalizerTuning.settings(minParticles, maxParticles, model, tuned), random);
        startPose(driven)
                .ifPresent(pose -> amcl.start(PoseEstimate.of(pose, Covariance2d.ofDeviations(0.3, 0.3, 0.2))));
        return Replay.run(driven, amcl, new Replay.Look(beams, maxRange), System::nanoTime);
    }

    private Optional<Pose2d> startPose(RecordedDrive drive) {
        if (start == null || start.global) {
            return Optional.empty();
        }
        if (start.pose != null) {
            return Optional.of(Pose2d.ofDegrees(start.pose[0], start.pose[1], start.pose[2]));
        }
        return drive.stops().getFirst().mapFromBase().or(() -> {
            throw new InvalidSettings(
                    Location.of(file), "The log has no pose for its first scan.", "Use --pose or --global.");
        });
    }

    private OccupancyGrid grid(RecordedDrive drive) throws IOException {
        if (map.map != null) {
            Maps.Found found = new Maps(FileSource.disk()).find(map.map, Location.of("--map"));
            found.warnings().forEach(warning -> err().println(FileError.note(warning)));
            return found.grid();
        }
        var half = drive.only(i -> i % 2 == 0).posed();
        if (half.isEmpty()) {
            throw new InvalidSettings(
                    Location.of(file), "The log has no poses for its scans.", "Use --map or --reference.");
        }
        OccupancyGrid drawn;
        try {
            drawn = ScanMapper.draw(half, ScanMapper.Settings.ofLogs(0.05));
        } catch (IllegalArgumentException e) {
            throw new InvalidSettings(Location.of(file), String.valueOf(e.getMessage()), "");
        }
        return drawn;
    }

    private void save(OccupancyGrid drawn, Destination folder) {
        String yaml = String.valueOf(saveMap);
        var contents = new LinkedHashMap<String, byte[]>();
        contents.put(imageName(yaml), RosMap.pgm(drawn));
        contents.put(fileName(yaml), RosMap.yaml(drawn, imageName(yaml)).getBytes(StandardCharsets.UTF_8));
        folder.write(contents);
    }

    private static String fileName(String yaml) {
        return String.valueOf(Destination.path(yaml).getFileName());
    }

    private static String imageName(String yaml) {
        return fileName(yaml).replaceFirst("\\.yaml$", ".pgm");
    }
}
