package rsal.ros2.health;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.device.Health;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.PeerText;
import rsal.ros2.link.RosNetwork;

/// What the diagnostics of a robot report of its devices: errors, and what is stale. Warnings harm no device. A report
/// that is not repeated for 5 s does not count any more.
///
/// Names of reports are free (`hokuyo: Hokuyo Status`), so they are compared by their words. A report concerns the
/// device all of whose name's words it has; of several the one with the most words. Where it names none,
/// it concerns the device that is the only one of which it has a usual word, such as `lidar`. All others concern no
/// device.
public final class RobotReports {
    private static final Duration VALID = Duration.ofSeconds(5); // programs publish once a second
    private static final int ERROR = 2; // diagnostic_msgs/DiagnosticStatus
    private static final int STALE = 3;
    private static final int MOST_REPORTS = 1_000; // of what is bad

    private final String namespace;
    private final InstantSource clock;
    private final List<Named> devices = new ArrayList<>();
    private final Map<String, Report> bad = new LinkedHashMap<>(); // by their names
    private final List<Runnable> ends = new ArrayList<>();

    /// @param words of its name
    /// @param usual words by which others call devices of its kind
    private record Named(String name, Set<String> words, Set<String> usual) {}

    /// @param device that it concerns
    private record Report(String device, Health health, Instant heard) {}

    /// @param namespace of the robot; empty for none
    RobotReports(String namespace, InstantSource clock) {
        this.namespace = namespace;
        this.clock = clock;
    }

    /// @param usual words, in small letters, by which others call devices of its kind
    void add(String device, Set<String> usual) {
        devices.add(new Named(device, words(device), usual));
    }

    private static Set<String> words(String text) {
        return Stream.of(text.toLowerCase(Locale.ROOT).split("[^a-z0-9]+", -1))
                .filter(word -> !word.isEmpty())
                .collect(Collectors.toSet());
    }

    /// @param status `diagnostic_msgs/DiagnosticStatus` of this robot
    void take(RosMessage status) {
        String name = status.text("name");
        long level = status.integer("level");
        bad.remove(name);
        if ((level == ERROR || level == STALE) && bad.size() < MOST_REPORTS) {
            concerned(without(name, status.text("hardware_id"))).ifPresent(device -> {
                String reason =
                        "'%s' reports: %s".formatted(PeerText.shown(name), PeerText.shown(status.text("message")));
                Health health = level == ERROR ? new Health.Lost(reason) : new Health.Stale(reason);
                bad.put(name, new Report(device, health, clock.instant()));
            });
        }
    }

    /// What is left of a name behind the robot's, whose words say nothing of a device.
    private String without(String name, String hardware) {
        if (!namespace.isEmpty() && name.startsWith(namespace + "/")) {
            return name.substring(namespace.length());
        }
        boolean isRobot = !hardware.isEmpty() && RosNetwork.namespace(hardware).equals(namespace);
        return isRobot && name.startsWith(hardware) ? name.substring(hardware.length()) : name;
    }

    private Optional<String> concerned(String report) {
        Set<String> words = words(report);
        return devices.stream()
                .filter(device -> words.containsAll(device.words))
                .max(Comparator.comparingInt(device -> device.words.size()))
                .or(() -> {
                    List<Named> meant = devices.stream()
                            .filter(device -> device.usual.stream().anyMatch(words::contains))
                            .toList();
                    return meant.size() == 1 ? Optional.of(meant.getFirst()) : Optional.empty();
                })
                .map(Named::name);
    }

    /// How a device is reported to be; empty where nothing bad is.
    Optional<Health> health(String device, Instant now) {
        bad.values().removeIf(report -> report.heard.plus(VALID).isBefore(now));
        return bad.values().stream()
                .filter(report -> report.device.equals(device))
                .map(Report::health)
                .min(Comparator.comparing(health -> health instanceof Health.Stale)); // lost ones first
    }

    void onClose(Runnable end) {
        ends.add(end);
    }

    void close() {
        ends.forEach(Runnable::run);
    }
}
