package rsal.ros2.health;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.time.Scheduler;

/// In which state a node with a lifecycle is, as those of Nav2 are. Its service `get_state` says so, which is called
/// when the node appears, when it publishes a `transition_event`, and every two seconds. The state of a node that
/// nobody runs, or that does not answer, is not known.
final class LifecycleNode {
    private static final Duration AGAIN = Duration.ofSeconds(2);
    private static final Duration ANSWER = Duration.ofSeconds(5); // a call without one is lost
    private static final int ACTIVE = 3; // lifecycle_msgs/State
    private static final Map<Integer, String> OTHERS = Map.of(
            1, "unconfigured",
            2, "inactive",
            4, "finalized",
            10, "being configured",
            11, "being cleaned up",
            12, "shutting down",
            13, "being activated",
            14, "being deactivated",
            15, "handling an error");
    private static final byte[] REQUEST = new CdrWriter().int8((byte) 0).toBytes(); // it has no fields

    private final String name;
    private final RosLink link;
    private final Scheduler scheduler;
    private final Subscribed events;
    private @Nullable ServiceClient client; // while the node is there
    private Instant asked = Instant.MIN;
    private boolean waits; // for an answer
    private boolean isDue; // as something has changed
    private long calls; // so far
    private int state; // 0 as long as it is not known

    /// @param name with its namespace: `/r1/bt_navigator`
    LifecycleNode(String name, RosLink link, Scheduler scheduler) {
        this.name = name;
        this.link = link;
        this.scheduler = scheduler;
        events = link.subscribe(
                new RosTopic(name + "/transition_event", "lifecycle_msgs/msg/TransitionEvent"),
                Profile.SENSOR_DATA,
                new Inbox<>(1, _ -> true, scheduler, _ -> isDue = true)); // what it says differs between distributions
    }

    boolean isActive() {
        return state == ACTIVE;
    }

    /// What it is instead of active, for people; empty when it is active, or its state is not known.
    Optional<String> trouble() {
        return Optional.ofNullable(OTHERS.get(state)).map(words -> "'%s' is %s.".formatted(name, words));
    }

    void look(Instant now) {
        if (events.publishers() == 0) {
            forget();
            return;
        }
        if (client == null) {
            client = link.client(name + "/get_state", "lifecycle_msgs/srv/GetState");
            isDue = true;
        }
        if (waits && asked.plus(ANSWER).isBefore(now)) {
            waits = false;
            state = 0;
        }
        if (!waits && (isDue || !asked.plus(AGAIN).isAfter(now)) && client.isAvailable()) {
            ask(client, now);
        }
    }

    private void ask(ServiceClient server, Instant now) {
        asked = now;
        waits = true;
        isDue = false;
        long call = ++calls;
        var _ = server.call(REQUEST)
                .whenCompleteAsync(
                        (response, error) -> {
                            if (call == calls && waits) {
                                waits = false;
                                state = error == null ? state(response) : 0;
                            }
                        },
                        scheduler);
    }

    /// @param response `GetState_Response`, which begins with the number of the state
    private static int state(byte[] response) {
        try {
            return CdrReader.of(response).int8();
        } catch (InvalidCdr e) {
            return 0;
        }
    }

    private void forget() {
        state = 0;
        waits = false;
        calls++; // what was asked does not count any more
        if (client != null) {
            client.close();
            client = null;
        }
    }

    void close() {
        forget();
        events.close();
    }
}
