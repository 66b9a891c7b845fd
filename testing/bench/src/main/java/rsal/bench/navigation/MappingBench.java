package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.data.Pose2d;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.slam.RelationError;
import rsal.navigation.slam.Slam;

/// Mapping public logs whose odometry is made to err as [Drive#WHEELS] do; each repeat with a seed of its own.
///
/// Names are `slam.<log>.<what>`. What: `meters` and `degrees`, how far the relation of a scan to the next is off the
/// one in the log on average; `near.meters` and `near.degrees`, that of scans within 2 m that do not follow on each
/// other; `wheels.meters` and `wheels.degrees`, how far off the wheels alone are from a scan to the next; `seconds`, of
/// this thread for the whole log.
public final class MappingBench implements Bench {
    private static final List<String> KINDS =
            List.of("meters", "degrees", "near.meters", "near.degrees", "wheels.meters", "wheels.degrees", "seconds");
    private static final double NEAR = 2; // m

    private static String name(String log, String kind) {
        return "slam.%s.%s".formatted(PublicLogs.label(log), kind);
    }

    @Override
    public List<String> names() {
        return PublicLogs.NAMES.stream()
                .flatMap(log -> KINDS.stream().map(kind -> name(log, kind)))
                .toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (String log : PublicLogs.NAMES) {
            if (KINDS.stream().anyMatch(kind -> assignment.wants(name(log, kind)))) {
                PublicLogs.drive(log, assignment).ifPresent(drive -> measure(log, drive, assignment));
            }
        }
    }

    private static void measure(String name, RecordedDrive drive, BenchmarkRequest assignment) {
        var values = new double[KINDS.size()][assignment.repeats()];
        for (int repeat = 0; repeat < assignment.repeats(); repeat++) {
            RecordedDrive driven = drive.drifting(Drive.WHEELS, new SplittableRandom(repeat + 1));
            var watch = new Stopwatch();
            var slam = new Slam(Slam.Settings.DEFAULT);
            var located = new ArrayList<Slam.Located>();
            for (RecordedDrive.Stop stop : driven.stops()) {
                located.add(slam.add(stop.odomFromBase(), stop.scan()));
                assignment.reach(
                        "slam.%s, scans of repeat %d".formatted(PublicLogs.label(name), repeat + 1),
                        located.size(),
                        driven.stops().size());
            }
            slam.polish(2);
            double seconds = watch.thread();
            List<Pose2d> right = drive.stops().stream()
                    .map(RecordedDrive.Stop::mapFromBase)
                    .flatMap(Optional::stream)
                    .toList();
            List<Pose2d> judged = located.stream().map(slam::pose).toList();
            RelationError next = RelationError.ofNext(right, judged);
            values[0][repeat] = next.meters();
            values[1][repeat] = Math.toDegrees(next.radians());
            RelationError near = RelationError.ofNear(right, judged, NEAR);
            values[2][repeat] = near.meters();
            values[3][repeat] = Math.toDegrees(near.radians());
            List<Pose2d> reported = driven.stops().stream()
                    .map(RecordedDrive.Stop::odomFromBase)
                    .toList();
            RelationError wheels = RelationError.ofNext(right, reported);
            values[4][repeat] = wheels.meters();
            values[5][repeat] = Math.toDegrees(wheels.radians());
            values[6][repeat] = seconds;
        }
        List<String> units = List.of("m", "deg", "m", "deg", "m", "deg", "s");
        for (int kind = 0; kind < KINDS.size(); kind++) {
            assignment.report(Result.less(name(name, KINDS.get(kind)), units.get(kind), values[kind]));
        }
    }
}
