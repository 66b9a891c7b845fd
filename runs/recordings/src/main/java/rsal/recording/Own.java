package rsal.recording;

import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Twist2d;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Kind;
import rsal.recording.proto.ProtoWriter;

/// Our own kinds of messages, for what Foxglove has none for. Units and meanings are in `docs/reference/recordings.md`.
final class Own {
    static final MessageType POSE = MessageType.named("rsal.Pose")
            .with(1, "x", Kind.DOUBLE)
            .with(2, "y", Kind.DOUBLE)
            .with(3, "heading", Kind.DOUBLE);
    static final MessageType HYPOTHESIS = MessageType.named("rsal.Hypothesis")
            .with(1, "weight", Kind.DOUBLE)
            .with(2, "pose", POSE)
            .with(3, "xx", Kind.DOUBLE)
            .with(4, "xy", Kind.DOUBLE)
            .with(5, "yy", Kind.DOUBLE)
            .with(6, "headings", Kind.DOUBLE);
    static final MessageType ESTIMATE = MessageType.named("rsal.Estimate")
            .with(1, "frame_id", Kind.STRING)
            .with(2, "pose", POSE)
            .with(3, "xx", Kind.DOUBLE)
            .with(4, "xy", Kind.DOUBLE)
            .with(5, "yy", Kind.DOUBLE)
            .with(6, "headings", Kind.DOUBLE)
            .with(7, "confidence", Kind.DOUBLE)
            .with(8, "quality", Kind.STRING)
            .withMany(9, "hypotheses", HYPOTHESIS);
    static final MessageType CARRIED = MessageType.named("rsal.Carried")
            .with(1, "pose", POSE)
            .with(2, "rise", Kind.DOUBLE)
            .withMany(3, "pieces", Kind.DOUBLE)
            .withMany(4, "devices", Kind.STRING);
    static final MessageType ROBOT_STATE = MessageType.named("rsal.RobotState")
            .with(1, "id", Kind.STRING)
            .with(2, "gone", Kind.BOOL)
            .with(3, "truth", POSE)
            .with(4, "odometry", POSE)
            .with(5, "vx", Kind.DOUBLE)
            .with(6, "vy", Kind.DOUBLE)
            .with(7, "omega", Kind.DOUBLE)
            .with(8, "stalled", Kind.BOOL)
            .with(9, "estimate", ESTIMATE)
            .with(10, "goal", POSE)
            .with(11, "in_charge", Kind.STRING)
            .with(12, "behavior", Kind.STRING)
            .with(13, "driver", Kind.STRING)
            .with(14, "gripper_closed", Kind.DOUBLE)
            .with(15, "gripper_holding", Kind.BOOL)
            .with(16, "has_gripper", Kind.BOOL)
            .with(17, "lit", Kind.BOOL)
            .with(18, "stand_in", POSE)
            .with(19, "stopped", Kind.BOOL)
            .with(20, "real", Kind.BOOL)
            .with(21, "proxy", Kind.BOOL)
            .with(22, "silence", Kind.DOUBLE)
            .withMany(23, "lacks", Kind.STRING)
            .with(24, "gripper_raised", Kind.DOUBLE)
            .withMany(25, "carried", CARRIED)
            .with(26, "switched_off", Kind.BOOL)
            .with(27, "gone_for", Kind.DOUBLE);
    static final MessageType STATE = MessageType.named("rsal.State")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "hash", Kind.STRING)
            .with(3, "stopped", Kind.BOOL)
            .withMany(4, "robots", ROBOT_STATE);
    static final MessageType PIECE = MessageType.named("rsal.Piece")
            .with(1, "color", Kind.STRING)
            .with(2, "bottom", Kind.DOUBLE)
            .with(3, "top", Kind.DOUBLE)
            .with(4, "radius", Kind.DOUBLE)
            .withMany(5, "corners", Kind.DOUBLE);
    static final MessageType THING = MessageType.named("rsal.Thing")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "number", Kind.UINT64)
            .with(3, "name", Kind.STRING)
            .with(4, "pose", POSE)
            .with(5, "height", Kind.DOUBLE)
            .with(6, "gone", Kind.BOOL)
            .withMany(7, "pieces", PIECE)
            .with(8, "grippable", Kind.BOOL);
    static final MessageType ROBOT = MessageType.named("rsal.Robot")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "id", Kind.STRING)
            .with(3, "role", Kind.STRING)
            .with(4, "color", Kind.STRING)
            .with(5, "model", Kind.STRING);
    static final MessageType DEVICE = MessageType.named("rsal.Device")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "robot", Kind.STRING)
            .with(3, "name", Kind.STRING)
            .with(4, "driver", Kind.STRING)
            .with(5, "type", Kind.STRING)
            .with(6, "health", Kind.STRING)
            .with(7, "reason", Kind.STRING)
            .with(8, "topic", Kind.STRING);
    static final MessageType RANGES = reading("rsal.Ranges")
            .with(3, "field_of_view", Kind.DOUBLE)
            .with(4, "range_min", Kind.DOUBLE)
            .with(5, "range_max", Kind.DOUBLE)
            .withMany(6, "poses", POSE)
            .withMany(7, "ranges", Kind.DOUBLE);
    static final MessageType SAID = MessageType.named("rsal.Said")
            .with(1, "to", Kind.STRING)
            .with(2, "topic", Kind.STRING)
            .with(3, "conversation", Kind.STRING)
            .with(4, "protocol", Kind.STRING)
            .with(5, "act", Kind.STRING);
    static final MessageType EVENT = MessageType.named("rsal.Event")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "sequence", Kind.UINT64)
            .with(3, "kind", Kind.STRING)
            .with(4, "subject", Kind.STRING)
            .with(5, "text", Kind.STRING)
            .with(6, "hash", Kind.STRING)
            .with(7, "said", SAID);
    static final MessageType MESSAGE = MessageType.named("rsal.Message")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "from", Kind.STRING)
            .with(3, "to", Kind.STRING)
            .with(4, "topic", Kind.STRING)
            .with(5, "conversation", Kind.STRING)
            .with(6, "protocol", Kind.STRING)
            .with(7, "act", Kind.STRING)
            .with(8, "words", Kind.STRING);
    static final MessageType AGENT = MessageType.named("rsal.Agent")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "name", Kind.STRING)
            .with(3, "role", Kind.STRING)
            .with(4, "type", Kind.STRING)
            .with(5, "robot", Kind.STRING)
            .with(6, "status", Kind.STRING)
            .with(7, "state", Kind.STRING)
            .withMany(8, "beliefs", Foxglove.KEY_VALUE);
    static final MessageType GOAL = MessageType.named("rsal.Goal")
            .with(1, "name", Kind.STRING)
            .with(2, "state", Kind.STRING)
            .with(3, "urgency", Kind.DOUBLE)
            .withMany(4, "plans", Kind.STRING)
            .withMany(5, "steps", Kind.STRING)
            .with(6, "failure", Kind.STRING);
    static final MessageType MIND = MessageType.named("rsal.Mind")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "agent", Kind.STRING)
            .withMany(3, "beliefs", Foxglove.KEY_VALUE)
            .withMany(4, "goals", GOAL);

    static final MessageType LINK = MessageType.named("rsal.Link")
            .with(1, "one", Kind.STRING)
            .with(2, "other", Kind.STRING)
            .with(3, "there", Kind.BOOL)
            .with(4, "back", Kind.BOOL)
            .with(5, "said_there", Kind.BOOL)
            .with(6, "said_back", Kind.BOOL);
    static final MessageType LINKS = MessageType.named("rsal.Links")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .withMany(2, "links", LINK)
            .with(3, "too_many", Kind.BOOL);

    // what devices tell: see ReadingType

    static final MessageType TWIST = MessageType.named("rsal.Twist")
            .with(1, "vx", Kind.DOUBLE)
            .with(2, "vy", Kind.DOUBLE)
            .with(3, "omega", Kind.DOUBLE);
    static final MessageType ACTUATOR_STATE = reading("rsal.ActuatorState")
            .with(3, "joint", Kind.STRING)
            .with(4, "position", Kind.DOUBLE)
            .with(5, "speed", Kind.DOUBLE)
            .with(6, "least", Kind.DOUBLE)
            .with(7, "most", Kind.DOUBLE)
            .with(8, "motion", Kind.STRING);
    static final MessageType BATTERY_STATE = reading("rsal.BatteryState")
            .with(3, "charge", Kind.DOUBLE)
            .with(4, "capacity", Kind.DOUBLE)
            .with(5, "level", Kind.DOUBLE)
            .with(6, "power", Kind.DOUBLE)
            .with(7, "voltage", Kind.DOUBLE)
            .with(8, "charging", Kind.STRING);
    static final MessageType BLOB = MessageType.named("rsal.Blob")
            .with(1, "color", Kind.STRING)
            .with(2, "left", Kind.INT64)
            .with(3, "top", Kind.INT64)
            .with(4, "right", Kind.INT64)
            .with(5, "bottom", Kind.INT64)
            .with(6, "x", Kind.DOUBLE)
            .with(7, "y", Kind.DOUBLE)
            .with(8, "area", Kind.INT64)
            .with(9, "range", Kind.DOUBLE);
    static final MessageType BLOBS = reading("rsal.Blobs")
            .with(3, "pose", POSE)
            .with(4, "width", Kind.INT64)
            .with(5, "height", Kind.INT64)
            .with(6, "field_of_view", Kind.DOUBLE)
            .withMany(7, "blobs", BLOB);
    static final MessageType BUMPER =
            MessageType.named("rsal.Bumper").with(1, "pose", POSE).with(2, "pressed", Kind.BOOL);
    static final MessageType BUMPER_STATE = reading("rsal.BumperState").withMany(3, "bumpers", BUMPER);
    static final MessageType OPINION = MessageType.named("rsal.Opinion")
            .with(1, "layer", Kind.STRING)
            .with(2, "twist", TWIST)
            .with(3, "state", Kind.STRING);
    static final MessageType DECISION = reading("rsal.Decision")
            .with(3, "twist", TWIST)
            .with(4, "in_charge", Kind.STRING)
            .withMany(5, "opinions", OPINION);
    static final MessageType FIDUCIAL = MessageType.named("rsal.Fiducial")
            .with(1, "has_id", Kind.BOOL)
            .with(2, "id", Kind.INT64)
            .with(3, "pose", POSE);
    static final MessageType FIDUCIALS = reading("rsal.Fiducials")
            .with(3, "pose", POSE)
            .with(4, "field_of_view", Kind.DOUBLE)
            .with(5, "range_max", Kind.DOUBLE)
            .withMany(6, "fiducials", FIDUCIAL);
    static final MessageType GRIPPER_STATE = reading("rsal.GripperState")
            .with(3, "paddles", Kind.STRING)
            .with(4, "closed", Kind.DOUBLE)
            .with(5, "lift", Kind.STRING)
            .with(6, "raised", Kind.DOUBLE)
            .with(7, "inner_beam_broken", Kind.BOOL)
            .with(8, "outer_beam_broken", Kind.BOOL)
            .with(9, "left_contact", Kind.BOOL)
            .with(10, "right_contact", Kind.BOOL)
            .with(11, "holding", Kind.BOOL);
    static final MessageType LIGHT_STATE = reading("rsal.LightState")
            .with(3, "color", Kind.STRING)
            .with(4, "period", Kind.DOUBLE)
            .with(5, "duty_cycle", Kind.DOUBLE)
            .with(6, "lit", Kind.BOOL);
    static final MessageType NAVIGATOR_STATE = reading("rsal.NavigatorState")
            .with(3, "goal", POSE)
            .with(4, "remaining", Kind.DOUBLE)
            .with(5, "paused", Kind.BOOL);
    static final MessageType PLANNER_ASKED = reading("rsal.PlannerAsked")
            .with(3, "start", POSE)
            .with(4, "goal", POSE)
            .with(5, "places", Kind.INT64)
            .with(6, "reachable", Kind.INT64)
            .with(7, "cost", Kind.DOUBLE)
            .with(8, "length", Kind.DOUBLE)
            .with(9, "why", Kind.STRING);
    static final MessageType ODOMETRY = reading("rsal.Odometry")
            .with(3, "pose", POSE)
            .with(4, "twist", TWIST)
            .with(5, "stalled", Kind.BOOL);
    static final MessageType POSE_ESTIMATE = reading("rsal.PoseEstimate")
            .with(3, "pose", POSE)
            .with(4, "xx", Kind.DOUBLE)
            .with(5, "xy", Kind.DOUBLE)
            .with(6, "yy", Kind.DOUBLE)
            .with(7, "headings", Kind.DOUBLE)
            .with(8, "confidence", Kind.DOUBLE)
            .with(9, "quality", Kind.STRING)
            .withMany(10, "hypotheses", HYPOTHESIS);
    static final MessageType QUANTITY = MessageType.named("rsal.Quantity")
            .with(1, "name", Kind.STRING)
            .with(2, "title", Kind.STRING)
            .with(3, "unit", Kind.STRING)
            .with(4, "value", Kind.DOUBLE);
    static final MessageType QUANTITIES = reading("rsal.Quantities").withMany(3, "quantities", QUANTITY);

    private Own() {}

    static MessageType reading(String name) {
        return MessageType.named(name).with(1, "timestamp", Foxglove.TIMESTAMP).with(2, "frame_id", Kind.STRING);
    }

    /// Writes a [#POSE].
    static void pose(ProtoWriter out, int field, Pose2d pose) {
        int begun = out.begin(field);
        out.number(1, pose.x());
        out.number(2, pose.y());
        out.number(3, pose.theta());
        out.end(begun);
    }

    /// Writes [#HYPOTHESIS]: all that are held, of an estimate that holds several.
    static void hypotheses(ProtoWriter out, int field, PoseEstimate belief) {
        if (belief.hypotheses().size() < 2) {
            return;
        }
        for (PoseEstimate.Hypothesis one : belief.hypotheses()) {
            int begun = out.begin(field);
            out.number(1, one.weight());
            pose(out, 2, one.mapFromBase());
            out.number(3, one.covariance().xx());
            out.number(4, one.covariance().xy());
            out.number(5, one.covariance().yy());
            out.number(6, one.covariance().thetaTheta());
            out.end(begun);
        }
    }

    /// Writes a [#TWIST].
    static void twist(ProtoWriter out, int field, Twist2d twist) {
        int begun = out.begin(field);
        out.number(1, twist.vx());
        out.number(2, twist.vy());
        out.number(3, twist.omega());
        out.end(begun);
    }
}
