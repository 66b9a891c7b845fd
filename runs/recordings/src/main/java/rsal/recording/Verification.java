package rsal.recording;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import rsal.agent.bdi.Mind;
import rsal.engine.LiveRun;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunObserver;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.recording.Recording.Hashed;
import rsal.scenario.RunPlan;
import rsal.settings.InvalidSettings;

/// Runs a recorded run again and compares: event by event, and between them hash by hash, which are over all that
/// happened, poses and messages too.
public final class Verification {
    private static final Duration PERIOD = Duration.ofMillis(100);

    private final List<Hashed> recorded;
    private final Map<Duration, String> hashes;
    private final boolean isWhole;
    private final Duration last;
    private final Function<Snapshot, List<String>> differences;
    private final CompletableFuture<Finding> finding = new CompletableFuture<>();

    // of the run's thread
    private int next;
    private Compared equal = Compared.NOTHING;
    private int messages; // so far
    private Optional<RunEvent> unequal = Optional.empty(); // the first that is the same after what is not
    private Duration equalUntil = Duration.ZERO;

    /// What is the same, as far as all is.
    ///
    /// @param events that are, word by word
    /// @param messages that are by the hash over all that happened
    /// @param states of all robots and agents that are by that hash
    public record Compared(int events, int messages, int states) {
        public static final Compared NOTHING = new Compared(0, 0, 0);
    }

    /// The result.
    public sealed interface Finding {
        /// All is the same.
        ///
        /// @param until compared, since the run's start
        /// @param isWhole whether the recording is of the whole run
        record Same(Compared compared, Duration until, boolean isWhole) implements Finding {}

        /// A person took part: up to then all is the same.
        ///
        /// @param event what they did
        record Steered(RunEvent event, Compared compared) implements Finding {}

        /// @param equalUntil up to when all is known to be the same
        /// @param recorded empty when nothing was
        /// @param now empty when nothing happened
        /// @param differences of robots and agents at that time, in words, a line each; empty where not known
        record Different(
                Duration time,
                Duration equalUntil,
                Optional<RunEvent> recorded,
                Optional<RunEvent> now,
                Compared compared,
                List<String> differences)
                implements Finding {}
    }

    /// @param hashes of looks, by their time
    /// @param last time that was recorded
    /// @param differences of what is now from what was recorded of that time
    Verification(
            List<Hashed> recorded,
            Map<Duration, String> hashes,
            boolean isWhole,
            Duration last,
            Function<Snapshot, List<String>> differences) {
        this.recorded = recorded;
        this.hashes = hashes;
        this.isWhole = isWhole;
        this.last = last;
        this.differences = differences;
    }

    private static Verification of(Recording recording) throws IOException {
        return new Verification(
                recording.events(),
                recording.hashes(),
                recording.result().containsKey("outcome"),
                Duration.ofNanos(recording.file().end().orElse(0)),
                now -> differences(recording, now));
    }

    /// Runs it again, as fast as it can.
    ///
    /// @return completes when it is known, maybe on the run's thread; exceptionally when the run breaks
    /// @param plan of the recording ([Recording#plan])
    /// @throws IllegalArgumentException when it was in real time, or has agents whose programs are not run
    public static CompletionStage<Finding> begin(Recording recording, RunPlan plan) throws IOException {
        if (!recording.isRepeatable()) {
            throw new IllegalArgumentException("A run in real time can't be run again.");
        }
        if (!plan.untrusted().isEmpty()) {
            throw new IllegalArgumentException("Programs %s are not run.".formatted(plan.untrusted()));
        }
        Verification verification = of(recording);
        LiveRun run = LiveRun.of(plan).observer(verification.new Comparison()).start();
        run.result().whenComplete((_, broken) -> {
            if (broken != null) {
                verification.finding.completeExceptionally(broken);
            } else {
                verification.ended();
            }
        });
        return verification.finding.whenComplete((_, _) -> run.stop());
    }

    CompletionStage<Finding> finding() {
        return finding;
    }

    /// With what happens next, in words: of messages, to whom and what about is in those. For the run's thread.
    void compare(RunEvent happened, String hash) {
        var event = new RunEvent(
                happened.sequence(), happened.time(), happened.kind(), happened.subject(), happened.text());
        if (finding.isDone() || isBeyond(event.time())) {
            return;
        }
        if (next >= recorded.size()) {
            conclude(different(event.time(), Optional.empty(), Optional.of(event), List.of()));
            return;
        }
        Hashed before = recorded.get(next);
        if (before.event().equals(event) && before.hash().equals(hash)) {
            next++;
            if (unequal.isEmpty()) {
                equal = new Compared(equal.events() + 1, messages, equal.states());
                equalUntil = event.time();
            }
        } else if (before.event().equals(event)) {
            next++; // what lies before it is not the same: the next look at all robots tells what
            unequal = unequal.or(() -> Optional.of(event));
        } else if (isByHand(before.event())) {
            conclude(new Finding.Steered(before.event(), equal));
        } else {
            conclude(different(event.time(), Optional.of(before.event()), Optional.of(event), List.of()));
        }
    }

    private void compare(Snapshot now, String hash) {
        Duration time = now.time();
        if (finding.isDone() || isBeyond(time)) {
            return;
        }
        boolean isLate =
                next < recorded.size() && recorded.get(next).event().time().compareTo(time) < 0;
        String before = hashes.get(time);
        if (isLate || (before != null && !before.equals(hash)) || unequal.isPresent()) {
            Optional<RunEvent> missing = isLate ? Optional.of(recorded.get(next).event()) : Optional.empty();
            if (missing.filter(Verification::isByHand).isPresent()) {
                conclude(new Finding.Steered(missing.get(), equal));
            } else {
                finding.complete(different(time, missing, Optional.empty(), differences.apply(now)));
            }
        } else {
            int states = before == null ? equal.states() : equal.states() + 1;
            equal = new Compared(equal.events(), messages, states);
            equalUntil = time;
        }
    }

    /// Whether there is nothing to compare it with: the recording was cut off.
    private boolean isBeyond(Duration time) {
        boolean beyond = !isWhole && time.compareTo(last) >= 0;
        if (beyond) {
            conclude(new Finding.Same(equal, equalUntil, false));
        }
        return beyond;
    }

    /// No more happens.
    void ended() {
        if (next < recorded.size()) {
            RunEvent missing = recorded.get(next).event();
            conclude(
                    isByHand(missing)
                            ? new Finding.Steered(missing, equal)
                            : different(missing.time(), Optional.of(missing), Optional.empty(), List.of()));
        }
        conclude(new Finding.Same(equal, equalUntil, isWhole)); // unless something else was found
    }

    /// With what was found, unless something was not the same before.
    private void conclude(Finding found) {
        finding.complete(
                unequal.map(event -> different(event.time(), Optional.of(event), Optional.of(event), List.of()))
                        .orElse(found));
    }

    private Finding different(
            Duration time, Optional<RunEvent> before, Optional<RunEvent> now, List<String> differences) {
        return new Finding.Different(time, equalUntil, before, now, equal, differences);
    }

    /// From what was recorded of the same time.
    private static List<String> differences(Recording recording, Snapshot now) {
        try {
            var before = Playback.of(recording); // the owner of the recording closes that
            if (before.until().compareTo(now.time()) < 0) {
                return List.of();
            }
            Snapshot then = before.at(now.time());
            return then.time().equals(now.time()) ? Differences.between(then, now) : List.of(); // it may be missing
        } catch (IOException | InvalidSettings e) {
            return List.of("What was recorded then can't be read: " + e.getMessage());
        }
    }

    private static boolean isByHand(RunEvent event) {
        return event.kind().equals("operator")
                || event.kind().equals("hand")
                || (event.kind().equals("run") && event.text().equals("ends: stopped"));
    }

    private final class Comparison implements RunObserver {
        @Override
        public Duration period() {
            return PERIOD;
        }

        @Override
        public void sees(Snapshot now, String hash) {
            compare(now, hash);
        }

        @Override
        public void looksInto(Duration time, Map<String, Mind.View> minds) {} // made of what is compared

        @Override
        public void happened(RunEvent event, String hash) {
            compare(event, hash);
        }

        @Override
        public void heard(SentMessage message, Object content) {
            messages++; // in the hash
        }
    }
}
