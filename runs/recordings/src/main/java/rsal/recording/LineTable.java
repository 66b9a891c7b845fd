package rsal.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/// A row is a point of a line (a path), the first the nearest to where it begins. A line that is taken away is a row
/// without a point.
record LineTable() implements MessageTable {
    private static final List<String> COORDINATES = List.of("x", "y");

    @Override
    public List<String> columns(Map<String, Object> first) {
        var columns = new ArrayList<>(List.of("frame_id", "point"));
        columns.addAll(COORDINATES);
        return columns;
    }

    @Override
    public List<Map<String, String>> rows(Map<String, Object> message) {
        var rows = new ArrayList<Map<String, String>>();
        for (Map<?, ?> entity : maps(message.get("entities"))) {
            for (Map<?, ?> line : maps(entity.get("lines"))) {
                List<Map<?, ?>> points = maps(line.get("points"));
                for (int i = 0; i < points.size(); i++) {
                    rows.add(Map.of(
                            "frame_id", String.valueOf(entity.get("frame_id")),
                            "point", Integer.toString(i),
                            "x", String.valueOf(points.get(i).get("x")),
                            "y", String.valueOf(points.get(i).get("y"))));
                }
            }
        }
        maps(message.get("deletions")).forEach(_ -> rows.add(Map.of()));
        return rows;
    }

    private static List<Map<?, ?>> maps(@Nullable Object list) {
        var maps = new ArrayList<Map<?, ?>>();
        if (list instanceof List<?> all) {
            all.forEach(each -> {
                if (each instanceof Map<?, ?> map) {
                    maps.add(map);
                }
            });
        }
        return maps;
    }
}
