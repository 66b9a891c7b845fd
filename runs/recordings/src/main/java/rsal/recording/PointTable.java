package rsal.recording;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/// A row is a point of a cloud (a particle), its columns are what is packed of each: those that are 32-bit floats, as
/// ours are.
record PointTable() implements MessageTable {
    private static final String FRAME = "frame_id";

    /// @param offset in a point [B]
    private record Packed(String name, int offset) {}

    @Override
    public List<String> columns(Map<String, Object> first) {
        var columns = new ArrayList<>(List.of(FRAME));
        packed(first).forEach(each -> columns.add(each.name));
        return columns;
    }

    @Override
    public List<Map<String, String>> rows(Map<String, Object> message) {
        var rows = new ArrayList<Map<String, String>>();
        if (message.get("data") instanceof byte[] bytes
                && message.get("point_stride") instanceof Long stride
                && stride > 0) {
            List<Packed> fields = packed(message);
            ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
            for (long at = 0; at + stride <= bytes.length; at += stride) {
                var row = new HashMap<>(Map.of(FRAME, String.valueOf(message.get(FRAME))));
                for (Packed field : fields) {
                    if (field.offset + Float.BYTES <= stride) {
                        row.put(field.name, Float.toString(data.getFloat((int) at + field.offset)));
                    }
                }
                rows.add(row);
            }
        }
        return rows;
    }

    private static List<Packed> packed(Map<String, Object> message) {
        var packed = new ArrayList<Packed>();
        if (message.get("fields") instanceof List<?> fields) {
            for (Object each : fields) {
                if (each instanceof Map<?, ?> field
                        && "FLOAT32".equals(field.get("type"))
                        && field.get("offset") instanceof Long offset
                        && offset >= 0
                        && offset <= Integer.MAX_VALUE - Float.BYTES) {
                    packed.add(new Packed(String.valueOf(field.get("name")), offset.intValue()));
                }
            }
        }
        return packed;
    }
}
