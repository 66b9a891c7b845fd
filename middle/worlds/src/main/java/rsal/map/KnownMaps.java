package rsal.map;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.function.Supplier;

/// Cells of maps that were read, for those who read the same maps again: they get the very same cells, by which
/// others recognize a map and keep what they computed of it. Nobody may write to them.
///
/// An image counts by its content, not by its name, since its file may be written to. Keeps the newest few. Any
/// thread may ask.
public final class KnownMaps {
    private static final int MOST = 4;
    private static final long MOST_CELLS = 32_000_000; // of all that are kept

    private final LinkedHashMap<Image, MapImage> known = new LinkedHashMap<>(); // the oldest first

    /// How an image is read, and its file.
    private static final class Image {
        private final Shading shading;
        private final byte[] bytes;
        private final int hash;

        Image(Shading shading, byte[] bytes) {
            this.shading = shading;
            this.bytes = bytes;
            this.hash = 31 * shading.hashCode() + Arrays.hashCode(bytes);
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Image image && shading.equals(image.shading) && Arrays.equals(bytes, image.bytes);
        }

        @Override
        public int hashCode() {
            return hash;
        }
    }

    /// @param bytes of the image's file; handed over, not shared
    /// @param read reads it, if it is not known
    synchronized MapImage of(byte[] bytes, Shading shading, Supplier<MapImage> read) {
        var image = new Image(shading, bytes);
        MapImage found = known.get(image);
        if (found == null) {
            found = read.get();
            known.putLast(image, found);
            while (known.size() > MOST || (known.size() > 1 && cells() > MOST_CELLS)) {
                known.pollFirstEntry();
            }
        }
        return found;
    }

    private long cells() {
        return known.values().stream().mapToLong(map -> map.cells().length).sum();
    }
}
