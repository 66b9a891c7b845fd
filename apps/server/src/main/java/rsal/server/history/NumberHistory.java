package rsal.server.history;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import rsal.engine.LiveRun;
import rsal.engine.report.Answer;
import rsal.server.description.PlottableNumbers;
import rsal.server.message.Messages.PastNumbers;
import rsal.server.message.Messages.PlottedNumbers;
import rsal.time.AllowedToReadWallClock;

/// What devices of a live run's robots have told so far, as [PlottableNumbers], so that plots begin with what
/// has been. Robots are asked twice a second of the run, or four times a second when that goes by faster; of
/// more than [#MOST_ROBOTS] those that somebody wanted to know about last. As [History] it reaches back to the
/// beginning: when it has more than [#MOST_NUMBERS], every second is let go, and half as many are kept from
/// then on. All methods may be called from any thread, [#look] from one at a time.
@AllowedToReadWallClock("A run that goes by fast is not asked all the time.")
public final class NumberHistory {
    static final int MOST_ROBOTS = 20;
    static final int MOST_NUMBERS = 1_500_000; // of 8 bytes

    private static final Duration FIRST_SPACING = Duration.ofMillis(500); // of the run
    private static final long LEAST_PAUSE = 250_000_000; // in real time [ns]
    private static final int OVERHEAD = 6; // of a sample, in numbers
    private static final int NAME = 10; // the same

    private final int most;
    private final Map<String, List<Sample>> samples = new HashMap<>();
    private final Map<List<Name>, List<Name>> lists = new HashMap<>(); // of names, each once
    private final SequencedSet<String> wanted = new LinkedHashSet<>();
    private final AtomicInteger asked = new AtomicInteger();
    private Optional<Asking> last = Optional.empty();
    private Duration spacing = FIRST_SPACING;
    private int kept;

    public NumberHistory() {
        this(MOST_NUMBERS);
    }

    /// @param most numbers that it keeps
    public NumberHistory(int most) {
        this.most = most;
    }

    private record Name(String device, String number) {}

    /// @param names the same list as of all samples that have the same
    private record Sample(double time, List<Name> names, double[] values) {}

    /// @param time of the run
    /// @param at in real time [ns]
    private record Asking(Duration time, long at) {}

    /// Somebody wants to know about a robot.
    public synchronized void want(String robot) {
        wanted.addFirst(robot); // also one that was among them
        if (wanted.size() > MOST_ROBOTS) {
            wanted.removeLast();
        }
    }

    /// How many different lists of names it keeps.
    synchronized int lists() {
        return lists.size();
    }

    /// Asks for what is new, when it is time for that and all has been answered. Answers come on other threads.
    ///
    /// @param robots that are there
    /// @param time since the run's start
    public void look(LiveRun run, List<String> robots, Duration time) {
        if (asked.get() > 0 || !isDue(time, System.nanoTime())) {
            return;
        }
        List<String> some = chosen(robots);
        asked.addAndGet(some.size());
        for (String robot : some) {
            var _ = run.inspector()
                    .readings(robot)
                    .whenCompleteAsync( // not on the run's thread, which has better to do than to look through records
                            (answer, _) -> {
                                asked.decrementAndGet();
                                if (answer instanceof Answer.Read reported) {
                                    keep(robot, PlottableNumbers.of(reported));
                                }
                            },
                            Thread::startVirtualThread);
        }
    }

    /// Whether it is time to ask; then that counts as asked.
    ///
    /// @param now in real time [ns]
    synchronized boolean isDue(Duration time, long now) {
        boolean early = last.filter(
                        before -> time.minus(before.time()).compareTo(spacing) < 0 || now - before.at() < LEAST_PAUSE)
                .isPresent();
        if (!early) {
            last = Optional.of(new Asking(time, now));
        }
        return !early;
    }

    /// Of many robots, those to ask.
    synchronized List<String> chosen(List<String> robots) {
        return robots.size() <= MOST_ROBOTS
                ? robots
                : Stream.concat(wanted.stream().filter(robots::contains), robots.stream())
                        .distinct()
                        .limit(MOST_ROBOTS)
                        .toList();
    }

    /// Keeps what a robot's devices tell, if it is newer.
    synchronized void keep(String robot, PlottedNumbers now) {
        List<Sample> all = samples.computeIfAbsent(robot, _ -> new ArrayList<>());
        if (!all.isEmpty() && now.time() <= all.getLast().time()) {
            return;
        }
        var names = new ArrayList<Name>();
        var values = new ArrayList<Double>();
        now.devices()
                .forEach(device -> device.numbers().forEach(number -> {
                    names.add(new Name(device.device(), number.name()));
                    values.add(number.value().orElse(Double.NaN));
                }));
        add(
                all,
                new Sample(
                        now.time(),
                        names,
                        values.stream().mapToDouble(value -> value).toArray()));
        while (kept > most && samples.values().stream().anyMatch(some -> some.size() > 1)) {
            thin();
        }
    }

    private void add(List<Sample> all, Sample sample) {
        List<Name> known = lists.get(sample.names());
        if (known == null) { // a number may be there in one sample, and not in the next
            known = List.copyOf(sample.names());
            lists.put(known, known);
            kept += NAME * known.size();
        }
        all.add(new Sample(sample.time(), known, sample.values()));
        kept += OVERHEAD + sample.values().length; // one of a robot that tells none takes room, too
    }

    private void thin() {
        spacing = spacing.multipliedBy(2);
        kept = 0;
        lists.clear();
        for (Map.Entry<String, List<Sample>> entry : samples.entrySet()) {
            List<Sample> before = entry.getValue();
            var some = new ArrayList<Sample>(before.size() / 2 + 1);
            for (int i = 0; i < before.size(); i += 2) {
                add(some, before.get(i));
            }
            entry.setValue(some);
        }
    }

    /// What a number of a device was; nothing when nobody knows.
    public synchronized PastNumbers past(String robot, String device, String number) {
        var name = new Name(device, number);
        var times = new ArrayList<Double>();
        var values = new ArrayList<Optional<Double>>();
        int at = -1;
        for (Sample sample : samples.getOrDefault(robot, List.of())) {
            List<Name> names = sample.names();
            if (at < 0 || at >= names.size() || !names.get(at).equals(name)) { // else where it was in the one before
                at = names.indexOf(name);
            }
            times.add(sample.time());
            double value = at < 0 ? Double.NaN : sample.values()[at];
            values.add(Double.isNaN(value) ? Optional.empty() : Optional.of(value));
        }
        return new PastNumbers(times, values);
    }
}
