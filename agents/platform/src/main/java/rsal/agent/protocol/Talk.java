package rsal.agent.protocol;

/// A conversation with one partner that ends once, for the one who began it.
record Talk<A>(Dialogue dialogue, ProtocolOutcome<A> outcome) implements Conversation {
    static <A> Talk<A> begin(
            ConversationManager conversations,
            String to,
            RetryPolicy patience,
            ProtocolOutcome<A> outcome,
            Performative opening,
            Object content) {
        Dialogue dialogue = conversations.begin(conversations.newConversation(), to, patience, outcome);
        dialogue.say(opening, content);
        return new Talk<>(dialogue, outcome);
    }

    @Override
    public String id() {
        return dialogue.conversation();
    }

    @Override
    public void cancel() {
        if (!outcome.isReported()) {
            dialogue.say(Performative.CANCEL, "");
            outcome.end(new ConversationResult.Cancelled<>());
        }
    }
}
