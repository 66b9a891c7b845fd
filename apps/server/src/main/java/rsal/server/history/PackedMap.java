package rsal.server.history;

import java.io.ByteArrayOutputStream;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import rsal.data.OccupancyGrid;

/// A map in a few bytes: most cells are as those beside them.
///
/// @param cells deflated
record PackedMap(Size size, byte[] cells) {
    /// As an [OccupancyGrid] has them.
    record Size(int width, int height, double resolution, double originX, double originY) {}

    static PackedMap of(OccupancyGrid map) {
        var size = new Size(map.width(), map.height(), map.resolution(), map.originX(), map.originY());
        try (var deflater = new Deflater(Deflater.BEST_SPEED)) {
            deflater.setInput(map.cells());
            deflater.finish();
            var packed = new ByteArrayOutputStream();
            byte[] piece = new byte[1 << 12];
            while (!deflater.finished()) {
                packed.write(piece, 0, deflater.deflate(piece));
            }
            return new PackedMap(size, packed.toByteArray());
        }
    }

    OccupancyGrid map() {
        byte[] all = new byte[size.width * size.height];
        try (var inflater = new Inflater()) {
            inflater.setInput(cells);
            inflater.inflate(all);
        } catch (DataFormatException e) {
            throw new AssertionError("It was packed here.", e);
        }
        return new OccupancyGrid(size.width, size.height, size.resolution, size.originX, size.originY, all);
    }
}
