package rsal.cli;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.carmen.BrokenLog;
import rsal.navigation.carmen.CarmenLog;
import rsal.navigation.carmen.LogReader;
import rsal.navigation.replay.Course;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// What commands that follow recorded logs have in common.
final class LogOptions {
    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private CommandSpec spec;

    @Option(
            names = "--odometry-noise",
            paramLabel = "WAY,HEADING,TURN",
            description = "Makes the wheels err, by these standard deviations: of the way [m per square root of a"
                    + " meter], of the heading by driving [deg likewise] and by turning [deg per square root of a"
                    + " radian]. 0.05,2,3 is a usual robot. Left out: the log's odometry as it is.")
    private @Nullable String odometryNoise;

    @Option(
            names = "--reference",
            paramLabel = "LOG",
            description = "Another log of the same scans, whose poses are right: the corrected one of a raw log.")
    private @Nullable String reference;

    @Option(names = "--no-reference", description = "The log's poses are not right: tell no errors.")
    private boolean noReference;

    @Option(
            names = "--field-of-view",
            paramLabel = "DEG",
            description = "Of the laser, where the log doesn't tell: FLASER (180).")
    private double fieldOfView = 180;

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

    boolean isFieldOfViewPossible() {
        return fieldOfView > 0 && fieldOfView <= 360;
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
                "--odometry-noise takes three finite numbers, none below 0, as 0.05,2,3; not (%s)."
                        .formatted(odometryNoise));
    }

    CarmenLog read(String file) {
        try {
            return CarmenLog.read(
                    Path.of(file),
                    new LogReader.Options(Math.toRadians(fieldOfView), LogReader.Options.DEFAULT.rangeMax()));
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
    Course course(CarmenLog log, String file) {
        Course course = Course.of(log);
        if (reference == null) {
            return isWithoutReference() ? course.unjudged() : course;
        }
        Course judged = course.judgedBy(read(reference));
        if (judged.posed().isEmpty()) {
            throw new InvalidSettings(
                    Location.of(reference),
                    "It has none of the scans of (%s).".formatted(file),
                    "Maybe it is of another run, or its readings were rounded.");
        }
        return judged;
    }

    /// To throw when there is nothing to follow.
    ///
    /// @param what of scans is missing
    static InvalidSettings nothingKnown(String file, String what, CarmenLog log) {
        return new InvalidSettings(
                Location.of(file),
                "There is no scan in it whose %s is known; skipped: %s."
                        .formatted(what, log.skipped().counts()),
                "FLASER and ROBOTLASER1 tell it; RAWLASER1 needs ODOM before it.");
    }
}
