package rsal.recording;

import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Kind;

/// Our own kinds of messages, for what Foxglove has none for. Units and meanings are in `docs/reference/recordings.md`.
final class Own {
    static final MessageType POSE = MessageType.named("rsal.Pose")
            .with(1, "x", Kind.DOUBLE)
            .with(2, "y", Kind.DOUBLE)
            .with(3, "heading", Kind.DOUBLE);
    static final MessageType ESTIMATE = MessageType.named("rsal.Estimate")
            .with(1, "frame_id", Kind.STRING)
            .with(2, "pose", POSE)
            .with(3, "xx", Kind.DOUBLE)
            .with(4, "xy", Kind.DOUBLE)
            .with(5, "yy", Kind.DOUBLE)
            .with(6, "headings", Kind.DOUBLE)
            .with(7, "confidence", Kind.DOUBLE)
            .with(8, "quality", Kind.STRING);
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
            .with(18, "stand_in", POSE);
    static final MessageType STATE = MessageType.named("rsal.State")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "hash", Kind.STRING)
            .with(3, "stopped", Kind.BOOL)
            .withMany(4, "robots", ROBOT_STATE);
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
            .with(7, "reason", Kind.STRING);
    static final MessageType RANGES = MessageType.named("rsal.Ranges")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "frame_id", Kind.STRING)
            .with(3, "field_of_view", Kind.DOUBLE)
            .with(4, "range_min", Kind.DOUBLE)
            .with(5, "range_max", Kind.DOUBLE)
            .withMany(6, "poses", POSE)
            .withMany(7, "ranges", Kind.DOUBLE);
    static final MessageType EVENT = MessageType.named("rsal.Event")
            .with(1, "timestamp", Foxglove.TIMESTAMP)
            .with(2, "sequence", Kind.UINT64)
            .with(3, "kind", Kind.STRING)
            .with(4, "subject", Kind.STRING)
            .with(5, "text", Kind.STRING)
            .with(6, "hash", Kind.STRING);
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

    private Own() {}
}
