package rsal.agent.protocol;

/// A conversation with one partner that ends once, for the one who began it.
record PartnerConversation<A>(Dialogue dialogue, ProtocolOutcome<A> outcome) implements Conversation {
    static <A> PartnerConversation<A> begin(
            ConversationManager conversations,
            String to,
            RetryPolicy patience,
            ProtocolOutcome<A> outcome,
            Performative opening,
            Object content) {
        Dialogue dialogue = conversations.begin(conversations.newConversation(), to, patience, outcome);
        dialogue.say(opening, content);
        return new PartnerConversation<>(dialogue, outcome);
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
