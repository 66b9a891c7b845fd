package rsal.recording;

import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Kind;
import rsal.recording.proto.ProtoWriter;

/// The well-known kinds of messages that Foxglove draws, with the numbers of their fields: docs.foxglove.dev,
/// "Message schemas". Of what scenes are made of, only what is written here.
final class Foxglove {
    static final MessageType TIMESTAMP = MessageType.named("google.protobuf.Timestamp")
            .with(1, "seconds", Kind.INT64)
            .with(2, "nanos", Kind.INT32);
    static final MessageType DURATION = MessageType.named("google.protobuf.Duration")
            .with(1, "seconds", Kind.INT64)
            .with(2, "nanos", Kind.INT32);
    static final MessageType VECTOR3 = xyz("foxglove.Vector3");
    static final MessageType POINT3 = xyz("foxglove.Point3");
    static final MessageType VECTOR2 =
            MessageType.named("foxglove.Vector2").with(1, "x", Kind.DOUBLE).with(2, "y", Kind.DOUBLE);
    static final MessageType QUATERNION = xyz("foxglove.Quaternion").with(4, "w", Kind.DOUBLE);
    static final MessageType POSE =
            MessageType.named("foxglove.Pose").with(1, "position", VECTOR3).with(2, "orientation", QUATERNION);
    static final MessageType COLOR = MessageType.named("foxglove.Color")
            .with(1, "r", Kind.DOUBLE)
            .with(2, "g", Kind.DOUBLE)
            .with(3, "b", Kind.DOUBLE)
            .with(4, "a", Kind.DOUBLE);
    static final MessageType KEY_VALUE = MessageType.named("foxglove.KeyValuePair")
            .with(1, "key", Kind.STRING)
            .with(2, "value", Kind.STRING);
    static final MessageType PACKED_FIELD = MessageType.named("foxglove.PackedElementField")
            .with(1, "name", Kind.STRING)
            .with(2, "offset", Kind.FIXED32)
            .withEnum(
                    3,
                    "type",
                    "NumericType",
                    List.of("UNKNOWN", "UINT8", "INT8", "UINT16", "INT16", "UINT32", "INT32", "FLOAT32", "FLOAT64"));

    static final MessageType FRAME_TRANSFORM = MessageType.named("foxglove.FrameTransform")
            .with(1, "timestamp", TIMESTAMP)
            .with(2, "parent_frame_id", Kind.STRING)
            .with(3, "child_frame_id", Kind.STRING)
            .with(4, "translation", VECTOR3)
            .with(5, "rotation", QUATERNION);
    static final MessageType FRAME_TRANSFORMS =
            MessageType.named("foxglove.FrameTransforms").withMany(1, "transforms", FRAME_TRANSFORM);
    static final MessageType POSE_IN_FRAME = inFrame("foxglove.PoseInFrame").with(3, "pose", POSE);
    static final MessageType LASER_SCAN = inFrame("foxglove.LaserScan")
            .with(3, "pose", POSE)
            .with(4, "start_angle", Kind.DOUBLE)
            .with(5, "end_angle", Kind.DOUBLE)
            .withMany(6, "ranges", Kind.DOUBLE)
            .withMany(7, "intensities", Kind.DOUBLE);
    static final MessageType GRID = inFrame("foxglove.Grid")
            .with(3, "pose", POSE)
            .with(4, "column_count", Kind.FIXED32)
            .with(5, "cell_size", VECTOR2)
            .with(6, "row_stride", Kind.FIXED32)
            .with(7, "cell_stride", Kind.FIXED32)
            .withMany(8, "fields", PACKED_FIELD)
            .with(9, "data", Kind.BYTES);
    static final MessageType POINT_CLOUD = inFrame("foxglove.PointCloud")
            .with(3, "pose", POSE)
            .with(4, "point_stride", Kind.FIXED32)
            .withMany(5, "fields", PACKED_FIELD)
            .with(6, "data", Kind.BYTES);
    static final MessageType LOG = MessageType.named("foxglove.Log")
            .with(1, "timestamp", TIMESTAMP)
            .withEnum(2, "level", "Level", List.of("UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL"))
            .with(3, "message", Kind.STRING)
            .with(4, "name", Kind.STRING)
            .with(5, "file", Kind.STRING)
            .with(6, "line", Kind.FIXED32);

    private static final MessageType LINE = MessageType.named("foxglove.LinePrimitive")
            .withEnum(1, "type", "Type", List.of("LINE_STRIP", "LINE_LOOP", "LINE_LIST"))
            .with(2, "pose", POSE)
            .with(3, "thickness", Kind.DOUBLE)
            .with(4, "scale_invariant", Kind.BOOL)
            .withMany(5, "points", POINT3)
            .with(6, "color", COLOR)
            .withMany(7, "colors", COLOR)
            .withMany(8, "indices", Kind.FIXED32);
    private static final MessageType TRIANGLES = MessageType.named("foxglove.TriangleListPrimitive")
            .with(1, "pose", POSE)
            .withMany(2, "points", POINT3)
            .with(3, "color", COLOR)
            .withMany(4, "colors", COLOR)
            .withMany(5, "indices", Kind.FIXED32);
    private static final MessageType DELETION = MessageType.named("foxglove.SceneEntityDeletion")
            .with(1, "timestamp", TIMESTAMP)
            .withEnum(2, "type", "Type", List.of("MATCHING_ID", "ALL"))
            .with(3, "id", Kind.STRING);
    private static final MessageType ENTITY = MessageType.named("foxglove.SceneEntity")
            .with(1, "timestamp", TIMESTAMP)
            .with(2, "frame_id", Kind.STRING)
            .with(3, "id", Kind.STRING)
            .with(4, "lifetime", DURATION)
            .with(5, "frame_locked", Kind.BOOL)
            .withMany(6, "metadata", KEY_VALUE)
            .withMany(11, "lines", LINE)
            .withMany(12, "triangles", TRIANGLES);
    static final MessageType SCENE_UPDATE = MessageType.named("foxglove.SceneUpdate")
            .withMany(1, "deletions", DELETION)
            .withMany(2, "entities", ENTITY);

    private Foxglove() {}

    /// Writes a [#POSE], as seen from above.
    static void pose(ProtoWriter out, int field, Pose2d pose) {
        int begun = out.begin(field);
        vector(out, 1, pose.x(), pose.y(), 0);
        quaternion(out, 2, pose.theta());
        out.end(begun);
    }

    /// Writes a [#VECTOR3], or a point.
    static void vector(ProtoWriter out, int field, double x, double y, double z) {
        int begun = out.begin(field);
        out.number(1, x);
        out.number(2, y);
        out.number(3, z);
        out.end(begun);
    }

    /// Writes a [#QUATERNION]: a turn about the upward axis.
    static void quaternion(ProtoWriter out, int field, double heading) {
        int begun = out.begin(field);
        out.number(3, Math.sin(heading / 2));
        out.number(4, Math.cos(heading / 2));
        out.end(begun);
    }

    /// Writes the fields of a [#GRID] from 3 on.
    static void grid(ProtoWriter out, OccupancyGrid map) {
        pose(out, 3, new Pose2d(map.originX(), map.originY(), 0));
        out.fixed32(4, map.width());
        int size = out.begin(5);
        out.number(1, map.resolution());
        out.number(2, map.resolution());
        out.end(size);
        out.fixed32(6, map.width());
        out.fixed32(7, 1);
        field(out, 8, "occupancy", 0, 2);
        out.bytes(9, map.cells());
    }

    /// Writes a [#PACKED_FIELD].
    static void field(ProtoWriter out, int field, String name, int offset, int type) {
        int begun = out.begin(field);
        out.string(1, name);
        out.fixed32(2, offset);
        out.varint(3, type);
        out.end(begun);
    }

    private static MessageType xyz(String name) {
        return MessageType.named(name)
                .with(1, "x", Kind.DOUBLE)
                .with(2, "y", Kind.DOUBLE)
                .with(3, "z", Kind.DOUBLE);
    }

    private static MessageType inFrame(String name) {
        return MessageType.named(name).with(1, "timestamp", TIMESTAMP).with(2, "frame_id", Kind.STRING);
    }
}
