package rsal.cli.log;

import java.io.PrintWriter;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.cli.log.MapResult.Clash;
import rsal.cli.log.MapResult.Drawn;
import rsal.cli.log.MapResult.Errors;
import rsal.cli.log.MapResult.Merged;
import rsal.cli.log.MapResult.Turned;
import rsal.cli.log.MapResult.Wandered;
import rsal.data.Pose2d;
import rsal.navigation.log.RobotLog;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.slam.MapOverlap;
import rsal.navigation.slam.Merge;
import rsal.navigation.slam.Relation;
import rsal.navigation.slam.RelationError;
import rsal.navigation.slam.Slam;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.time.AllowedToReadWallClock;

/// Maps logs of robots by SLAM, each by itself, and joins their maps into one.
@AllowedToReadWallClock("Tells every 2 s how far it is.")
final class LogMapper {
    private static final long TOLD_EVERY = 2_000_000_000L; // ns

    private final List<Robot> robots;
    private final double maxRange;
    private final boolean despiteContradictions;
    private final PrintWriter err;
    private final List<Slam> slams = new ArrayList<>(); // of each robot; the first grows
    private final List<Integer> starts = new ArrayList<>(); // numbers of the robots' first scans in the whole graph
    private final List<Drawn> drawn = new ArrayList<>();
    private final List<Merged> merged = new ArrayList<>();

    /// One robot's scans and, once they are mapped, where they are in its graph.
    record Robot(String file, RobotLog log, RecordedDrive drive, List<Slam.Located> located) {}

    /// @param maxRange ranges beyond are not looked at [m]
    /// @param err where progress is told
    LogMapper(List<Robot> robots, double maxRange, boolean despiteContradictions, PrintWriter err) {
        this.robots = List.copyOf(robots);
        this.maxRange = maxRange;
        this.despiteContradictions = despiteContradictions;
        this.err = err;
    }

    /// @throws InvalidSettings when the maps of two logs can't be joined
    void map() {
        for (Robot robot : robots) {
            Slam own = mapped(robot);
            slams.add(own);
            drawn.add(drawn(robot, own));
        }
        starts.add(0);
        var shared = new ArrayList<MapOverlap>();
        for (int i = 1; i < slams.size(); i++) {
            starts.add(whole().frameCount());
            shared.add(merge(whole(), slams.get(i)));
        }
        for (int i = 1; i < slams.size(); i++) { // not before: each that joins moves the others a little
            MapOverlap both = shared.get(i - 1);
            merged.add(Merged.of(
                    file(i),
                    mapFromOwn(whole(), slams.get(i), starts.get(i)),
                    both,
                    worst(both).orElse(null)));
        }
    }

    /// The graph of all robots.
    Slam whole() {
        return slams.getFirst();
    }

    /// What became of each log.
    List<Drawn> drawn() {
        return drawn;
    }

    /// How the logs after the first were joined.
    List<Merged> merged() {
        return merged;
    }

    /// The way of a robot as TUM writes it.
    String trajectory(int robot) {
        return trajectory(robots.get(robot), slams.get(robot), whole(), starts.get(robot));
    }

    private String file(int robot) {
        return robots.get(robot).file();
    }

    private Slam mapped(Robot robot) {
        var slam = new Slam(Slam.Settings.DEFAULT.within(maxRange));
        List<RecordedDrive.Stop> stops = robot.drive().stops();
        long reported = System.nanoTime();
        for (RecordedDrive.Stop stop : stops) {
            robot.located().add(slam.add(stop.odomFromBase(), stop.scan()));
            if (System.nanoTime() - reported > TOLD_EVERY) {
                reported = System.nanoTime();
                err.println("%s: %d of %d scans, %d kept, %d places known again so far"
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

    private MapOverlap merge(Slam slam, Slam other) {
        String file = file(starts.size() - 1);
        String before =
                robots.stream().limit(starts.size() - 1).map(Robot::file).collect(Collectors.joining(", "));
        Merge merged;
        try {
            merged = despiteContradictions ? slam.mergeDespiteContradictions(other) : slam.merge(other);
        } catch (IllegalArgumentException e) {
            throw new InvalidSettings(
                    Location.of(file), String.valueOf(e.getMessage()), "Map fewer logs, or parts of them.");
        }
        return switch (merged) {
            case Merge.Done done -> done.shared();
            case Merge.Contradicted(Pose2d place, MapOverlap shared) ->
                throw new InvalidSettings(
                        Location.of(file),
                        "Its map fits that of '%s', moved by (%s), but they contradict each other: %s."
                                .formatted(before, words(place), against(shared.against(), worst(shared))),
                        "Maybe these are two places that look alike. If something was moved there between the runs,"
                                + " join them with --despite-contradictions.");
            case Merge.Apart _ ->
                throw new InvalidSettings(
                        Location.of(file),
                        "No place is found that its map shares with that of '%s'.".formatted(before),
                        "Maybe the robots saw different places, or too little of the same: let one drive through"
                                + " more of what the other saw.");
            case Merge.Ambiguous(Pose2d one, Pose2d rival) ->
                throw new InvalidSettings(
                        Location.of(file),
                        "Its map fits that of '%s' in two ways: moved by (%s), or by (%s)."
                                .formatted(before, words(one), words(rival)),
                        "Maybe the place looks the same from two sides; let the robots see more of what tells them"
                                + " apart, or map the logs one by one.");
        };
    }

    static String against(double share, Optional<Clash> worst) {
        return ("of what either hit in the floor that both saw, %.2f%% stands in what the other saw free, %.1f m and"
                        + " more from all it hit (at most %.1f%% in maps that share a place)%s")
                .formatted(
                        100 * share,
                        MapOverlap.NEAR,
                        100 * MapOverlap.MOST_AGAINST,
                        worst.map(c -> ", most of it " + c.words()).orElse(""));
    }

    private Optional<Clash> worst(MapOverlap shared) {
        return shared.worst().map(c -> new Clash(c.x(), c.y(), fileOf(c.hitBy()), fileOf(c.freeBy())));
    }

    private String fileOf(int scan) {
        int robot = starts.size() - 1;
        while (starts.get(robot) > scan) {
            robot--;
        }
        return file(robot);
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
        List<RecordedDrive.Stop> stops = robot.drive().stops();
        for (int i = 0; i < stops.size(); i++) {
            RecordedDrive.Stop stop = stops.get(i);
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
                robot.drive().omitted(),
                robot.log().skipped().counts(),
                slam.frameCount(),
                loops(slam),
                Errors.of(RelationError.ofNext(right, wheels)).orElse(null),
                Errors.of(RelationError.ofNext(right, judged)).orElse(null),
                Errors.of(RelationError.ofNear(right, judged, MapResult.NEAR)).orElse(null),
                Turned.of(slam.turns()),
                Wandered.of(robot.log()));
    }

    /// @param offset number of the robot's first frame in the whole graph
    private static String trajectory(Robot robot, Slam own, Slam whole, int offset) {
        var text = new StringBuilder("# time x y z qx qy qz qw\n");
        List<RecordedDrive.Stop> stops = robot.drive().stops();
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

    static String residuals(Slam slam) {
        var text = new StringBuilder("from,to,source,x,y,degrees,meters_off,degrees_off,deviations_off\n");
        for (Relation relation : slam.relations()) {
            Pose2d reported = relation.fromFromTo();
            Pose2d off = reported.inverse()
                    .compose(slam.poses()
                            .get(relation.from())
                            .inverse()
                            .compose(slam.poses().get(relation.to())));
            text.append("%d,%d,%s,%.4f,%.4f,%.3f,%.4f,%.3f,%.2f%n"
                    .formatted(
                            relation.from(),
                            relation.to(),
                            relation.source().name().toLowerCase(Locale.ROOT),
                            reported.x(),
                            reported.y(),
                            Math.toDegrees(reported.theta()),
                            Math.hypot(off.x(), off.y()),
                            Math.toDegrees(off.theta()),
                            slam.residual(relation)));
        }
        return text.toString();
    }
}
