package rsal.map;

import java.util.Arrays;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A map drawn with letters, one for each cell: `#` is occupied, `.` or a blank free, `?` unknown, as is what lies
/// behind the end of a line that is shorter than others.
final class LetterMap {
    private LetterMap() {}

    /// @param askedAt where the drawing is, for messages
    /// @throws InvalidSettings when there is another letter in it, or it is too large
    static MapImage read(String drawing, Location askedAt) {
        List<String> lines = drawing.lines().toList();
        int width = lines.stream().mapToInt(String::length).max().orElse(0);
        MapImage.checkSize(askedAt.file(), width, lines.size());
        var cells = new byte[width * lines.size()];
        Arrays.fill(cells, OccupancyGrid.UNKNOWN);
        for (int line = 0; line < lines.size(); line++) {
            int row = lines.size() - 1 - line;
            for (int column = 0; column < lines.get(line).length(); column++) {
                cells[row * width + column] = cell(lines.get(line), line, column, askedAt);
            }
        }
        return new MapImage(width, lines.size(), cells, 0);
    }

    private static byte cell(String drawn, int line, int column, Location askedAt) {
        return switch (drawn.charAt(column)) {
            case '#' -> OccupancyGrid.OCCUPIED;
            case '.', ' ' -> OccupancyGrid.FREE;
            case '?' -> OccupancyGrid.UNKNOWN;
            default ->
                throw new InvalidSettings(
                        askedAt,
                        "'drawing' has a '%s' in its line %d, column %d."
                                .formatted(drawn.charAt(column), line + 1, column + 1),
                        "Draw with # (occupied), . (free) and ? (unknown).");
        };
    }
}
