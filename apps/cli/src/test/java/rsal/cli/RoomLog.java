package rsal.cli;

import java.util.Locale;
import rsal.data.Pose2d;
import rsal.testkit.DrawnMap;
import rsal.testkit.ObviousRays;

/// The log of a robot that drives through a room and back in 40 steps, turning all the while.
public final class RoomLog {
    private static final DrawnMap ROOM = DrawnMap.grid(0.5, """
            #####################
            #...................#
            #.a.............b...#
            #.......##..........#
            #.......##..........#
            #...............#####
            #...............#
            #.....#.........#
            #################
            """);

    /// The same with a box.
    private static final DrawnMap WITH_BOX = DrawnMap.grid(0.5, """
            #####################
            #...................#
            #.a.............b...#
            #.......##..........#
            #.......##..........#
            #...........#...#####
            #...............#
            #.....#.........#
            #################
            """);

    /// Half a turn makes the same of it.
    private static final DrawnMap TWO_SIDED = DrawnMap.grid(0.5, """
            #####################
            ####................#
            #.a.................#
            #.......##..........#
            #...................#
            #..........##.......#
            #.................b.#
            #................####
            #####################
            """);

    static final Pose2d START = ROOM.pose('a', 0);

    private RoomLog() {}

    public static String whole() {
        return part(0, 40, Pose2d.ORIGIN);
    }

    /// @param first step
    /// @param last step
    /// @param shift of the poses that it tells
    static String part(int first, int last, Pose2d shift) {
        return log(ROOM, first, last, shift, Pose2d.ORIGIN, false);
    }

    /// Likewise of the room when a box of 0.5 m stands in it around (6.25, 1.75).
    static String withBox(int first, int last, Pose2d shift) {
        return log(WITH_BOX, first, last, shift, Pose2d.ORIGIN, false);
    }

    /// Likewise of a room that looks the same from both ends.
    static String twoSided(int first, int last, Pose2d shift) {
        return log(TWO_SIDED, first, last, shift, Pose2d.ORIGIN, false);
    }

    /// As a laser that is upside down sees the room.
    static String mirrored() {
        return log(ROOM, 0, 40, Pose2d.ORIGIN, Pose2d.ORIGIN, true);
    }

    /// The first of whose poses are corrected ones, some meters beside the others.
    static String corrected(int first, int last, double metersBeside) {
        return log(ROOM, first, last, Pose2d.ORIGIN, new Pose2d(0, metersBeside, 0), false);
    }

    private static String log(DrawnMap room, int first, int last, Pose2d shift, Pose2d correction, boolean upsideDown) {
        var rays = new ObviousRays(room.grid());
        var log = new StringBuilder("# a robot in a room\n");
        Pose2d from = room.pose('a', 0);
        Pose2d to = room.pose('b', 0);
        for (int i = first; i <= last; i++) {
            double share = i <= 20 ? i / 20.0 : (40 - i) / 20.0;
            var pose = new Pose2d(
                    from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), 0.15 * i);
            log.append("FLASER 181");
            for (int beam = 0; beam < 181; beam++) {
                double range =
                        rays.range(pose.compose(new Pose2d(0, 0, Math.toRadians(upsideDown ? 90 - beam : beam - 90))));
                log.append(String.format(Locale.ROOT, " %.3f", Math.min(range, 81.91)));
            }
            Pose2d reported = shift.compose(pose);
            log.append(at(correction.compose(reported)))
                    .append(at(reported))
                    .append(" %d h %d\n".formatted(i + 1, i + 1));
        }
        return log.toString();
    }

    private static String at(Pose2d pose) {
        return String.format(Locale.ROOT, " %.5f %.5f %.5f", pose.x(), pose.y(), pose.theta());
    }
}
