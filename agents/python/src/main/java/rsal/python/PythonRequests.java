package rsal.python;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.Interest;
import rsal.agent.Message;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.agent.Topics;
import rsal.device.Device;
import rsal.device.GoalHandle;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.settings.OwnCode;
import rsal.settings.Suggestion;

/// Does what one agent in Python asks for. On the agent's lane.
///
/// A request is a list: a verb, the place in Python that asks, and arguments. What comes later comes under a number
/// that
/// Python has chosen.
final class PythonRequests implements PythonTurns.Peer {
    private static final int ARGUMENTS = 2; // after verb and place

    private static final Map<String, Topic<?>> INSTALLED =
            Topics.installed().stream().collect(Collectors.toMap(Topic::name, topic -> topic));

    private final AgentContext self;
    private final Heard heard;
    private final Optional<Robot> robot;
    private final Optional<SimulationControl> simulation;
    private final long seed;
    private final Map<Integer, Subscription> held = new HashMap<>(); // by number
    private final Set<String> named = new HashSet<>(); // topics of the agent's own
    private final Map<Integer, GoalHandle<?, ?>> goals = new HashMap<>(); // that go on, by number
    private final PythonConversations conversations;
    private final PythonMind mind;
    private final PythonPolicy policy;
    private final PythonPilots pilots;
    private final PythonBoards boards;

    /// Told what Python listens to.
    interface Heard {
        /// @param newest whether a later one of that number counts instead
        void hear(int number, boolean newest, @Nullable Object value);
    }

    /// What Python has waited for.
    private record Result(Optional<Object> value) {}

    /// What an agent hears of a topic.
    private record Said(String sender, String to, Instant time, Object content) {}

    PythonRequests(AgentContext self, Heard heard) {
        this.self = self;
        this.heard = heard;
        this.robot = self.robot();
        this.simulation = self.simulation();
        this.seed = self.random().nextLong() >>> 1; // Python's are not negative
        this.conversations = new PythonConversations(self, heard, held);
        this.mind = new PythonMind(self);
        this.policy = new PythonPolicy(self, heard);
        this.boards = new PythonBoards(self, heard, held);
        this.pilots = new PythonPilots(self, heard);
    }

    Optional<Robot> robot() {
        return robot;
    }

    Optional<SimulationControl> simulation() {
        return simulation;
    }

    long seed() {
        return seed;
    }

    @Override
    public void perform(List<?> asked) {
        for (Object each : asked) {
            var request = new Request((List<?>) each);
            try {
                perform(request);
            } catch (RuntimeException e) {
                throw PythonFailure.at(request.place(), e);
            }
        }
    }

    /// One request.
    record Request(List<?> words) {
        String verb() {
            return String.valueOf(words.getFirst());
        }

        String place() {
            return String.valueOf(words.get(1));
        }

        @Nullable
        Object argument(int index) {
            return words.get(ARGUMENTS + index);
        }

        int number(int index) {
            return FromWords.integer(words.get(ARGUMENTS + index));
        }

        String text(int index) {
            return String.valueOf(words.get(ARGUMENTS + index));
        }

        Duration seconds(int index) {
            return FromWords.seconds(words.get(ARGUMENTS + index));
        }

        List<?> list(int index) {
            return FromWords.list(words.get(ARGUMENTS + index));
        }
    }

    private void perform(Request asked) {
        switch (asked.verb()) {
            case "call" -> call(asked);
            case "read" -> read(asked.number(0), device(asked.number(1)));
            case "cancelGoal" -> goal(asked.number(0)).ifPresent(GoalHandle::cancel);
            case "feedback" -> goal(asked.number(0)).ifPresent(goal -> feedback(asked.number(1), goal));
            case "cancel" -> cancel(asked.number(0));
            case "publish" -> publish(channel(asked.text(0)), asked.argument(1));
            case "send" -> send(asked.text(0), channel(asked.text(1)), asked.argument(2));
            case "subscribe" -> subscribe(asked.number(0), channel(asked.text(1)), asked.seconds(2));
            case "after" -> {
                int number = asked.number(0);
                held.put(number, self.scheduler().after(asked.seconds(1), () -> {
                    held.remove(number);
                    heard.hear(number, false, null);
                })::cancel);
            }
            case "every" -> {
                int number = asked.number(0);
                held.put(
                        number, self.scheduler().every(asked.seconds(1), () -> heard.hear(number, true, null))::cancel);
            }
            case "departures" -> held.put(asked.number(0), departures(asked.number(0)));
            case "offer" ->
                held.put(asked.number(0), self.offer(service(asked.text(1), FromWords.map(asked.argument(2)))));
            case "write" -> write(topic(asked.text(0)), asked);
            case "erase" -> self.blackboard().erase(topic(asked.text(0)), asked.text(1));
            case "print" -> self.print(asked.text(0));
            case "state" -> self.state(asked.text(0));
            case "show" -> self.show(asked.text(0), asked.text(1));
            case "metric" -> self.metric(asked.text(0), FromWords.number(asked.argument(1)));
            case "observe" ->
                policy.begin(asked.number(0), asked.list(1), asked.argument(2), asked.seconds(3), asked.seconds(4));
            case "act" -> policy.act(asked.list(0));
            case "board", "keepBoard", "writeBoard", "eraseBoard", "askBoard", "watchBoard" -> boards.perform(asked);
            case "engage", "velocity" -> pilots.perform(asked, robot.orElseThrow());
            case "believe", "forget", "pursue", "reached", "drop" -> mind.perform(asked);
            default -> conversations.perform(asked);
        }
    }

    @Override
    public @Nullable Object answer(List<?> words) {
        var asked = new Request(words);
        return switch (asked.verb()) {
            case "latest" -> DeviceCalls.sensor(device(asked.number(0))).latest();
            case "call" -> DeviceCalls.call(device(asked.number(0)), asked.text(1), asked.list(2));
            case "agents" ->
                self.directory().agents().stream().map(this::described).toList();
            case "notes" -> notes(topic(asked.text(0)));
            default -> throw new IllegalArgumentException("RSAL has no '%s'.".formatted(asked.verb()));
        };
    }

    /// @param index −1 for the simulation
    private Device device(int index) {
        return index < 0
                ? simulation.orElseThrow(() -> new IllegalArgumentException("This run has no simulated world."))
                : robot.orElseThrow().devices().get(index);
    }

    private void call(Request asked) {
        int number = asked.number(0);
        Optional<Object> result = DeviceCalls.call(device(asked.number(1)), asked.text(2), asked.list(3));
        switch (result.orElse("")) {
            case GoalHandle<?, ?> goal -> {
                goals.put(number, goal);
                later(asked, goal.result());
            }
            case CompletionStage<?> stage -> later(asked, stage);
            default -> {} // Python does not wait for it
        }
    }

    private void later(Request asked, CompletionStage<?> stage) {
        int number = asked.number(0);
        stage.whenComplete((value, error) -> self.scheduler().execute(() -> {
            goals.remove(number);
            heard.hear(
                    number,
                    false,
                    error == null
                            ? new Result(Optional.ofNullable(value))
                            : Map.of("error", words(error), "place", asked.place()));
        }));
    }

    private static String words(Throwable error) {
        return OwnCode.words(
                error instanceof CompletionException && error.getCause() != null ? error.getCause() : error);
    }

    private Optional<GoalHandle<?, ?>> goal(int number) {
        return Optional.ofNullable(goals.get(number));
    }

    private void feedback(int number, GoalHandle<?, ?> goal) {
        held.put(
                number,
                goal.onFeedback(progress -> self.scheduler().execute(() -> heard.hear(number, true, progress))));
    }

    private void read(int number, Device device) {
        held.put(number, self.subscribe(DeviceCalls.sensor(device), reading -> heard.hear(number, true, reading)));
    }

    private void cancel(int number) {
        Subscription subscription = held.remove(number);
        if (subscription != null) {
            subscription.cancel();
        }
    }

    /// One that RSAL has, or one of people's own, whose messages are maps.
    static Topic<?> topic(String name) {
        Topic<?> installed = INSTALLED.get(name);
        return installed == null ? new Topic<>(name, Map.class) : installed;
    }

    /// The same; a name that is nearly one of RSAL's is asked about once, as nobody else may hear it.
    private Topic<?> channel(String name) {
        if (!INSTALLED.containsKey(name) && named.add(name)) {
            Suggestion.closest(name, INSTALLED.keySet())
                    .ifPresent(near -> self.print("Topic '%s' is one of its own, not one of RSAL. Maybe '%s' was meant?"
                            .formatted(name, near)));
        }
        return topic(name);
    }

    private <M> void publish(Topic<M> topic, @Nullable Object content) {
        self.publish(topic, content(topic, content));
    }

    private <M> void send(String to, Topic<M> topic, @Nullable Object content) {
        self.send(to, topic, content(topic, content));
    }

    static <M> M content(Topic<M> topic, @Nullable Object words) {
        return topic.type().cast(FromWords.value(words, topic.type()));
    }

    private <M> void subscribe(int number, Topic<M> topic, Duration period) {
        held.put(
                number, self.subscribe(topic, Interest.<M>all().atMostEvery(period), message -> hear(number, message)));
    }

    private void hear(int number, Message<?> message) {
        heard.hear(number, false, new Said(message.sender(), message.to(), message.time(), message.content()));
    }

    private Subscription departures(int number) {
        return self.directory()
                .onDeparture(went ->
                        heard.hear(number, false, Map.of("name", went.agent().name(), "reason", went.reason())));
    }

    private static ServiceDescription service(String name, Map<?, ?> details) {
        var texts = new LinkedHashMap<String, String>();
        details.forEach((key, value) -> texts.put(String.valueOf(key), String.valueOf(value)));
        return new ServiceDescription(name, texts);
    }

    private Map<String, Object> described(Directory.Entry agent) {
        var services = new LinkedHashMap<String, Object>();
        self.directory().capabilities(agent.name()).forEach(each -> services.put(each.name(), each.details()));
        var words = new LinkedHashMap<String, Object>();
        words.put("name", agent.name());
        words.put("role", agent.role());
        words.put("type", agent.type());
        words.put("robot", agent.robot());
        words.put("robotRole", agent.robotRole());
        words.put("services", services);
        return words;
    }

    private <M> void write(Topic<M> topic, Request asked) {
        M content = content(topic, asked.argument(2));
        if (asked.argument(3) == null) {
            self.blackboard().write(topic, asked.text(1), content);
        } else {
            self.blackboard().write(topic, asked.text(1), content, asked.seconds(3));
        }
    }

    private List<Map<String, Object>> notes(Topic<?> topic) {
        var notes = new ArrayList<Map<String, Object>>();
        self.blackboard()
                .read(topic)
                .forEach(note ->
                        notes.add(Map.of("name", note.name(), "content", note.content(), "written", note.written())));
        return notes;
    }
}
