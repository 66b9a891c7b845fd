package rsal.environment;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Interest;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.agent.Topics;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Numbers of the newest messages that the learner's agent has heard of a topic, the newest first. Of each: the numbers
/// that were asked for, how long ago it was said [s], and whether there is one. Real robots have it.
public final class MessagesObservation implements ObservationType {
    private static final Parameter<String> TOPIC = Parameter.text("topic", "Name of the topic.");
    private static final Parameter<String> FIELDS = Parameter.text(
            "fields", "Numbers of a message, as Python names them, with spaces between: 'map_from_base.x price'.");
    private static final Parameter<String> FROM = Parameter.text(
            "from", "", "Whose messages count: name or role of an agent, or of its robot. Default: everybody's.");
    private static final Parameter<Integer> NEWEST =
            Parameter.integer("newest", 1, 1, 100, "", "Number of messages, the newest first.");
    private static final Parameter<Double> MAX =
            Parameter.number("max", 100, 1e-3, 1e6, "", "Greatest number; those beyond count as this one.");
    private static final float OLDEST = 1000; // s

    @Override
    public String key() {
        return "messages";
    }

    @Override
    public String description() {
        return "Numbers of the newest messages of a topic, and how long ago they were said [s].";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(TOPIC, FIELDS, FROM, NEWEST, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        String name = arguments.get(TOPIC).strip();
        if (name.isEmpty()) {
            throw new IllegalArgumentException("'topic' must name a topic, as 'pose'.");
        }
        Topic<?> topic = Topics.installed().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseGet(() -> new Topic<>(name, Map.class)); // one of people's own
        List<MessageNumber> numbers = Arrays.stream(arguments.get(FIELDS).split("[\\s,]+"))
                .filter(each -> !each.isEmpty())
                .map(each -> MessageNumber.of(topic, each))
                .toList();
        if (numbers.isEmpty()) {
            throw new IllegalArgumentException("'fields' must name at least one number of a message.");
        }
        return new Messages(
                topic,
                numbers,
                arguments.get(FROM),
                arguments.get(NEWEST),
                arguments.get(MAX).floatValue());
    }

    private record Messages(Topic<?> topic, List<MessageNumber> numbers, String from, int newest, float max)
            implements LearnerObservation {
        @Override
        public List<String> fields() {
            var fields = new ArrayList<String>();
            for (int i = 1; i <= newest; i++) {
                for (MessageNumber number : numbers) {
                    fields.add("%s of message %d".formatted(number.name(), i));
                }
                fields.add("age of message %d [s]".formatted(i));
                fields.add("message %d exists".formatted(i));
            }
            return fields;
        }

        @Override
        public float[] low() {
            return limits(-max, 0, 0);
        }

        @Override
        public float[] high() {
            return limits(max, OLDEST, 1);
        }

        private float[] limits(float number, float age, float exists) {
            var one = new float[numbers.size() + 2];
            Arrays.fill(one, number);
            one[numbers.size()] = age;
            one[numbers.size() + 1] = exists;
            return Bounds.repeated(newest, one);
        }

        @Override
        public Maker listen(Learner learner, AgentContext self) {
            var heard = new Heard(this, self);
            heard.subscribe(topic);
            return (robot, world) -> heard;
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            throw new IllegalStateException("Messages are heard by an agent only.");
        }
    }

    /// What one learner has heard, as a ring.
    private static final class Heard implements LearnerObservation.Reader {
        private final Messages wanted;
        private final AgentContext self;
        private final float[] numbers; // by place in the ring, then by number
        private final Instant[] times; // by place in the ring
        private int count; // so far
        private @Nullable IllegalArgumentException wrong; // the first message without such a number

        Heard(Messages wanted, AgentContext self) {
            this.wanted = wanted;
            this.self = self;
            this.numbers = new float[wanted.newest * wanted.numbers.size()];
            this.times = new Instant[wanted.newest];
            Arrays.fill(times, Instant.EPOCH);
        }

        <M> void subscribe(Topic<M> topic) {
            Predicate<Message<M>> counts = message -> isFrom(message.sender());
            self.subscribe(topic, new Interest<>(counts, Duration.ZERO), this::hear);
        }

        private boolean isFrom(String sender) {
            String from = wanted.from;
            return from.isEmpty()
                    || from.equals(sender)
                    || self.directory()
                            .find(sender)
                            .filter(agent -> from.equals(agent.role())
                                    || from.equals(agent.robot())
                                    || from.equals(agent.robotRole()))
                            .isPresent();
        }

        private void hear(Message<?> message) {
            int place = count % wanted.newest;
            int first = place * wanted.numbers.size();
            try {
                for (int i = 0; i < wanted.numbers.size(); i++) {
                    float number = (float) wanted.numbers.get(i).in(message.content());
                    numbers[first + i] = Float.isNaN(number) ? 0 : Math.clamp(number, -wanted.max, wanted.max);
                }
            } catch (IllegalArgumentException e) {
                wrong = wrong == null ? e : wrong;
                return;
            }
            times[place] = message.time();
            count++;
        }

        @Override
        public void read(float[] to, int at) {
            if (wrong != null) {
                throw new IllegalArgumentException("Observation 'messages': " + wrong.getMessage(), wrong);
            }
            int size = wanted.numbers.size();
            Instant now = self.scheduler().instant();
            for (int i = 0; i < wanted.newest; i++) {
                int next = at + i * (size + 2);
                if (i >= count) {
                    Arrays.fill(to, next, next + size + 2, 0);
                    continue;
                }
                int place = (count - 1 - i) % wanted.newest;
                System.arraycopy(numbers, place * size, to, next, size);
                float age = Duration.between(times[place], now).toNanos() / 1e9f;
                to[next + size] = Math.clamp(age, 0, OLDEST);
                to[next + size + 1] = 1;
            }
        }
    }
}
