package rsal.cli.terminal;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.engine.report.RunEvent;

/// Which changes of health people read. Two of a device are told at once. When it changes again and again, its newest
/// state comes after ten seconds, with the number of changes that were not told: a sensor that is late now and then
/// must not hide all other lines.
final class HealthLines {
    static final Duration PERIOD = Duration.ofSeconds(10); // of the run
    static final int MOST = 2; // lines of a device in that time

    private final Map<String, Changes> byDevice = new LinkedHashMap<>();

    private static final class Changes {
        private Duration from;
        private int shown;
        private int held;
        private @Nullable RunEvent newest; // of those that are held

        Changes(Duration from) {
            this.from = from;
        }

        boolean isOver(Duration now) {
            return now.compareTo(from.plus(PERIOD)) >= 0;
        }

        /// Takes the newest of those that are held, which begins the next ten seconds.
        Optional<RunEvent> take(Duration now) {
            return Optional.ofNullable(newest).map(event -> {
                String often = held == 1 ? "once more" : held + " times";
                String words = String.format(
                        Locale.ROOT,
                        "%s. Its health has changed %s since %.1f s",
                        event.text().endsWith(".")
                                ? event.text().substring(0, event.text().length() - 1)
                                : event.text(),
                        often,
                        from.toNanos() / 1e9);
                from = now;
                shown = 1;
                held = 0;
                newest = null;
                return new RunEvent(event.sequence(), event.time(), event.kind(), event.subject(), words);
            });
        }
    }

    /// Whether a change of health is told now; it is held otherwise.
    boolean tells(RunEvent event) {
        Changes its = byDevice.computeIfAbsent(event.subject(), _ -> new Changes(event.time()));
        if (its.newest == null && its.isOver(event.time())) {
            its.from = event.time();
            its.shown = 0;
        }
        if (its.shown < MOST && its.newest == null) {
            its.shown++;
            return true;
        }
        its.held++;
        its.newest = event;
        return false;
    }

    /// The newest states that were held for long enough.
    List<RunEvent> due(Duration now) {
        return byDevice.values().stream()
                .filter(its -> its.isOver(now))
                .flatMap(its -> its.take(now).stream())
                .toList();
    }

    /// All that are still held, as nothing more comes.
    List<RunEvent> rest() {
        return byDevice.values().stream()
                .flatMap(its -> its.take(Duration.ZERO).stream())
                .toList();
    }
}
