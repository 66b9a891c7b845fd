package rsal.server.frame;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import rsal.server.message.Json;
import rsal.server.message.Messages.AgentDetails;
import rsal.server.message.Messages.Details;
import rsal.server.message.Messages.RobotDetails;
import rsal.server.message.Messages.ServerMessage;

/// The details of a run as they change, so that viewers are told only of robots and agents that are others than they
/// know: of a thousand, few change at a time. For one thread.
public final class DetailChanges {
    private final Map<String, Long> robots = new HashMap<>(); // in which version each became what it is
    private final Map<String, Long> agents = new HashMap<>();
    private final Map<Long, String> texts = new HashMap<>(); // of this version, by what is known
    private @Nullable Details now;
    private long version;
    private long oldest; // version that a viewer must have to be told changes: somebody left, or changed places, in it

    /// @param newest of them all
    /// @return whether anything is another
    public boolean take(Details newest) {
        Details before = now;
        if (newest.equals(before)) {
            return false;
        }
        version++;
        now = newest;
        texts.clear();
        note(robots, before == null ? List.of() : before.robots(), newest.robots(), RobotDetails::id);
        note(agents, before == null ? List.of() : before.agents(), newest.agents(), AgentDetails::name);
        return true;
    }

    private <T> void note(Map<String, Long> versions, List<T> before, List<T> newest, Function<T, String> name) {
        var gone = HashMap.<String, T>newHashMap(before.size());
        before.forEach(each -> gone.put(name.apply(each), each));
        for (T each : newest) {
            if (!each.equals(gone.remove(name.apply(each)))) {
                versions.put(name.apply(each), version);
            }
        }
        versions.keySet().removeAll(gone.keySet());
        boolean goesOn = before.size() <= newest.size()
                && IntStream.range(0, before.size())
                        .allMatch(i -> name.apply(before.get(i)).equals(name.apply(newest.get(i))));
        if (!goesOn) { // who is told only what has changed would not know the order
            oldest = version;
        }
    }

    /// Of what was taken last, from 1; 0 before.
    public long version() {
        return version;
    }

    /// [Details] as JSON.
    ///
    /// @param known version that the viewer has; 0 for none
    public String since(long known) {
        return Optional.ofNullable(now)
                .map(details -> texts.computeIfAbsent(
                        known,
                        _ -> Json.write(
                                ServerMessage.of(known < Math.max(oldest, 1) ? details : part(details, known)))))
                .orElse("");
    }

    private Details part(Details all, long known) {
        return new Details(
                all.run(),
                false,
                all.ending(),
                all.robots().stream()
                        .filter(robot -> robots.getOrDefault(robot.id(), 0L) > known)
                        .toList(),
                all.agents().stream()
                        .filter(agent -> agents.getOrDefault(agent.name(), 0L) > known)
                        .toList());
    }
}
