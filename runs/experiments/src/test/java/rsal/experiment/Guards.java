package rsal.experiment;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import rsal.scenario.Scenario;

/// A small scenario to try experiments with: robots that wander for some seconds.
final class Guards {
    static final String TEXT = """
            rsal: 1
            scenario: guards
            title: Robots wander
            arguments:
              guards: {type: integer, default: 1, min: 1, max: 4, description: How many robots wander.}
              places: {type: string, default: anywhere, enum: [anywhere, nowhere], description: Where they begin.}
            world: {map: office}
            robots:
              guard: {count: $guards, model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, pilot: {}}}
            agents:
              wander: {type: wander, robot: guard}
            run:
              stop:
                - {when: time > 3, outcome: success}
            metrics:
              - {name: guards, unit: m, from: distance}
              - {name: way, unit: m, from: distance, per: robot, better: more}
              - {name: firstCollision, unit: s, from: firstTime(collisions > 0)}
            configurations:
              long: {title: Three seconds}
              short: {run: {stop: [{when: time > 1, outcome: timeout}]}}
              real: {run: {clock: {mode: wall}}}
              endless: {run: {stop: []}}
            """;

    private Guards() {}

    static Scenario in(Path folder) {
        return in(folder, TEXT);
    }

    static Scenario in(Path folder, String text) {
        try {
            Path file = folder.resolve("guards.yaml");
            Files.writeString(file, text);
            return Scenario.load(file.toString());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// One or two robots, for three seconds and for one.
    static Design design(int seeds) {
        return new Design(
                List.of("long", "short"),
                List.of(new Factor("guards", List.of("1", "2"))),
                Map.of(),
                LongStream.rangeClosed(1, seeds).boxed().toList(),
                Optional.empty());
    }

    static Design with(List<String> configurations, Optional<Duration> limit) {
        return new Design(configurations, List.of(), Map.of(), List.of(1L), limit);
    }

    static Manifest.Session session(String... command) {
        return new Manifest.Session(
                "2026-01-02T03:04:05Z", "guards.yaml", List.of(command), 2, Manifest.Machine.here("0"));
    }
}
