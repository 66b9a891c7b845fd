package rsal.agent.protocol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.time.Task;

/// All conversations of one agent by one protocol under one name. On the agent's lane.
final class ConversationManager {
    private static final int MOST_OPEN = 10_000;
    private static final Duration MEMORY = Duration.ofMinutes(2); // longer than messages are late

    private final AgentContext self;
    private final ProtocolStateMachine grammar;
    private final Topic<Act> topic;
    private final Map<ProtocolStateMachine.Slot, Class<?>> contents;
    private final Map<Key, Dialogue> dialogues = new LinkedHashMap<>();
    private final Deque<Ended> ended = new ArrayDeque<>(); // still known, to answer those who did not hear the end
    private final Instant made;
    private @Nullable Doorman doorman;
    private int begun;
    private int open;

    ConversationManager(
            AgentContext self,
            String name,
            ProtocolStateMachine grammar,
            Class<?> subject,
            Class<?> bid,
            Class<?> result) {
        this.self = self;
        this.grammar = grammar;
        this.topic = new Topic<>(name, Act.class);
        this.contents = new EnumMap<>(Map.of(
                ProtocolStateMachine.Slot.SUBJECT, subject,
                ProtocolStateMachine.Slot.BID, bid,
                ProtocolStateMachine.Slot.RESULT, result,
                ProtocolStateMachine.Slot.WORDS, String.class,
                ProtocolStateMachine.Slot.ANYTHING, Object.class));
        this.made = self.scheduler().instant();
        self.subscribe(topic, this::hear);
        self.directory().onDeparture(went -> partnerWent(went.agent().name()));
    }

    /// From now on others may begin conversations with this agent.
    ///
    /// @throws IllegalStateException when somebody answers already
    void open(Doorman answering) {
        if (doorman != null) {
            throw new IllegalStateException(
                    "Agent '%s' answers '%s' already; maybe it does so twice.".formatted(name(), topic.name()));
        }
        doorman = answering;
    }

    /// An id that no other conversation of this run has, also when this agent was there before under its name.
    String newConversation() {
        begun++;
        return "%s:%s:%d:%d".formatted(name(), topic.name(), made.toEpochMilli(), begun);
    }

    Dialogue begin(String conversation, String partner, RetryPolicy patience, Dialogue.Listener listener) {
        forget();
        var dialogue = new Dialogue(this, conversation, partner, Side.INITIATOR, patience, listener);
        add(dialogue);
        return dialogue;
    }

    private void add(Dialogue dialogue) {
        dialogues.put(Key.of(dialogue), dialogue);
        open++;
    }

    private void hear(Message<Act> message) {
        Act act = message.content();
        var key = new Key(act.conversation(), message.sender(), act.from().other());
        Dialogue known = dialogues.get(key);
        if (known != null) {
            known.hear(act);
        } else if (act.from() == Side.INITIATOR && act.number() == 1) {
            answer(message.sender(), act);
        }
    }

    private void answer(String partner, Act act) {
        forget();
        var dialogue = new Dialogue(
                this, act.conversation(), partner, Side.PARTICIPANT, RetryPolicy.DEFAULT, new Dialogue.Listener() {
                    @Override
                    public void heard(Act unwanted) {}

                    @Override
                    public void lost(String why) {}
                });
        add(dialogue);
        if (open > MOST_OPEN) {
            letGoOfTheForgotten();
        }
        Doorman answering = doorman;
        if (answering != null && open <= MOST_OPEN) {
            dialogue.listen(answering.admit(dialogue));
            dialogue.hear(act);
        } else {
            dialogue.hear(act);
            if (!dialogue.isOver()) {
                dialogue.say(
                        Performative.NOT_UNDERSTOOD,
                        answering == null
                                ? "'%s' does not answer '%s'.".formatted(name(), topic.name())
                                : "'%s' has too many conversations.".formatted(name()));
            }
        }
    }

    private void partnerWent(String partner) {
        for (Dialogue dialogue : List.copyOf(dialogues.values())) {
            if (dialogue.partner().equals(partner)) {
                dialogue.lose("'%s' has ended.".formatted(partner));
            }
        }
    }

    void over(Dialogue dialogue) {
        open--;
        ended.addLast(new Ended(Key.of(dialogue), now()));
    }

    /// Lets go of conversations that others began and have not come back to.
    private void letGoOfTheForgotten() {
        Instant longAgo = now().minus(MEMORY);
        for (Dialogue dialogue : List.copyOf(dialogues.values())) {
            if (dialogue.side() == Side.PARTICIPANT && dialogue.lastSign().isBefore(longAgo)) {
                dialogue.lose("Nothing was heard of '%s' for long.".formatted(dialogue.partner()));
            }
        }
    }

    /// Lets go of what ended long ago.
    private void forget() {
        Instant longAgo = now().minus(MEMORY);
        while (!ended.isEmpty() && (ended.getFirst().at().isBefore(longAgo) || ended.size() > MOST_OPEN)) {
            dialogues.remove(ended.removeFirst().key());
        }
    }

    void send(String partner, Act act) {
        self.send(partner, topic, act);
    }

    boolean fits(ProtocolStateMachine.Slot slot, Object content) {
        Class<?> wanted = contents.get(slot);
        return wanted != null && wanted.isInstance(content);
    }

    Task after(Duration delay, Runnable task) {
        return self.scheduler().after(delay, task);
    }

    Instant now() {
        return self.scheduler().instant();
    }

    ProtocolStateMachine grammar() {
        return grammar;
    }

    String name() {
        return self.name();
    }

    /// Decides who hears a conversation that somebody else begins.
    interface Doorman {
        Dialogue.Listener admit(Dialogue dialogue);
    }

    private record Key(String conversation, String partner, Side side) {
        static Key of(Dialogue dialogue) {
            return new Key(dialogue.conversation(), dialogue.partner(), dialogue.side());
        }
    }

    private record Ended(Key key, Instant at) {}
}
