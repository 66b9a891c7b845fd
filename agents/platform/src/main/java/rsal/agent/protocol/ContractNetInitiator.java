package rsal.agent.protocol;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import rsal.agent.protocol.ContractNet.Manager;
import rsal.agent.protocol.ContractNet.Proposal;
import rsal.agent.protocol.ContractNet.Round;
import rsal.agent.protocol.ContractNet.Verdict;
import rsal.time.Scheduler;
import rsal.time.Task;

/// The manager's side of a contract net: one call, from its first round to the last result.
public final class ContractNetInitiator<T, B, R> implements Conversation {
    private final Scheduler scheduler;
    private final ConversationManager conversations;
    private final String id;
    private final Class<B> bidType;
    private final Class<R> resultType;
    private final Duration replyWithin;
    private final RetryPolicy patience;
    private final Manager<T, B, R> manager;
    private final SortedMap<String, Dialogue> partners = new TreeMap<>();
    private final SortedMap<String, Proposal<B>> proposals = new TreeMap<>(); // of this round
    private final SortedMap<String, String> refusals = new TreeMap<>();
    private final Set<String> waitingFor = new TreeSet<>();
    private final SortedMap<String, ProtocolOutcome<R>> awarded = new TreeMap<>();
    private @Nullable T task; // of this round
    private @Nullable Task deadline;
    private int round;
    private boolean decided;

    ContractNetInitiator(
            Scheduler scheduler,
            ConversationManager conversations,
            Class<B> bidType,
            Class<R> resultType,
            Duration replyWithin,
            RetryPolicy patience,
            Manager<T, B, R> manager) {
        this.scheduler = scheduler;
        this.conversations = conversations;
        this.id = conversations.newConversation();
        this.bidType = bidType;
        this.resultType = resultType;
        this.replyWithin = replyWithin;
        this.patience = patience;
        this.manager = manager;
    }

    void begin(Collection<String> to, T task) {
        var inOrder = new TreeSet<>(to);
        for (String partner : inOrder) {
            partners.put(partner, conversations.begin(id, partner, patience, new Bidder(partner)));
        }
        call(inOrder, task);
    }

    private void call(Collection<String> to, T what) {
        round++;
        task = what;
        waitingFor.addAll(to);
        proposals.clear();
        Optional<Instant> replyBy = Optional.of(scheduler.instant().plus(replyWithin));
        for (String partner : List.copyOf(waitingFor)) {
            partner(partner).say(Performative.CFP, replyBy, what);
        }
        deadline = scheduler.after(waitingFor.isEmpty() ? Duration.ZERO : replyWithin, this::decide);
    }

    private void decideWhenAllHaveAnswered() {
        if (waitingFor.isEmpty()) {
            decide();
        }
    }

    private void decide() {
        if (decided) {
            return;
        }
        if (deadline != null) {
            deadline.cancel();
        }
        var answers = new Round<>(
                round,
                List.copyOf(proposals.values()),
                Collections.unmodifiableSortedMap(new TreeMap<>(refusals)),
                Collections.unmodifiableSet(new TreeSet<>(waitingFor)));
        waitingFor.clear();
        switch (manager.decide(answers)) {
            case Verdict.Again<T>(T revised) -> call(List.copyOf(proposals.keySet()), revised);
            case Verdict.Award<T>(Set<String> names) -> award(sharesOf(names));
            case Verdict.Share<T>(Map<String, T> shares) -> award(shares);
        }
    }

    /// All of it for each.
    private Map<String, T> sharesOf(Set<String> names) {
        T whole = Objects.requireNonNull(task);
        return names.stream().collect(Collectors.toMap(Function.identity(), _ -> whole));
    }

    private void award(Map<String, T> shares) {
        decided = true;
        var unknown = new HashSet<>(shares.keySet());
        unknown.removeAll(proposals.keySet());
        if (!unknown.isEmpty()) {
            throw new IllegalStateException("Agent '%s' accepted bids of %s, who did not bid in this round; %s did."
                    .formatted(conversations.name(), new TreeSet<>(unknown), proposals.keySet()));
        }
        for (Proposal<B> proposal : List.copyOf(proposals.values())) {
            String name = proposal.from();
            T share = shares.get(name);
            if (share != null) {
                awarded.put(name, new ProtocolOutcome<>(resultType, how -> manager.ended(proposal, how)));
                partner(name).say(Performative.ACCEPT_PROPOSAL, share);
            } else {
                partner(name).say(Performative.REJECT_PROPOSAL, "Another bid was accepted, or none.");
            }
        }
    }

    private Dialogue partner(String name) {
        return Objects.requireNonNull(partners.get(name));
    }

    @Override
    public String id() {
        return id;
    }

    @Override
    public void cancel() {
        decided = true;
        partners.values().forEach(ContractNetInitiator::cancel);
        for (ProtocolOutcome<R> outcome : List.copyOf(awarded.values())) {
            outcome.end(new ConversationResult.Cancelled<>());
        }
    }

    /// Does not want one of those whose bid was accepted to go on. Does nothing for others.
    public void cancel(String contractor) {
        ProtocolOutcome<R> outcome = awarded.get(contractor);
        if (outcome != null) {
            cancel(partner(contractor));
            outcome.end(new ConversationResult.Cancelled<>());
        }
    }

    private static void cancel(Dialogue partner) {
        if (partner.may(Performative.CANCEL)) {
            partner.say(Performative.CANCEL, "");
        }
    }

    /// One who was called, bids, and maybe works.
    private final class Bidder implements Dialogue.Listener {
        private final String name;

        Bidder(String name) {
            this.name = name;
        }

        @Override
        public void heard(Act act) {
            ProtocolOutcome<R> work = awarded.get(name);
            if (work != null) {
                work.heard(act);
                return;
            }
            switch (act.performative()) {
                case PROPOSE -> proposed(bidType.cast(act.content()));
                case REFUSE, NOT_UNDERSTOOD -> gone(ProtocolOutcome.words(act));
                default -> {} // cancelled meanwhile
            }
        }

        private void proposed(B bid) {
            if (waitingFor.remove(name)) {
                proposals.put(name, new Proposal<>(name, bid));
                decideWhenAllHaveAnswered();
            } else if (partner(name).may(Performative.REJECT_PROPOSAL)) {
                partner(name).say(Performative.REJECT_PROPOSAL, "It is too late.");
            }
        }

        private void gone(String why) {
            refusals.put(name, why);
            proposals.remove(name);
            if (waitingFor.remove(name)) {
                decideWhenAllHaveAnswered();
            }
        }

        @Override
        public void lost(String why) {
            ProtocolOutcome<R> work = awarded.get(name);
            if (work != null) {
                work.lost(why);
            } else {
                gone(why);
            }
        }
    }
}
