package rsal.agent.protocol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.time.Task;

/// One side of a conversation with one partner: keeps to the grammar, hears each act once and in order, and, as the
/// side that began, says again what may not have arrived.
///
/// The side that was spoken to says something again only when it hears something again. All on the agent's lane.
final class Dialogue {
    private static final int MOST_UNHEARD = 1_000;
    private static final int MOST_AHEAD = 64;

    private final ConversationManager conversations;
    private final String conversation;
    private final String partner;
    private final Side side;
    private final RetryPolicy patience;
    private final Deque<Act> unheard = new ArrayDeque<>(); // said, and not known to have been heard
    private final Map<Integer, Act> early = new HashMap<>(); // came before what was said before them
    private Listener listener;
    private String state = ProtocolStateMachine.BEGIN;
    private @Nullable Act last;
    private int said;
    private int heard;
    private Instant sign;
    private @Nullable Task beat;
    private boolean hadLastWord;
    private boolean lingering;

    Dialogue(
            ConversationManager conversations,
            String conversation,
            String partner,
            Side side,
            RetryPolicy patience,
            Listener listener) {
        this.conversations = conversations;
        this.conversation = conversation;
        this.partner = partner;
        this.side = side;
        this.patience = patience;
        this.listener = listener;
        this.sign = conversations.now();
    }

    String conversation() {
        return conversation;
    }

    String partner() {
        return partner;
    }

    Side side() {
        return side;
    }

    /// Whether the partner has shown that it has heard everything.
    boolean isHeard() {
        return unheard.isEmpty();
    }

    /// When something was heard of the partner last.
    Instant lastSign() {
        return sign;
    }

    void listen(Listener other) {
        listener = other;
    }

    boolean isOver() {
        return state.equals(ProtocolStateMachine.END);
    }

    /// Whether the protocol allows this side to say that now.
    boolean may(Performative act) {
        return conversations.grammar().after(state, side, act).isPresent();
    }

    void say(Performative performative, Object content) {
        say(performative, Optional.empty(), content);
    }

    /// Says something that the protocol allows now, unless the partner has ended the conversation meanwhile.
    ///
    /// @throws IllegalStateException when the protocol does not allow it
    void say(Performative performative, Optional<Instant> replyBy, Object content) {
        if (isOver() && !hadLastWord) {
            return;
        }
        ProtocolStateMachine.Next next =
                conversations.grammar().after(state, side, performative).orElseThrow(() -> outOfTurn(performative));
        if (!conversations.fits(next.content(), content)) {
            throw new IllegalStateException("Agent '%s' said '%s' with '%s', which is nothing for conversation '%s'."
                    .formatted(conversations.name(), performative, content, conversation));
        }
        if (unheard.size() == MOST_UNHEARD) {
            lose("'%s' has not heard the last %d messages.".formatted(partner, MOST_UNHEARD));
            return;
        }
        utter(performative, replyBy, content, next.state());
        hadLastWord = isOver();
    }

    private void utter(Performative performative, Optional<Instant> replyBy, Object content, String next) {
        state = next;
        said++;
        var act = new Act(
                performative, conversations.grammar().name(), conversation, side, said, heard, replyBy, content);
        last = act;
        unheard.addLast(act);
        conversations.send(partner, act);
        if (isOver()) {
            conversations.over(this);
        }
        watch();
    }

    private IllegalStateException outOfTurn(Performative performative) {
        return new IllegalStateException(
                "Agent '%s' said '%s' to '%s' in conversation '%s', which is over or waits for something else in '%s'."
                        .formatted(
                                conversations.name(),
                                performative,
                                partner,
                                conversation,
                                conversations.grammar().name()));
    }

    void hear(Act act) {
        sign = conversations.now();
        while (!unheard.isEmpty() && unheard.getFirst().number() <= act.heard()) {
            unheard.removeFirst();
        }
        if (act.number() <= heard || isOver()) {
            if (side == Side.PARTICIPANT) {
                repeat();
            }
            return;
        }
        if (act.number() - heard <= MOST_AHEAD) {
            early.put(act.number(), act);
        }
        for (Act next = early.remove(heard + 1); next != null && !isOver(); next = early.remove(heard + 1)) {
            take(next);
        }
    }

    private void take(Act act) {
        heard++;
        Optional<ProtocolStateMachine.Next> next =
                conversations.grammar().after(state, side.other(), act.performative());
        if (next.isEmpty() || !conversations.fits(next.get().content(), act.content())) {
            doNotUnderstand(act);
            return;
        }
        state = next.get().state();
        if (isOver()) {
            conversations.over(this);
        }
        if (act.performative() == Performative.CANCEL) {
            utter(Performative.INFORM, Optional.empty(), "cancelled", ProtocolStateMachine.END);
            listener.lost("'%s' has cancelled it.".formatted(partner));
        } else {
            listener.heard(act);
        }
    }

    private void doNotUnderstand(Act act) {
        String why = "'%s' said '%s', which was not expected in '%s'."
                .formatted(partner, act, conversations.grammar().name());
        utter(Performative.NOT_UNDERSTOOD, Optional.empty(), why, ProtocolStateMachine.END);
        listener.heard(Objects.requireNonNull(last));
    }

    private void repeat() {
        if (!unheard.isEmpty()) {
            unheard.forEach(act -> conversations.send(partner, act.again(heard)));
        } else if (last != null) {
            conversations.send(partner, last.again(heard));
        } else if (conversations.grammar().isSilenceAnAnswer()) {
            conversations.send(partner, presence());
        }
    }

    private Act presence() {
        String protocol = conversations.grammar().name();
        return new Act(Performative.INFORM, protocol, conversation, side, 0, heard, Optional.empty(), "I am here.");
    }

    /// How long nothing was heard of the partner.
    private Duration quiet() {
        return Duration.between(sign, conversations.now());
    }

    /// The initiator asks again after a while, and more often when the last two times brought nothing.
    private void watch() {
        if (beat != null) {
            beat.cancel();
        }
        if (side == Side.INITIATOR && (!isOver() || lingering)) {
            boolean doubtful = quiet().compareTo(patience.repeat().multipliedBy(2)) > 0;
            beat = conversations.after(doubtful ? patience.repeat().dividedBy(4) : patience.repeat(), this::ask);
        }
    }

    private void ask() {
        if (isOver() && (!lingering || unheard.isEmpty())) {
            return;
        }
        if (quiet().compareTo(patience.silence()) >= 0) {
            lingering = false;
            lose("Nothing was heard of '%s' for %.1f s.".formatted(partner, quiet().toNanos() / 1e9));
            return;
        }
        repeat();
        watch();
    }

    /// Will say its last words again until they have been heard.
    void linger() {
        lingering = true;
    }

    /// Ends without a word.
    void lose(String why) {
        if (!isOver()) {
            state = ProtocolStateMachine.END;
            conversations.over(this);
            listener.lost(why);
        }
    }

    /// Told what the partner says.
    interface Listener {
        /// Something that the protocol allows now. That something was not understood comes last, no matter who says so.
        void heard(Act act);

        /// Nothing more will be heard.
        void lost(String why);
    }
}
