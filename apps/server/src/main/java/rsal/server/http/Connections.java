package rsal.server.http;

import com.sun.management.UnixOperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.eclipse.jetty.io.Connection;
import org.eclipse.jetty.io.EndPoint;
import org.eclipse.jetty.server.AbstractMetaDataConnection;

/// Keeps room for the next connection, which may want to stop robots.
///
/// Connections are bounded, and a new one always enters. Where there are too many, the oldest of the least important
/// ones is closed. Connections that never showed the token go first: those that ask over HTTP, then viewers. Those
/// that showed the token go last.
///
/// A server has a thread for each connection that asks over HTTP, so that none waits for the thread of another.
///
/// Safe for several threads.
final class Connections implements Connection.Listener {
    /// That ask over HTTP; browsers open six each.
    static final int MOST_ASKING = 96;

    private static final int MOST = 512; // with viewers
    private static final int FEWEST = 8;
    private static final int RESERVE = 16; // file descriptors for all else that the process does

    private final int mostAsking;
    private final int most;
    private final Map<EndPoint, Kind> all = new LinkedHashMap<>(); // the oldest first

    /// Which of two matters less is the lower one.
    ///
    /// @param trusted whether it showed the token
    /// @param viewer whether it is a WebSocket
    private record Kind(boolean trusted, boolean viewer) implements Comparable<Kind> {
        @Override
        public int compareTo(Kind other) {
            return Comparator.comparing(Kind::trusted)
                    .thenComparing(Kind::viewer)
                    .compare(this, other);
        }
    }

    /// As many as file descriptors are left for.
    Connections() {
        this(Math.clamp(freeDescriptors() - RESERVE, FEWEST, MOST));
    }

    /// @param most at a time
    Connections(int most) {
        this.most = most;
        this.mostAsking = Math.min(MOST_ASKING, most - FEWEST / 2);
    }

    private static long freeDescriptors() {
        return ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean unix
                ? unix.getMaxFileDescriptorCount() - unix.getOpenFileDescriptorCount()
                : MOST + RESERVE;
    }

    /// Somebody showed the token there.
    synchronized void trust(EndPoint connection) {
        all.computeIfPresent(connection, (_, kind) -> new Kind(true, kind.viewer));
    }

    @Override
    public void onOpened(Connection connection) {
        boolean viewer = !(connection instanceof AbstractMetaDataConnection);
        add(connection.getEndPoint(), viewer).ifPresent(EndPoint::close);
    }

    /// @return which one has to go for it
    private synchronized Optional<EndPoint> add(EndPoint newest, boolean viewer) {
        boolean trusted = all.getOrDefault(newest, new Kind(false, viewer)).trusted;
        all.put(newest, new Kind(trusted, viewer));
        long asking = all.values().stream().filter(kind -> !kind.viewer).count();
        Optional<EndPoint> surplus = asking > mostAsking
                ? least(newest, kind -> !kind.viewer)
                : all.size() > most ? least(newest, _ -> true) : Optional.empty();
        surplus.ifPresent(all::remove);
        return surplus;
    }

    /// The oldest of those that matter least, but for the newest.
    private Optional<EndPoint> least(EndPoint newest, Predicate<Kind> among) {
        return all.entrySet().stream()
                .filter(entry -> !entry.getKey().equals(newest) && among.test(entry.getValue()))
                .min(Map.Entry.comparingByValue())
                .map(Map.Entry::getKey);
    }

    /// What is upgraded to a WebSocket is closed and opened again with the same end.
    @Override
    public void onClosed(Connection connection) {
        if (!connection.getEndPoint().isOpen()) {
            forget(connection.getEndPoint());
        }
    }

    private synchronized void forget(EndPoint connection) {
        all.remove(connection);
    }
}
