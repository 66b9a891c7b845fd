package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import rsal.data.Pose2d;

/// Loops that were not believed because others, which were there before, contradict them. One is the wrong one as a
/// rule; where ever more agree on where the robot really is, what was there before is. That wrong places don't agree is
/// E. Olson's idea (see [LoopCloser]), and holds for looks that have nothing in common: frames that lie so near each
/// other that they are searched for together count as one.
final class Refused {
    private static final int KEPT = 24; // frames
    private static final int FEWEST = 2; // looks
    private static final double MARGIN = 2; // times the looks that are contradicted
    private static final double AGREE_METERS = 0.15;
    private static final double AGREE_RADIANS = 0.05;

    private final List<Relation> loops = new ArrayList<>();
    private int tried; // how many looks agreed when it was asked for last

    /// @param frame the newest
    void add(List<Relation> refused, int frame) {
        loops.removeIf(loop -> loop.to() < frame - KEPT);
        loops.addAll(refused);
    }

    void forget(List<Relation> some) {
        loops.removeAll(some);
        tried = 0;
    }

    /// Those that agree with one of the newest frame on where the robot is, by how the graph lies now; none when they
    /// are few, or no more than last time.
    List<Relation> agreeing(List<Pose2d> poses) {
        int newest = loops.stream().mapToInt(Relation::to).max().orElse(-1);
        List<Relation> most = loops.stream()
                .filter(loop -> loop.to() == newest)
                .map(loop -> LoopCloser.agreeing(loop, loops, poses, AGREE_METERS, AGREE_RADIANS))
                .max(Comparator.comparingInt(Refused::looks)) // of several the first
                .orElse(List.of());
        int looks = looks(most);
        boolean more = looks >= FEWEST && looks > tried;
        tried = looks;
        return more ? most : List.of();
    }

    /// Whether loops weigh more than those that they contradict.
    static boolean outweigh(List<Relation> loops, List<Relation> contradicted) {
        return looks(loops) >= MARGIN * looks(contradicted);
    }

    /// How many looks loops are told by that have nothing in common.
    private static int looks(List<Relation> loops) {
        int looks = 0;
        int last = -LoopCloser.RECENT;
        for (int frame : loops.stream().mapToInt(Relation::to).sorted().toArray()) {
            if (frame - last >= LoopCloser.RECENT) {
                looks++;
                last = frame;
            }
        }
        return looks;
    }
}
