package rsal.environment;

import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.FiducialFinder;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Where the robot's own slot in a formation is, relative to a leader with a marker: position in the base frame, the
/// leader's heading, and whether the leader is seen. While it is hidden, the slot is where it was seen last.
public final class SlotObservation implements ObservationType {
    private static final Parameter<Integer> LEADER =
            Parameter.integer("leader", 0, 0, 1_000_000, "", "Id of the leader's marker.");
    private static final Parameter<List<Point2d>> SLOTS = Parameter.points(
            "slots", "Slots in the frame of the leader: of the first robot of the role, of the second one, and so on.");
    private static final Parameter<Double> MAX =
            Parameter.number("max", 10, 0.1, 1000, "m", "Greatest coordinate; those beyond count as this one.");

    @Override
    public String key() {
        return "slot";
    }

    @Override
    public String description() {
        return "Position of the robot's own slot in a formation, in the base frame [m], and heading of the leader.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(LEADER, SLOTS, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        List<Point2d> slots = arguments.get(SLOTS);
        if (slots.isEmpty()) {
            throw new IllegalArgumentException("'slots' must name at least one slot, as \"-1 1; -1 -1\".");
        }
        return new Slot(arguments.get(LEADER), slots, arguments.get(MAX).floatValue());
    }

    private record Slot(int leader, List<Point2d> slots, float max) implements LearnerObservation {
        @Override
        public List<String> fields() {
            return List.of(
                    "x of slot [m]",
                    "y of slot [m]",
                    "cosine of leader's heading",
                    "sine of leader's heading",
                    "leader is seen");
        }

        @Override
        public float[] low() {
            return new float[] {-max, -max, -1, -1, 0};
        }

        @Override
        public float[] high() {
            return new float[] {max, max, 1, 1, 1};
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            FiducialFinder finder = robot.find(FiducialFinder.class)
                    .orElseThrow(() -> new IllegalArgumentException(
                            "Robot '%s' has no fiducial detector for the observation 'slot'. Maybe 'fiducials: fiducials360'?"
                                    .formatted(robot.id())));
            return new Follower(this, finder, slots.get(number(robot.id()) % slots.size()));
        }

        /// From 0 on: 1 of `follower-2`, 0 without a number.
        private static int number(String id) {
            String digits = id.substring(id.lastIndexOf('-') + 1);
            return digits.chars().allMatch(each -> each >= '0' && each <= '9') && !digits.isEmpty()
                    ? Math.max(0, Integer.parseInt(digits) - 1)
                    : 0;
        }
    }

    private static final class Follower implements LearnerObservation.Reader {
        private final Slot wanted;
        private final FiducialFinder finder;
        private final Point2d leaderFromSlot;
        private @Nullable Pose2d baseFromLeader; // as it was seen last

        Follower(Slot wanted, FiducialFinder finder, Point2d leaderFromSlot) {
            this.wanted = wanted;
            this.finder = finder;
            this.leaderFromSlot = leaderFromSlot;
        }

        @Override
        public void read(float[] to, int at) {
            Pose2d seen = finder.latest().stream()
                    .flatMap(newest -> newest.value().fiducials().stream())
                    .filter(each -> each.id().orElse(-1) == wanted.leader)
                    .map(Fiducial::baseFromFiducial)
                    .findFirst()
                    .orElse(null);
            if (seen != null) {
                baseFromLeader = seen;
            }
            Pose2d leader = baseFromLeader == null ? Pose2d.ORIGIN : baseFromLeader;
            Point2d slot = baseFromLeader == null ? Pose2d.ORIGIN.position() : leader.transform(leaderFromSlot);
            Bounds.put(slot.x(), slot.y(), wanted.max, to, at);
            to[at + 2] = (float) Math.cos(leader.theta());
            to[at + 3] = (float) Math.sin(leader.theta());
            to[at + 4] = seen == null ? 0 : 1;
        }
    }
}
