package rsal.player.bridge;

import java.io.ByteArrayOutputStream;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import rsal.data.OccupancyGrid;
import rsal.device.DeviceInfo;
import rsal.device.Subscription;
import rsal.player.message.Interface;
import rsal.player.message.MapInterface;
import rsal.player.message.Pose;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// What robots know of the world that have been told, as `map`.
final class OfferedMap extends Offered {
    private static final int OCCUPIED = 1;
    private static final int USUAL = 640; // cells that Player's clients ask for, each way

    private final OccupancyGrid map;

    /// @param driver as clients are told
    OfferedMap(int index, OccupancyGrid map, String driver, Scheduler scheduler) {
        super(Interface.MAP, index, new DeviceInfo("", "map", driver), scheduler);
        this.map = map;
    }

    @Override
    Subscription listen() {
        return () -> {};
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST && (subtype == MapInterface.INFO || subtype == MapInterface.TILE);
    }

    /// At once, on the thread of the one that asks: a map never changes, and to pack a large one takes a while.
    @Override
    public CompletionStage<Answer> ask(Packet request) {
        try {
            return CompletableFuture.completedStage(answer(request).orElseGet(Answer.Refused::new));
        } catch (MalformedException e) {
            return CompletableFuture.completedStage(new Answer.Refused());
        }
    }

    @Override
    Optional<Answer> answer(Packet request) throws MalformedException {
        return switch (request.header().subtype()) {
            case MapInterface.INFO ->
                Optional.of(new Answer.Reported(new MapInterface.Extent(
                        (float) map.resolution(),
                        map.width(),
                        map.height(),
                        new Pose(map.originX(), map.originY(), 0))));
            case MapInterface.TILE -> tile(request.body(MapInterface.Tile.class));
            default -> Optional.empty();
        };
    }

    private Optional<Answer> tile(MapInterface.Tile asked) {
        long count = (long) asked.width() * asked.height();
        boolean inBounds = asked.width() > 0
                && asked.height() > 0
                && count <= Math.min(MapInterface.LARGEST_TILE, Math.max(USUAL * USUAL, map.cells().length));
        if (!inBounds) {
            return Optional.empty();
        }
        byte[] packed = packed(cells(asked));
        return Optional.of(new Answer.Reported(new MapInterface.Tile(
                asked.column(), asked.row(), asked.width(), asked.height(), packed.length, OCCUPIED, packed)));
    }

    private byte[] cells(MapInterface.Tile tile) {
        var cells = new byte[tile.width() * tile.height()];
        for (int row = 0; row < tile.height(); row++) {
            for (int column = 0; column < tile.width(); column++) {
                cells[row * tile.width() + column] = cell(tile.column() + column, tile.row() + row);
            }
        }
        return cells;
    }

    private byte cell(int column, int row) {
        return (byte)
                switch (map.at(column, row)) {
                    case OccupancyGrid.FREE -> -OCCUPIED;
                    case OccupancyGrid.OCCUPIED -> OCCUPIED;
                    default -> 0;
                };
    }

    private static byte[] packed(byte[] cells) {
        var bytes = new ByteArrayOutputStream();
        var deflater = new Deflater(Deflater.BEST_SPEED);
        try (var zip = new DeflaterOutputStream(bytes, deflater)) {
            zip.write(cells);
        } catch (java.io.IOException e) {
            throw new AssertionError("Memory can be written to.", e);
        } finally {
            deflater.end();
        }
        return bytes.toByteArray();
    }
}
