package rsal.cli.log;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import rsal.cli.terminal.FileName;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.RobotLog;
import rsal.navigation.replay.Leap;
import rsal.navigation.replay.RecordedDrive;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// What commands that follow recorded logs have in common.
final class LogOptions {
    private static final double MANY = 0.1; // share of scans skipped that nobody should miss
    private static final int MOST_TOPICS = 8; // named
    private static final double TOO_MANY = 0.5; // the same, that leaves too little to go by

    /// Which logs commands read, for their help.
    static final String LOGS =
            "LOG is one of the following: a log of CARMEN (FLASER, ROBOTLASER1, RAWLASER1 with ODOM), plain or"
                    + " compressed by gzip; a bag of ROS 2 in MCAP or sqlite3 (folder or file); a file of your"
                    + " own format. PARAM robot_frontlaser_offset (and _side_offset, _angular_offset) gives the"
                    + " mount of the laser of RAWLASER1.";

    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private CommandSpec spec;

    @Option(
            names = "--odometry-noise",
            paramLabel = "WAY,HEADING,TURN",
            description = "Add noise to the odometry, with three standard deviations. WAY: distance [m per"
                    + " square root of a meter]. HEADING: heading while driving [deg per square root of a"
                    + " meter]. TURN: heading while turning [deg per square root of a radian]. 0.05,2,3 is a"
                    + " typical robot. Default: the log's odometry, unchanged.")
    private @Nullable String odometryNoise;

    @Option(
            names = "--reference",
            converter = FileName.class,
            paramLabel = "LOG",
            description = "Another log of the same scans, whose poses are right: the corrected one of a raw log.")
    private @Nullable String reference;

    @Option(names = "--no-reference", description = "The log's poses are not correct: print no errors.")
    private boolean noReference;

    @Option(
            names = "--field-of-view",
            paramLabel = "DEG",
            description = "Field of view of the laser, if the log does not have it: FLASER (180).")
    private double fieldOfView = 180;

    @Option(
            names = "--upside-down",
            description = "The laser was mounted upside down, or its readings are clockwise for another reason.")
    private boolean upsideDown;

    @Option(
            names = "--scan-topic",
            paramLabel = "NAME",
            description =
                    "The topic of the laser's scans, for bags with several. Default: the one with the most scans.")
    private @Nullable String scanTopic;

    boolean hasNoise() {
        return odometryNoise != null;
    }

    boolean hasReference() {
        return reference != null;
    }

    /// Whether the log's own poses are not to be taken for right.
    boolean isWithoutReference() {
        return noReference && reference == null;
    }

    void checkOptions() {
        if (!(fieldOfView > 0 && fieldOfView <= 360)) {
            throw new ParameterException(
                    spec.commandLine(),
                    "--field-of-view must be above 0° and at most 360°, not '%s'.".formatted(fieldOfView));
        }
    }

    /// How the wheels are to err; empty when they are not.
    Optional<OdometryModel> noise() {
        if (odometryNoise == null) {
            return Optional.empty();
        }
        String[] words = odometryNoise.split(",", -1);
        try {
            if (words.length == 3) {
                return Optional.of(new OdometryModel(
                        Double.parseDouble(words[0]),
                        Math.toRadians(Double.parseDouble(words[1])),
                        Math.toRadians(Double.parseDouble(words[2]))));
            }
        } catch (IllegalArgumentException _) {
            // told below
        }
        throw new ParameterException(
                spec.commandLine(),
                "--odometry-noise takes three finite numbers, none below 0, as 0.05,2,3; not '%s'."
                        .formatted(odometryNoise));
    }

    /// @throws InvalidSettings when it can't be read, or most of its scans can't be used
    RobotLog read(String file) {
        RobotLog log = read(
                file,
                new LaserHints(
                        Math.toRadians(fieldOfView),
                        LaserHints.DEFAULT.rangeMax(),
                        upsideDown,
                        Optional.ofNullable(scanTopic)));
        if (scanTopic != null && log.topic().isEmpty()) {
            throw new InvalidSettings(
                    Location.of(file), "This log has no topics, so --scan-topic selects nothing.", "");
        }
        return log;
    }

    /// @throws InvalidSettings as above
    static RobotLog read(String file, LaserHints hints) {
        try {
            RobotLog log = LogFormats.read(Path.of(file), hints);
            if (skippedShare(log) > TOO_MANY) {
                throw new InvalidSettings(
                        Location.of(file),
                        "Most of its scans can't be used: %s.".formatted(skippedText(log)),
                        whereSkipped(log));
            }
            return log;
        } catch (BrokenLog e) {
            throw new InvalidSettings(new Location(file, e.line(), 1), e.reason(), "");
        } catch (NoSuchFileException | InvalidPathException _) {
            throw new InvalidSettings(Location.of(file), "There is no such file.", "");
        } catch (IOException e) {
            throw new InvalidSettings(Location.of(file), "It can't be read: %s.".formatted(e.getMessage()), "");
        }
    }

    /// The course of a log, with the poses of the reference where there is one, and without any that is right when
    /// the log's own are not.
    ///
    /// @param file of the log
    RecordedDrive drive(RobotLog log, String file) {
        RecordedDrive drive = RecordedDrive.of(log).withoutLeaps();
        if (reference == null) {
            return isWithoutReference() ? drive.unjudged() : drive;
        }
        RecordedDrive judged = drive.judgedBy(read(reference));
        if (judged.posed().isEmpty()) {
            throw new InvalidSettings(
                    Location.of(reference),
                    "It has none of the scans of '%s'.".formatted(file),
                    "Maybe it is of another run, or its readings were rounded.");
        }
        return judged;
    }

    /// To throw when there is nothing to follow.
    ///
    /// @param what of scans is missing
    static InvalidSettings nothingKnown(String file, String what, RobotLog log) {
        if (log.scans().isEmpty() && log.skipped().scans() > 0) {
            return new InvalidSettings(
                    Location.of(file),
                    "None of its scans can be used: %s.".formatted(skippedText(log)),
                    whereSkipped(log));
        }
        return new InvalidSettings(
                Location.of(file),
                log.scans().isEmpty()
                        ? "There is no scan in it%s.".formatted(among(log))
                        : "There is no scan in it whose %s is known%s.".formatted(what, among(log)),
                "In logs of CARMEN, FLASER and ROBOTLASER1 contain it; RAWLASER1 needs ODOM before it.");
    }

    private static String among(RobotLog log) {
        return log.skipped().total() == 0 ? "" : "; skipped: " + skippedText(log);
    }

    /// @throws InvalidSettings when no beam of any scan hit anything, so that there is nothing to go by
    static void checkReturns(String file, RecordedDrive drive) {
        boolean hit = drive.stops().stream()
                .map(RecordedDrive.Stop::scan)
                .anyMatch(scan -> IntStream.range(0, scan.count()).anyMatch(scan::isHit));
        if (!hit) {
            throw new InvalidSettings(
                    Location.of(file),
                    "No beam of any of its %d scans hit anything."
                            .formatted(drive.stops().size()),
                    "Maybe its ranges are in another unit: they must be in meters, below %.0f."
                            .formatted(LaserHints.DEFAULT.rangeMax()));
        }
    }

    /// Tells people whose scans of a bag were read.
    private static void printTopic(PrintWriter err, String file, RobotLog log) {
        log.topic()
                .filter(topic -> !topic.others().isEmpty())
                .ifPresent(topic -> err.println(
                        "Scans of '%s' are those of '%s'. %d other topics have scans: %s%s. 'rsal map' and 'rsal localize' select one by --scan-topic."
                                .formatted(
                                        file,
                                        topic.name(),
                                        topic.others().size(),
                                        String.join(
                                                ", ",
                                                topic.others().stream()
                                                        .limit(MOST_TOPICS)
                                                        .toList()),
                                        topic.others().size() > MOST_TOPICS ? ", …" : "")));
    }

    /// Tells people whose scans of a log were read and what was not used, and makes sure that they see when it
    /// is much.
    static void printSkipped(PrintWriter err, String file, RobotLog log) {
        printTopic(err, file, log);
        if (log.skipped().total() == 0) {
            return;
        }
        err.println((skippedShare(log) > MANY ? "WARNING: much of '%s' was skipped: %s" : "Skipped of '%s': %s")
                .formatted(file, skippedText(log)));
        log.skipped().first().stream()
                .limit(3)
                .forEach(place -> err.println("  %s:%d: %s".formatted(file, place.line(), place.what())));
    }

    /// What of a log is so odd that what comes of it is probably wrong.
    static void printOddities(PrintWriter err, String file, RobotLog log) {
        log.oneTime()
                .ifPresent(time -> err.println(
                        ("All %d scans of '%s' have one time (%.3f s), so the result has no times, and poses "
                                        + "can't be interpolated from ODOM. If that matters, write the time of each scan [s] "
                                        + "before and after the host name.")
                                .formatted(log.scans().size(), file, time.toEpochMilli() / 1e3)));
        log.degrees()
                .ifPresent(most -> err.println(
                        ("The headings in '%s' are probably degrees: they go to %.1f, in steps of more than a radian."
                                        + " CARMEN's are radians: multiply them by π / 180.")
                                .formatted(file, most)));
        List<Leap> leaps = RecordedDrive.of(log).leaps();
        if (!leaps.isEmpty()) {
            err.println("The odometry of '%s' jumps %s. RSAL assumes that the robot stood still meanwhile."
                    .formatted(file, leaps.size() == 1 ? "once" : leaps.size() + " times"));
            leaps.stream()
                    .limit(3)
                    .forEach(leap -> err.println(String.format(
                            Locale.ROOT,
                            "  %s:%d: %.2f m and %.0f° in %.2f s",
                            file,
                            leap.line(),
                            leap.meters(),
                            Math.toDegrees(leap.radians()),
                            leap.seconds())));
        }
    }

    /// What of a log was read otherwise than it stands there.
    static void printWandering(PrintWriter err, String file, RobotLog log) {
        log.wandering()
                .ifPresent(by -> err.println(
                        ("In '%s', the laser moves on the robot, by up to (%.2f m) and (%.0f°). So its poses are "
                                        + "used as corrected poses of the robot, as in many logs, with the laser in its middle. If "
                                        + "the laser is elsewhere, give all scans the same mount.")
                                .formatted(file, by.meters(), Math.toDegrees(by.radians()))));
    }

    private static double skippedShare(RobotLog log) {
        int skipped = log.skipped().scans();
        return skipped == 0 ? 0 : (double) skipped / (skipped + log.scans().size());
    }

    /// `18 of 20 scans; 17 back in time, 2 cut short`.
    private static String skippedText(RobotLog log) {
        int scans = log.skipped().scans();
        int others = log.skipped().total() - scans;
        String reasons = log.skipped().counts().entrySet().stream()
                .map(reason -> "%d %s".formatted(reason.getValue(), reason.getKey()))
                .collect(Collectors.joining(", "));
        return "%s%s (%s)"
                .formatted(
                        scans == 0
                                ? "no scan"
                                : "%d of %d scans"
                                        .formatted(scans, scans + log.scans().size()),
                        others == 0 ? "" : ", %d other messages".formatted(others),
                        reasons);
    }

    private static String whereSkipped(RobotLog log) {
        return log.skipped().first().stream()
                .findFirst()
                .map(place -> "The first is in line %d: %s".formatted(place.line(), place.what()))
                .orElse("");
    }
}
