package rsal.agent.presence;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import rsal.agent.AgentContext;
import rsal.agent.message.Hello;
import rsal.agent.message.Hello.Kind;
import rsal.agent.message.PoseReport;
import rsal.robot.Robot;

/// Keeps track of who is there by what is heard of them: greetings and poses. Asks those of whom nothing was heard for
/// a while, and tells when one falls silent and when it is back. What the [rsal.agent.Directory] knows is not used:
/// an agent that runs, but can't be heard, is silent.
public final class FailureDetector {
    /// How many rounds pass between two questions to all, for those whose greeting was lost.
    private static final int ROUNDS_PER_CALL = 10;

    private final AgentContext self;
    private final Duration round;
    private final Duration timeout;
    private final Consumer<? super Change> listener;
    private final SortedMap<String, Known> known = new TreeMap<>();
    private int rounds;

    /// @param round one of whom nothing was heard for that long is asked
    /// @param timeout after that long without a sign it counts as silent; several rounds, where messages get lost
    /// @param listener called on the agent's lane
    public FailureDetector(AgentContext self, Duration round, Duration timeout, Consumer<? super Change> listener) {
        if (!round.isPositive() || timeout.compareTo(round) <= 0) {
            throw new IllegalArgumentException(
                    "A failure detector needs 0 < round < timeout, not '%s' and '%s'.".formatted(round, timeout));
        }
        this.self = self;
        this.round = round;
        this.timeout = timeout;
        this.listener = listener;
    }

    /// Asks who is there, and goes on asking.
    public void begin() {
        self.subscribe(Hello.TOPIC, message -> {
            if (message.content().kind() == Kind.BYE) {
                leave(message.sender());
            } else {
                sign(message.sender(), message.content().robot());
            }
        });
        self.subscribe(
                PoseReport.TOPIC,
                message -> sign(message.sender(), message.content().robot()));
        self.scheduler().every(round, this::look);
        call();
    }

    /// Those who are there, by name.
    public List<Member> present() {
        return known.values().stream()
                .filter(one -> !one.silent)
                .map(one -> one.member)
                .toList();
    }

    /// Whether nothing has been heard of one for so long that it counts as silent; empty when it was never heard.
    public Optional<Boolean> isSilent(String name) {
        return Optional.ofNullable(known.get(name)).map(one -> one.silent);
    }

    private void sign(String name, String robot) {
        Known one = known.get(name);
        if (one == null) {
            one = new Known(new Member(name, robot), now());
            known.put(name, one);
            listener.accept(new Change.Appeared(one.member));
            return;
        }
        one.sign = now();
        if (one.silent) {
            one.silent = false;
            listener.accept(new Change.CameBack(one.member));
        }
    }

    private void leave(String name) {
        Known one = known.remove(name);
        if (one != null) {
            listener.accept(new Change.Left(one.member));
        }
    }

    private void look() {
        rounds++;
        if (rounds % ROUNDS_PER_CALL == 0) {
            call();
        }
        var fallenSilent = new ArrayList<Known>();
        known.forEach((name, one) -> {
            Duration quiet = Duration.between(one.sign, now());
            if (quiet.compareTo(round) >= 0) {
                self.send(name, Hello.TOPIC, ping(name));
            }
            if (!one.silent && quiet.compareTo(timeout) >= 0) {
                one.silent = true;
                fallenSilent.add(one);
            }
        });
        fallenSilent.forEach(one -> listener.accept(new Change.FellSilent(one.member, one.sign)));
    }

    private void call() {
        self.publish(Hello.TOPIC, ping(""));
    }

    private Hello ping(String to) {
        return new Hello(self.robot().map(Robot::id).orElse(""), Kind.PING, to);
    }

    private Instant now() {
        return self.scheduler().instant();
    }

    /// @param name of the agent
    /// @param robot id of its robot; empty when it has none
    public record Member(String name, String robot) {}

    public sealed interface Change {
        Member member();

        /// Was not known.
        record Appeared(Member member) implements Change {}

        /// @param since when it was heard last
        record FellSilent(Member member, Instant since) implements Change {}

        /// Is heard again.
        record CameBack(Member member) implements Change {}

        /// Has said bye.
        record Left(Member member) implements Change {}
    }

    private static final class Known {
        private final Member member;
        private Instant sign;
        private boolean silent;

        Known(Member member, Instant sign) {
            this.member = member;
            this.sign = sign;
        }
    }
}
