package rsal.player.device;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import rsal.data.OccupancyGrid;
import rsal.player.message.MapInterface;
import rsal.player.wire.Address;
import rsal.time.Scheduler;

/// Reads the map of a server once, in tiles as large as they may be. On the scheduler's thread, but to unpack a tile,
/// which takes a while, on another. Whatever the server says, it takes no more memory than the largest map and two
/// answers.
final class MapReader {
    private static final int MOST_CELLS = 1 << 26; // as a map of ours may have
    private static final int AT_ONCE = 2; // tiles that are asked for
    private static final Duration PATIENCE = Duration.ofSeconds(10); // with a large one on a slow way

    private final RemoteServer server;
    private final Address map;
    private final Scheduler scheduler;
    private final MapInterface.Extent extent;
    private final byte[] cells;
    private final Deque<MapInterface.Tile> left = new ArrayDeque<>(); // to be asked for
    private final CompletableFuture<OccupancyGrid> whole = new CompletableFuture<>();
    private int under; // way

    private MapReader(RemoteServer server, Address map, MapInterface.Extent extent, Scheduler scheduler) {
        this.server = server;
        this.map = map;
        this.extent = extent;
        this.scheduler = scheduler;
        this.cells = new byte[extent.width() * extent.height()];
        int width = Math.min(extent.width(), MapInterface.LARGEST_TILE);
        int height = Math.min(extent.height(), MapInterface.LARGEST_TILE / width);
        for (int row = 0; row < extent.height(); row += height) {
            for (int column = 0; column < extent.width(); column += width) {
                left.add(new MapInterface.Tile(
                        column,
                        row,
                        Math.min(width, extent.width() - column),
                        Math.min(height, extent.height() - row),
                        0,
                        0,
                        new byte[0]));
            }
        }
    }

    /// @return the map; exceptionally, with a sentence, when there is none or the server tells what can't be one
    static CompletionStage<OccupancyGrid> read(RemoteServer server, Address map, Scheduler scheduler) {
        return server.ask(map, MapInterface.INFO, Optional.empty(), PATIENCE)
                .thenApply(MapReader::extent)
                .thenCompose(extent -> new MapReader(server, map, extent, scheduler).read());
    }

    private static MapInterface.Extent extent(Optional<Record> answer) {
        if (!(answer.orElse(null) instanceof MapInterface.Extent extent)) {
            throw refused("The server does not report the size of its map.");
        }
        long cells = (long) extent.width() * extent.height();
        if (extent.width() <= 0 || extent.height() <= 0 || cells > MOST_CELLS) {
            throw refused("It has (%s × %s) cells; at most %d can be read."
                    .formatted(
                            Integer.toUnsignedString(extent.width()),
                            Integer.toUnsignedString(extent.height()),
                            MOST_CELLS));
        }
        boolean possible = extent.scale() > 0
                && Float.isFinite(extent.scale())
                && Double.isFinite(extent.origin().x())
                && Double.isFinite(extent.origin().y());
        if (!possible) {
            throw refused("Its cells of (%s m) from (%s, %s) on are nowhere."
                    .formatted(
                            extent.scale(), extent.origin().x(), extent.origin().y()));
        }
        return extent;
    }

    private static CompletionException refused(String why) {
        return new CompletionException(new IOException(why));
    }

    private CompletionStage<OccupancyGrid> read() {
        goOn();
        return whole;
    }

    private void goOn() {
        while (under < AT_ONCE && !left.isEmpty() && !whole.isDone()) {
            under++;
            MapInterface.Tile tile = left.remove();
            server.ask(map, MapInterface.TILE, Optional.of(tile), PATIENCE)
                    .thenCompose(answer -> scheduler.compute(() -> unpacked(tile, answer)))
                    .whenComplete((unpacked, error) -> {
                        under--;
                        if (error == null) {
                            put(tile, unpacked);
                        } else {
                            whole.completeExceptionally(error);
                        }
                    });
        }
    }

    private void put(MapInterface.Tile tile, byte[] unpacked) {
        for (int row = 0; row < tile.height(); row++) {
            System.arraycopy(
                    unpacked,
                    row * tile.width(),
                    cells,
                    (tile.row() + row) * extent.width() + tile.column(),
                    tile.width());
        }
        goOn();
        if (under == 0 && left.isEmpty()) {
            whole.complete(new OccupancyGrid(
                    extent.width(),
                    extent.height(),
                    Double.parseDouble(Float.toString(extent.scale())), // 0.05, not 0.05000000074505806
                    extent.origin().x(),
                    extent.origin().y(),
                    cells));
        }
    }

    /// A tile's cells as ours, row by row.
    static byte[] unpacked(MapInterface.Tile asked, Optional<Record> answer) {
        if (!(answer.orElse(null) instanceof MapInterface.Tile tile)) {
            throw refused("The server reports nothing of %s.".formatted(words(asked)));
        }
        boolean fits = tile.column() == asked.column()
                && tile.row() == asked.row()
                && tile.width() == asked.width()
                && tile.height() == asked.height();
        if (!fits) {
            throw refused("The server reports %s instead of %s.".formatted(words(tile), words(asked)));
        }
        int count = asked.width() * asked.height();
        byte[] theirs = inflated(tile.cells(), count)
                .or(() -> Optional.of(tile.cells()).filter(raw -> raw.length == count))
                .orElseThrow(() -> refused("The %d bytes of %s are not its cells, packed or not."
                        .formatted(tile.cells().length, words(asked))));
        int range = Math.max(1, tile.range());
        var ours = new byte[count];
        for (int i = 0; i < count; i++) {
            ours[i] = cell(theirs[i], range);
        }
        return ours;
    }

    private static String words(MapInterface.Tile tile) {
        return "(%d × %d) cells from (%d, %d) on".formatted(tile.width(), tile.height(), tile.column(), tile.row());
    }

    /// Where a server has shades between free and occupied, it is what is nearer.
    private static byte cell(int value, int range) {
        if (2 * value > range) {
            return OccupancyGrid.OCCUPIED;
        }
        return 2 * value < -range ? OccupancyGrid.FREE : OccupancyGrid.UNKNOWN;
    }

    /// Empty when that is not so many bytes packed by zlib; unpacks one more at most.
    private static Optional<byte[]> inflated(byte[] packed, int count) {
        var inflater = new Inflater();
        try {
            inflater.setInput(packed);
            var bytes = new byte[count + 1];
            int length = 0;
            int more = -1;
            while (more != 0 && length <= count) {
                more = inflater.inflate(bytes, length, bytes.length - length);
                length += more;
            }
            return length == count && inflater.finished() ? Optional.of(Arrays.copyOf(bytes, count)) : Optional.empty();
        } catch (DataFormatException e) {
            return Optional.empty();
        } finally {
            inflater.end();
        }
    }
}
