package rsal.navigation.replay;

import java.nio.FloatBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;
import rsal.navigation.log.RobotLog;

/// Where a robot went and what its laser saw there, as a log has it.
///
/// @param stops one for each scan, in the order in which they were taken
/// @param omitted scans left out since nothing tells where the wheels had brought the robot
public record RecordedDrive(List<Stop> stops, int omitted) {
    private static final double SAME_PLACE = 0.05; // m
    private static final double LONGEST_AFTER = 1; // s; how old odometry may be when there is none behind a scan
    private static final double SAME_HEADING = 0.02; // rad

    /// One scan.
    ///
    /// @param line of the log, from 1
    /// @param odomFromBase what the wheels said, or are made to have said
    /// @param mapFromBase where the robot was, if that is known
    public record Stop(int line, Instant time, LaserScan scan, Pose2d odomFromBase, Optional<Pose2d> mapFromBase) {}

    public RecordedDrive {
        stops = List.copyOf(stops);
    }

    /// As a log tells it: where the robot was is what its author made of the odometry. Where a scan comes without
    /// odometry, that is taken from the messages before and after it; a second after the last one it is not known.
    public static RecordedDrive of(RobotLog log) {
        var stops = new ArrayList<Stop>();
        for (Scan scan : log.scans()) {
            switch (scan.poses()) {
                case Poses.Reported(Pose2d odomFromBase, Pose2d mapFromBase) ->
                    stops.add(new Stop(scan.line(), scan.time(), scan.scan(), odomFromBase, Optional.of(mapFromBase)));
                case Poses.Unknown() ->
                    odometryAt(scan, log.motions())
                            .ifPresent(odomFromBase -> stops.add(
                                    new Stop(scan.line(), scan.time(), scan.scan(), odomFromBase, Optional.empty())));
            }
        }
        return new RecordedDrive(stops, log.scans().size() - stops.size());
    }

    /// Between the last message before the scan and the first behind it, by time.
    private static Optional<Pose2d> odometryAt(Scan scan, List<Motion> motions) {
        int low = 0;
        int high = motions.size();
        while (low < high) { // the first message that is behind the scan
            int middle = (low + high) >>> 1;
            if (motions.get(middle).line() < scan.line()) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        if (low == 0) {
            return Optional.empty();
        }
        Motion before = motions.get(low - 1);
        if (low == motions.size()) {
            boolean soon = seconds(before.time(), scan.time()) <= LONGEST_AFTER;
            return soon ? Optional.of(before.odomFromBase()) : Optional.empty();
        }
        Motion after = motions.get(low);
        double span = seconds(before.time(), after.time());
        double share = span > 0 ? Math.clamp(seconds(before.time(), scan.time()) / span, 0, 1) : 0;
        return Optional.of(before.odomFromBase().towards(after.odomFromBase(), share));
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toNanos() * 1e-9;
    }

    /// The same, but where the robot was is what another log says of the same scans, which are known by their
    /// readings. Scans of several places that have the same readings, as those that hit nothing, are of no known
    /// place.
    public RecordedDrive judgedBy(RobotLog reference) {
        Map<FloatBuffer, List<Pose2d>> reported = new HashMap<>();
        for (Scan scan : reference.scans()) {
            reported(scan.poses())
                    .ifPresent(pose -> reported.computeIfAbsent(readings(scan.scan()), _ -> new ArrayList<>())
                            .add(pose));
        }
        Map<FloatBuffer, List<Pose2d>> driven = new HashMap<>();
        for (Stop stop : stops) {
            driven.computeIfAbsent(readings(stop.scan()), _ -> new ArrayList<>())
                    .add(stop.odomFromBase());
        }
        return new RecordedDrive(
                stops.stream()
                        .map(stop -> {
                            FloatBuffer readings = readings(stop.scan());
                            Optional<Pose2d> place = onlyPlace(driven.getOrDefault(readings, List.of()))
                                    .flatMap(_ -> onlyPlace(reported.getOrDefault(readings, List.of())));
                            return new Stop(stop.line(), stop.time(), stop.scan(), stop.odomFromBase(), place);
                        })
                        .toList(),
                omitted);
    }

    /// The first when the robot stood there all the while.
    private static Optional<Pose2d> onlyPlace(List<Pose2d> poses) {
        return poses.stream()
                .findFirst()
                .filter(first -> poses.stream().allMatch(pose -> pose.isNear(first, SAME_PLACE, SAME_HEADING)));
    }

    private static FloatBuffer readings(LaserScan scan) {
        return FloatBuffer.wrap(scan.ranges()); // equal when all of them are
    }

    private static Optional<Pose2d> reported(Poses poses) {
        return switch (poses) {
            case Poses.Reported reported -> Optional.of(reported.mapFromBase());
            case Poses.Unknown() -> Optional.empty();
        };
    }

    /// The same without anything that tells where the robot was.
    public RecordedDrive unjudged() {
        return new RecordedDrive(
                stops.stream()
                        .map(s -> new Stop(s.line(), s.time(), s.scan(), s.odomFromBase(), Optional.empty()))
                        .toList(),
                omitted);
    }

    /// The same with wheels that err more: each way between two scans with noise of its own, which adds up.
    public RecordedDrive drifting(OdometryModel noise, RandomGenerator random) {
        var drifted = new ArrayList<Stop>();
        Pose2d pose = Pose2d.ORIGIN;
        for (int i = 0; i < stops.size(); i++) {
            Stop stop = stops.get(i);
            pose = i == 0
                    ? stop.odomFromBase()
                    : noise.sample(pose, stops.get(i - 1).odomFromBase(), stop.odomFromBase(), random);
            drifted.add(new Stop(stop.line(), stop.time(), stop.scan(), pose, stop.mapFromBase()));
        }
        return new RecordedDrive(drifted, omitted);
    }

    /// Where its odometry leaps; empty when the log tells no times.
    public List<Leap> leaps() {
        return IntStream.range(1, stops.size())
                .filter(i -> Leap.isBetween(stops.get(i - 1), stops.get(i)))
                .mapToObj(i -> Leap.between(stops.get(i - 1), stops.get(i)))
                .toList();
    }

    /// The same without its [#leaps]: the wheels say then that the robot stood still for that step.
    public RecordedDrive withoutLeaps() {
        var mended = new ArrayList<Stop>();
        Pose2d mendedFromOdom = Pose2d.ORIGIN;
        for (int i = 0; i < stops.size(); i++) {
            Stop stop = stops.get(i);
            if (i > 0 && Leap.isBetween(stops.get(i - 1), stop)) {
                mendedFromOdom = mended.getLast()
                        .odomFromBase()
                        .compose(stop.odomFromBase().inverse());
            }
            Pose2d pose = mendedFromOdom.compose(stop.odomFromBase());
            mended.add(new Stop(stop.line(), stop.time(), stop.scan(), pose, stop.mapFromBase()));
        }
        return new RecordedDrive(mended, omitted);
    }

    /// Some of the scans, by their numbers from 0.
    public RecordedDrive only(IntPredicate chosen) {
        return new RecordedDrive(
                IntStream.range(0, stops.size())
                        .filter(chosen)
                        .mapToObj(stops::get)
                        .toList(),
                omitted);
    }

    /// The scans of which it is known where they were taken, to draw a map from.
    public List<PosedScan> posed() {
        return stops.stream()
                .filter(stop -> stop.mapFromBase().isPresent())
                .map(stop -> new PosedScan(stop.mapFromBase().get(), stop.scan()))
                .toList();
    }
}
