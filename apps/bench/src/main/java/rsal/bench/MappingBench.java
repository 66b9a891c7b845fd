package rsal.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import rsal.data.Pose2d;
import rsal.navigation.replay.Course;
import rsal.navigation.slam.RelationError;
import rsal.navigation.slam.Slam;

/// Mapping public logs whose odometry is made to err as [Drive#WHEELS] do; each repeat with a seed of its own.
///
/// Names are `slam.<log>.<what>`. What: `meters` and `degrees`, how far the relation of a scan to the next is off the
/// one in the log on average; `near.meters`, that of scans within 2 m that do not follow on each other; `seconds`, of
/// this thread for the whole log.
final class MappingBench implements Bench {
    private static final List<String> KINDS = List.of("meters", "degrees", "near.meters", "seconds");
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
    public void measure(Assignment assignment) {
        for (String log : PublicLogs.NAMES) {
            if (KINDS.stream().anyMatch(kind -> assignment.wants(name(log, kind)))) {
                PublicLogs.course(log, assignment).ifPresent(course -> measure(log, course, assignment));
            }
        }
    }

    private static void measure(String name, Course course, Assignment assignment) {
        var values = new double[KINDS.size()][assignment.repeats()];
        for (int repeat = 0; repeat < assignment.repeats(); repeat++) {
            Course driven = course.drifting(Drive.WHEELS, new SplittableRandom(repeat + 1));
            var watch = new Stopwatch();
            var slam = new Slam(Slam.Settings.DEFAULT);
            var located = new ArrayList<Slam.Located>();
            driven.stops().forEach(stop -> located.add(slam.add(stop.odomFromBase(), stop.scan())));
            slam.polish(2);
            double seconds = watch.thread();
            List<Pose2d> right = course.stops().stream()
                    .map(Course.Stop::mapFromBase)
                    .flatMap(Optional::stream)
                    .toList();
            List<Pose2d> judged = located.stream().map(slam::pose).toList();
            RelationError next = RelationError.ofNext(right, judged);
            values[0][repeat] = next.meters();
            values[1][repeat] = Math.toDegrees(next.radians());
            values[2][repeat] = RelationError.ofNear(right, judged, NEAR).meters();
            values[3][repeat] = seconds;
        }
        List<String> units = List.of("m", "deg", "m", "s");
        for (int kind = 0; kind < KINDS.size(); kind++) {
            assignment.tell(Result.less(name(name, KINDS.get(kind)), units.get(kind), values[kind]));
        }
    }
}
