package rsal.bench.robots;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rsal.data.OccupancyGrid;
import rsal.scenario.installed.Providers;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.system.ExportedDevice;
import rsal.time.AllowedToReadWallClock;
import rsal.time.WallScheduler;

/// A process of its own that offers robots over a bridge, whose readings say when they were told, for others to see
/// how long they took. Its robots stand still, and tell ten times a second, one after the other.
///
/// It is called with the key of the bridge (`player`), the port where that begins, the kind of robots and their number,
/// and says on one line at which port each is. At the first line it is sent it stops telling, and says the number of
/// each robot's last readings. It ends
/// with the second line, or when nobody is left to send one.
@AllowedToReadWallClock("Benchmarks measure real time.")
final class Beacons {
    private static final Duration PERIOD = Duration.ofMillis(100);
    private static final long SECOND = 1_000_000_000; // [ns]

    private Beacons() {}

    /// Which part of a second it is, by a clock that all processes of a machine share.
    static double now() {
        return (double) (System.nanoTime() % SECOND) / (double) SECOND;
    }

    /// How long ago it was [#now], less than a second.
    ///
    /// @return [s]
    static double since(double then) {
        double passed = now() - then;
        return passed < 0 ? passed + 1 : passed;
    }

    public static void main(String[] arguments) throws IOException {
        int port = Integer.parseInt(arguments[1]);
        Beacon.Kind kind = Beacon.Kind.valueOf(arguments[2]);
        int count = Integer.parseInt(arguments[3]);
        try (var time = new WallScheduler("beacons", Runnable::run);
                var asked = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
                var out = new OutputStreamWriter(new FileOutputStream(FileDescriptor.out), StandardCharsets.UTF_8)) {
            List<Beacon> beacons = IntStream.range(0, count)
                    .mapToObj(i -> new Beacon("r" + i, kind))
                    .toList();
            say(
                    out,
                    open(arguments[0], port, beacons, time).offers().stream()
                            .map(ExportedDevice::port)
                            .distinct()
                            .toList());
            time.execute(() -> {
                for (int i = 0; i < count; i++) {
                    beacons.get(i).begin(PERIOD.multipliedBy(i).dividedBy(count), PERIOD, time);
                }
            });
            if (asked.readLine() != null) {
                time.execute(() -> say(out, beacons.stream().map(Beacon::end).toList()));
                asked.readLine();
            }
        }
    }

    private static void say(Writer out, List<Integer> numbers) {
        try {
            out.write(numbers.stream().map(String::valueOf).collect(Collectors.joining(" ", "", "\n")));
            out.flush();
        } catch (IOException e) {
            throw new UncheckedIOException("Who started these robots is gone.", e);
        }
    }

    private static Bridge open(String key, int port, List<Beacon> beacons, WallScheduler time) throws IOException {
        BridgeProvider provider = Objects.requireNonNull(
                Providers.byKey(BridgeProvider.class, BridgeProvider::key).get(key));
        var map = new OccupancyGrid(1, 1, 1, 0, 0, new byte[1]);
        var context = new BridgeContext(beacons.stream().map(Beacon::robot).toList(), map, Optional.empty(), List.of());
        return provider.open(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), context, time);
    }
}
