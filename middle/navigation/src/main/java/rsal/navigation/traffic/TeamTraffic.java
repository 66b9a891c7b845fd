package rsal.navigation.traffic;

import java.time.Instant;
import java.util.List;
import java.util.function.Supplier;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Rules for narrow passages and for junctions of wide corridors together. Passages come first: who waits for one does
/// not enter a junction meanwhile.
record TeamTraffic(RightOfWay passages, Intersections intersections) implements TrafficRule {
    @Override
    public TrafficAdvice advise(Instant now, Pose2d mapFromBase, Supplier<List<Point2d>> mapFromPath) {
        TrafficAdvice first = passages.advise(now, mapFromBase, mapFromPath);
        intersections.leaveFollowing(passages.hasClaim());
        if (first instanceof TrafficAdvice.Proceed) {
            return intersections.advise(now, mapFromBase, mapFromPath);
        }
        intersections.stands(now, mapFromBase);
        return first;
    }

    @Override
    public void stands(Instant now, Pose2d mapFromBase) {
        passages.stands(now, mapFromBase);
        intersections.stands(now, mapFromBase);
    }

    @Override
    public List<Point2d> closed(Instant now) {
        return passages.closed(now);
    }

    @Override
    public boolean isAmongOthers(Instant now, Pose2d mapFromBase) {
        return passages.isAmongOthers(now, mapFromBase) || intersections.isAmongOthers(now, mapFromBase);
    }

    @Override
    public boolean keepsLanes() {
        return intersections.keepsLanes();
    }
}
