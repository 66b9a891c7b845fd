package rsal.recording;

import java.util.List;
import java.util.Map;
import rsal.recording.proto.MessageType;

/// How messages of a type become rows of a table. A message is as [rsal.recording.proto.ProtoReader] has it.
interface MessageTable {
    static MessageTable of(MessageType type) {
        if (type.equals(Foxglove.POINT_CLOUD)) {
            return new PointTable();
        }
        return type.equals(Foxglove.SCENE_UPDATE) ? new LineTable() : new FieldTable(type);
    }

    /// Names of its columns.
    ///
    /// @param first message of the table; empty when there is none
    List<String> columns(Map<String, Object> first);

    /// @return cells by column
    List<Map<String, String>> rows(Map<String, Object> message);
}
