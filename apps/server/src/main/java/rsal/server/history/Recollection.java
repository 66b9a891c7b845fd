package rsal.server.history;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedSet;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.agent.bdi.Mind;
import rsal.agent.platform.AgentPlatform;
import rsal.data.OccupancyGrid;
import rsal.data.Stamped;
import rsal.engine.LiveRun;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.MindChange;
import rsal.engine.report.Reading;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.Snapshot;
import rsal.server.frame.Moment;

/// What can be asked about a live run's past, beside the frames of its [History]: what devices had told, twice
/// a second of the run and where it was paused, as those that go on by steps look closely, and who heard whom;
/// and what agents showed and had in mind, once a second. Minds are those of [#MOST_MINDS] agents: of more, of
/// those that somebody asked about last. Within [#MOST_BYTES] it reaches back to the beginning, ever more
/// coarsely ([DownsampledSeries]). All methods may be called from any thread, [#look] from one at a time.
public final class Recollection {
    static final long MOST_BYTES = 32L << 20;
    static final int MOST_MINDS = 20;

    private static final long MOST_OF_MINDS = 8L << 20;
    private static final Duration SPACING = Duration.ofMillis(500); // of the run
    private static final Duration SPACING_OF_MINDS = Duration.ofSeconds(1);
    private static final Mind.View NOTHING = new Mind.View(Map.of(), List.of());

    private final DownsampledSeries<Moment> moments =
            new DownsampledSeries<>(MOST_BYTES - MOST_OF_MINDS, SPACING, Bytes::beyond);
    private final DownsampledSeries<Map<String, Mind.View>> minds =
            new DownsampledSeries<>(MOST_OF_MINDS, SPACING_OF_MINDS, Bytes::beyond);
    private final SequencedSet<String> wanted = new LinkedHashSet<>(); // agents
    private final AtomicBoolean asking = new AtomicBoolean();
    private @Nullable Snapshot seen;

    /// @param robots what their devices had told last, by robot; of maps a [PackedMap]
    /// @param agents what they showed, by name
    /// @param links which robots' agents heard each other
    private record Moment(
            Map<String, List<Reading>> robots, Map<String, AgentPlatform.View> agents, Answer.Linked links) {
        static final Moment NONE = new Moment(Map.of(), Map.of(), Answer.Linked.NONE);
    }

    /// Keeps what is new, when it is time for that. What agents have in mind it asks for, which is answered later, on
    /// another thread.
    ///
    /// @param now the newest of the run
    public void look(LiveRun run, Snapshot now) {
        if (keep(now) && asking.compareAndSet(false, true)) {
            var _ = run.inspector()
                    .minds(chosen(now))
                    .whenCompleteAsync( // not on the run's thread, which has better to do than to count
                            (answer, _) -> {
                                if (answer instanceof Answer.Minded(Duration time, var reported)) {
                                    keepMinds(time, reported);
                                }
                                asking.set(false);
                            },
                            Thread::startVirtualThread);
        }
    }

    /// @return whether agents are to be asked
    private synchronized boolean keep(Snapshot now) {
        if (seen != null && seen.sequence() == now.sequence()) {
            return false;
        }
        seen = now;
        boolean last = now.outcome().isPresent();
        if (last || now.paused() || moments.isDue(now.time()) || moments.endsAt(now.time())) {
            moments.keep(now.time(), moment(now));
        }
        return !last && minds.isDue(now.time());
    }

    /// What is as it was before is the same object.
    private Moment moment(Snapshot now) {
        Moment before =
                moments.at(now.time()).map(DownsampledSeries.Entry::value).orElse(Moment.NONE);
        var robots = new HashMap<String, List<Reading>>();
        for (RobotView robot : now.robots()) {
            List<Reading> known = before.robots.getOrDefault(robot.id(), List.of());
            robots.put(
                    robot.id(),
                    robot.readings().stream()
                            .map(reading -> packed(reading, known))
                            .toList());
        }
        var agents = new HashMap<String, AgentPlatform.View>();
        for (AgentView agent : now.agents()) {
            AgentPlatform.View known = before.agents.get(agent.view().agent().name());
            agents.put(agent.view().agent().name(), agent.view().equals(known) ? known : agent.view());
        }
        return new Moment(robots, agents, now.links());
    }

    private static Reading packed(Reading reading, List<Reading> before) {
        Stamped<?> reported = reading.value();
        if (!(reported.value() instanceof OccupancyGrid map)) {
            return reading;
        }
        Stamped<?> kept = before.stream()
                .filter(other -> other.device().equals(reading.device()))
                .<Stamped<?>>map(Reading::value)
                .filter(other -> other.time().equals(reported.time()) && other.value() instanceof PackedMap)
                .findFirst()
                .orElseGet(() -> new Stamped<>(reported.time(), reported.frame(), PackedMap.of(map)));
        return new Reading(reading.device(), kept, reading.age());
    }

    private synchronized void keepMinds(Duration time, Map<String, Mind.View> reported) {
        if (!minds.isDue(time)) {
            return;
        }
        Map<String, Mind.View> before =
                minds.at(time).map(DownsampledSeries.Entry::value).orElse(Map.of());
        var all = new HashMap<String, Mind.View>();
        reported.forEach((name, mind) -> {
            Mind.View known = before.get(name);
            all.put(name, mind.equals(known) ? known : mind);
        });
        minds.keep(time, all);
    }

    private synchronized List<String> chosen(Snapshot now) {
        List<String> all =
                now.agents().stream().map(agent -> agent.view().agent().name()).toList();
        return all.size() <= MOST_MINDS
                ? all
                : Stream.concat(wanted.stream().filter(all::contains), all.stream())
                        .distinct()
                        .limit(MOST_MINDS)
                        .toList();
    }

    /// Somebody wants to know what an agent has in mind.
    public synchronized void want(String agent) {
        wanted.addFirst(agent); // also one that was among them
        if (wanted.size() > MOST_MINDS) {
            wanted.removeLast();
        }
    }

    /// What devices of a robot had told last; nothing of one that was not there. Of what they have told since the
    /// moment that is kept, nothing: it is so much older.
    public Answer.Read readings(String robot, Duration time) {
        DownsampledSeries.Entry<Moment> then;
        Duration asked;
        synchronized (this) {
            then = moments.at(time).orElseGet(() -> new DownsampledSeries.Entry<>(Duration.ZERO, Moment.NONE));
            asked = seen == null || seen.time().compareTo(time) > 0 ? time : seen.time();
        }
        Duration since = asked.minus(then.time());
        Duration passed = since.isNegative() ? Duration.ZERO : since;
        var readings = new ArrayList<Reading>();
        for (Reading reading : then.value().robots.getOrDefault(robot, List.of())) {
            readings.add(new Reading(
                    reading.device(), unpacked(reading.value()), reading.age().plus(passed)));
        }
        return new Answer.Read(then.time(), readings);
    }

    /// The map that a robot had drawn by then.
    ///
    /// @param device that drew it; empty for the first that drew one
    public Optional<OccupancyGrid> map(String robot, String device, Duration time) {
        return readings(robot, time).readings().stream()
                .filter(reading -> device.isEmpty() || device.equals(reading.device()))
                .map(reading -> reading.value().value())
                .filter(OccupancyGrid.class::isInstance)
                .map(OccupancyGrid.class::cast)
                .findFirst();
    }

    private static Stamped<?> unpacked(Stamped<?> reported) {
        return reported.value() instanceof PackedMap packed
                ? new Stamped<>(reported.time(), reported.frame(), packed.map())
                : reported;
    }

    /// Which robots' agents heard each other; of very many robots none.
    public synchronized Answer.Linked links(Duration time) {
        return moments.at(time).map(then -> then.value().links).orElse(Answer.Linked.NONE);
    }

    /// What an agent did, believed and wanted then.
    ///
    /// @param now how it is now
    /// @param events of the run, oldest first
    public AgentInspection inside(AgentInspection now, Duration time, List<RunEvent> events) {
        String name = now.name();
        var past = new AgentPast(name, time, events);
        Optional<AgentPlatform.View> shown;
        Optional<Mind.View> mind;
        var changes = new ArrayList<MindChange>();
        synchronized (this) {
            shown = moments.at(time).flatMap(then -> shown(then.value(), name));
            mind = minds.at(time)
                    .flatMap(then -> Optional.ofNullable(then.value().get(name)));
            List<DownsampledSeries.Entry<Mind.View>> views =
                    minds.until(time, then -> Optional.ofNullable(then.get(name)));
            if (views.isEmpty()) { // it has none
                views = moments.until(
                        time, then -> shown(then, name).map(view -> new Mind.View(view.beliefs(), List.of())));
            }
            Mind.View before = NOTHING;
            for (DownsampledSeries.Entry<Mind.View> view : views) {
                changes.addAll(MindChange.between(before, view.value(), view.time()));
                before = view.value();
            }
        }
        return new AgentInspection(
                name,
                now.planned(),
                shown,
                mind,
                now.program(),
                past.history(changes),
                Optional.of(past.mail()),
                past.talks(),
                List.of());
    }

    private static Optional<AgentPlatform.View> shown(Moment then, String agent) {
        return Optional.ofNullable(then.agents.get(agent));
    }

    /// What it takes, about.
    public synchronized long bytes() {
        return moments.bytes() + minds.bytes();
    }
}
