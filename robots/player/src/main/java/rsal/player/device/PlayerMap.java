package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.Mapper;
import rsal.player.message.MapInterface;
import rsal.player.wire.Address;
import rsal.time.Scheduler;

/// A map that a robot has by itself, behind `map`: the server's whole one, read again with each connection and whenever
/// the server tells that it is another. Nobody draws it, so that it has no ends and drives nothing.
final class PlayerMap extends PlayerSensor<OccupancyGrid> implements Mapper {
    private static final Duration AGAIN = Duration.ofSeconds(5); // when it could not be read
    private static final Duration PAUSE = Duration.ofSeconds(1); // however often the server tells of another

    private final RemoteServer server;
    private final Scheduler scheduler;
    private final Duration again;
    private @Nullable Object reading; // under way
    private Instant begun = Instant.MIN; // the newest one
    private Instant due = Instant.MAX;

    PlayerMap(DeviceInfo info, Address address, RemoteServer server, Scheduler scheduler) {
        this(info, address, server, scheduler, AGAIN);
    }

    /// @param again when it is asked for again that could not be read
    PlayerMap(DeviceInfo info, Address address, RemoteServer server, Scheduler scheduler, Duration again) {
        super(info, address, "map");
        this.server = server;
        this.scheduler = scheduler;
        this.again = again;
    }

    @Override
    boolean isSteady() {
        return false;
    }

    @Override
    public void connected() {
        super.connected();
        begin();
    }

    private void begin() {
        var own = new Object();
        reading = own;
        begun = scheduler.instant();
        due = Instant.MAX;
        MapReader.read(server, address(), scheduler).whenComplete((map, error) -> {
            if (!own.equals(reading)) {
                return; // that was over another connection
            }
            reading = null;
            if (error == null) {
                publish(begun, map);
            } else {
                health(new Health.Lost("Its map can't be read: " + RemoteServer.words(error)));
                due = scheduler.instant().plus(again);
            }
        });
    }

    /// None: it is asked for.
    @Override
    Optional<OccupancyGrid> read(Record body) {
        return Optional.empty();
    }

    @Override
    public void take(Instant time, Record body) {
        if (body instanceof MapInterface.Extent) {
            due = begun.plus(PAUSE);
        }
    }

    @Override
    public void look(Instant now) {
        if (reading == null && !due.isAfter(now)) {
            begin();
        }
    }

    @Override
    public void lost(String reason) {
        reading = null;
        due = Instant.MAX;
        super.lost(reason);
    }

    @Override
    public boolean isComplete() {
        return true;
    }

    @Override
    public List<End> ends() {
        return List.of();
    }

    @Override
    public void leaveAlone(End end) {}

    @Override
    public void pause() {}

    @Override
    public void resume() {}

    /// The driving is always left to others.
    @Override
    public boolean paused() {
        return true;
    }
}
