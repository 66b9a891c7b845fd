package rsal.agent.protocol;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/// Which act may follow which in a protocol. States are named after what was said last.
///
/// Beside what is written down, the initiator may cancel what has begun and not ended (FIPA's cancel protocol, which is
/// answered by inform or failure), and either may say that it has not understood, which ends it.
final class ProtocolStateMachine {
    static final String BEGIN = "begin";
    static final String END = "end";
    private static final String CANCELLED = "cancelled";

    static final ProtocolStateMachine REQUEST = new ProtocolStateMachine("fipa-request")
            .initiator(BEGIN, Performative.REQUEST, Slot.SUBJECT, "requested")
            .participant("requested", Performative.AGREE, Slot.WORDS, "agreed")
            .participant("requested", Performative.REFUSE, Slot.WORDS, END)
            .participant("requested", Performative.FAILURE, Slot.WORDS, END)
            .participant("requested", Performative.INFORM, Slot.RESULT, END)
            .participant("agreed", Performative.FAILURE, Slot.WORDS, END)
            .participant("agreed", Performative.INFORM, Slot.RESULT, END);

    static final ProtocolStateMachine CONTRACT_NET = contractNet("fipa-contract-net");

    static final ProtocolStateMachine ITERATED_CONTRACT_NET =
            contractNet("fipa-iterated-contract-net").initiator("proposed", Performative.CFP, Slot.SUBJECT, "called");

    static final ProtocolStateMachine SUBSCRIBE = new ProtocolStateMachine("fipa-subscribe")
            .initiator(BEGIN, Performative.SUBSCRIBE, Slot.SUBJECT, "asked")
            .participant("asked", Performative.AGREE, Slot.WORDS, "subscribed")
            .participant("asked", Performative.REFUSE, Slot.WORDS, END)
            .participant("asked", Performative.INFORM, Slot.RESULT, "subscribed")
            .participant("subscribed", Performative.INFORM, Slot.RESULT, "subscribed")
            .participant("asked", Performative.FAILURE, Slot.WORDS, END)
            .participant("subscribed", Performative.FAILURE, Slot.WORDS, END);

    static final ProtocolStateMachine PROPOSE = new ProtocolStateMachine("fipa-propose")
            .initiator(BEGIN, Performative.PROPOSE, Slot.SUBJECT, "proposed")
            .participant("proposed", Performative.ACCEPT_PROPOSAL, Slot.WORDS, END)
            .participant("proposed", Performative.REJECT_PROPOSAL, Slot.WORDS, END);

    static final ProtocolStateMachine ENGLISH_AUCTION = auction("fipa-auction-english");

    static final ProtocolStateMachine DUTCH_AUCTION = auction("fipa-auction-dutch");

    private static ProtocolStateMachine contractNet(String name) {
        return new ProtocolStateMachine(name)
                .initiator(BEGIN, Performative.CFP, Slot.SUBJECT, "called")
                .participant("called", Performative.REFUSE, Slot.WORDS, END)
                .participant("called", Performative.PROPOSE, Slot.BID, "proposed")
                .initiator("proposed", Performative.REJECT_PROPOSAL, Slot.WORDS, END)
                .initiator("proposed", Performative.ACCEPT_PROPOSAL, Slot.SUBJECT, "accepted")
                .participant("accepted", Performative.FAILURE, Slot.WORDS, END)
                .participant("accepted", Performative.INFORM, Slot.RESULT, END);
    }

    /// Who does not want a price says nothing, so that the next call may follow the one before. So what both say may
    /// cross, and an offer may be met by the next price or by the end, or be followed by the offer for that price.
    private static ProtocolStateMachine auction(String name) {
        var auction = new ProtocolStateMachine(name)
                .initiator(BEGIN, Performative.INFORM, Slot.SUBJECT, "announced")
                .initiator("announced", Performative.CFP, Slot.BID, "called")
                .initiator("called", Performative.CFP, Slot.BID, "called")
                .participant("called", Performative.PROPOSE, Slot.BID, "proposed")
                .participant("proposed", Performative.PROPOSE, Slot.BID, "proposed")
                .initiator("proposed", Performative.CFP, Slot.BID, "called")
                .initiator("proposed", Performative.ACCEPT_PROPOSAL, Slot.BID, "answered")
                .initiator("proposed", Performative.REJECT_PROPOSAL, Slot.BID, "answered")
                .initiator("answered", Performative.CFP, Slot.BID, "called")
                .initiator("announced", Performative.INFORM, Slot.RESULT, END)
                .initiator("called", Performative.INFORM, Slot.RESULT, END)
                .initiator("proposed", Performative.INFORM, Slot.RESULT, END)
                .initiator("answered", Performative.INFORM, Slot.RESULT, END);
        auction.silenceIsAnAnswer = true;
        return auction;
    }

    private final String name;
    private boolean silenceIsAnAnswer;
    private final Map<Step, Next> steps = new LinkedHashMap<>();

    private ProtocolStateMachine(String name) {
        this.name = name;
    }

    private ProtocolStateMachine initiator(String state, Performative act, Slot content, String next) {
        steps.put(new Step(state, Side.INITIATOR, act), new Next(next, content));
        return this;
    }

    private ProtocolStateMachine participant(String state, Performative act, Slot content, String next) {
        steps.put(new Step(state, Side.PARTICIPANT, act), new Next(next, content));
        return this;
    }

    /// Whether a participant may say nothing at all, so that it must show otherwise that it is there.
    boolean isSilenceAnAnswer() {
        return silenceIsAnAnswer;
    }

    /// As FIPA calls the protocol.
    String name() {
        return name;
    }

    /// What comes of an act; empty when it may not be said now.
    Optional<Next> after(String state, Side from, Performative act) {
        if (state.equals(END)) {
            return Optional.empty();
        }
        if (act == Performative.NOT_UNDERSTOOD) {
            return Optional.of(new Next(END, Slot.WORDS));
        }
        if (state.equals(CANCELLED)) {
            return from == Side.INITIATOR ? Optional.empty() : Optional.of(afterCancel(act));
        }
        if (act == Performative.CANCEL && from == Side.INITIATOR && !state.equals(BEGIN)) {
            return Optional.of(new Next(CANCELLED, Slot.WORDS));
        }
        return Optional.ofNullable(steps.get(new Step(state, from, act)));
    }

    /// What the participant had said before it heard of it does no harm.
    private static Next afterCancel(Performative act) {
        boolean answer = act == Performative.INFORM || act == Performative.FAILURE || act == Performative.REFUSE;
        return new Next(answer ? END : CANCELLED, Slot.ANYTHING);
    }

    /// What the content of an act is, whose type a desk knows.
    enum Slot {
        /// What the conversation is about: the question, the task, the lot.
        SUBJECT,
        BID,
        RESULT,
        /// A text.
        WORDS,
        ANYTHING
    }

    record Next(String state, Slot content) {}

    private record Step(String state, Side from, Performative act) {}
}
