package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Pose2d;

/// Loops that were not believed because others, which were there before, contradict them. One is the wrong one as a
/// rule. Where ever more agree on where the robot really is, what was there before is: that wrong places don't agree
/// is E. Olson's idea, see [LoopCloser].
final class Refused {
    private static final int KEPT = 20; // frames
    private static final int FEWEST = 3; // frames that agree
    private static final double AGREE_METERS = 0.15;
    private static final double AGREE_RADIANS = 0.05;

    private final List<Relation> loops = new ArrayList<>();

    /// @param frame the newest
    void add(List<Relation> refused, int frame) {
        loops.removeIf(loop -> loop.to() < frame - KEPT);
        loops.addAll(refused);
    }

    void forget(List<Relation> some) {
        loops.removeAll(some);
    }

    /// Those that agree with the newest on where the robot is, by how the graph lies now; none when they are few.
    List<Relation> agreeing(List<Pose2d> poses) {
        if (loops.isEmpty()) {
            return List.of();
        }
        Relation newest = loops.getLast();
        Pose2d place = poses.get(newest.to());
        Pose2d corrected = LoopCloser.correction(newest, poses).compose(place);
        List<Relation> agreeing = loops.stream()
                .filter(loop -> LoopCloser.correction(loop, poses)
                        .compose(place)
                        .isNear(corrected, AGREE_METERS, AGREE_RADIANS))
                .toList();
        return frames(agreeing) >= FEWEST ? agreeing : List.of();
    }

    /// How many frames loops are told by: one that meets several runs of frames is one witness.
    static long frames(List<Relation> loops) {
        return loops.stream().map(Relation::to).distinct().count();
    }
}
