package rsal.map;

import java.nio.charset.StandardCharsets;
import rsal.data.OccupancyGrid;

/// Writes maps in the format of ROS's `map_server`, as [Maps] reads them: a YAML file and an image, PGM.
public final class RosMap {
    private RosMap() {}

    /// The YAML file's text.
    ///
    /// @param image name of the image's file, beside it
    public static String yaml(OccupancyGrid map, String image) {
        return """
                image: '%s'
                resolution: %s
                origin: [%s, %s, 0.0]
                occupied_thresh: 0.65
                free_thresh: 0.196
                negate: 0
                """.formatted(image.replace("'", "''"), map.resolution(), map.originX(), map.originY());
    }

    /// The image: black where it is occupied, white where it is free, gray where nothing is known.
    public static byte[] pgm(OccupancyGrid map) {
        byte[] head = "P5\n%d %d\n255\n".formatted(map.width(), map.height()).getBytes(StandardCharsets.US_ASCII);
        var bytes = new byte[head.length + map.cells().length];
        System.arraycopy(head, 0, bytes, 0, head.length);
        int next = head.length;
        for (int row = map.height() - 1; row >= 0; row--) {
            for (int column = 0; column < map.width(); column++) {
                bytes[next++] = (byte)
                        switch (map.at(column, row)) {
                            case OccupancyGrid.OCCUPIED -> 0;
                            case OccupancyGrid.FREE -> 254;
                            default -> 205;
                        };
            }
        }
        return bytes;
    }
}
