package rsal.agent.protocol;

import java.util.function.Function;

/// The one way in which a conversation ended for the one who began it.
public sealed interface ConversationResult<A> {
    /// The same, with the result as something else.
    default <B> ConversationResult<B> map(Function<? super A, ? extends B> how) {
        return switch (this) {
            case Informed<A>(A result) -> new Informed<>(how.apply(result));
            case Refused<A>(String why) -> new Refused<>(why);
            case Failed<A>(String why) -> new Failed<>(why);
            case NotUnderstood<A>(String why) -> new NotUnderstood<>(why);
            case Silent<A>(String why) -> new Silent<>(why);
            case Cancelled<A>() -> new Cancelled<>();
        };
    }

    /// It is done; this came of it.
    record Informed<A>(A result) implements ConversationResult<A> {}

    /// The partner does not want to, or can't.
    record Refused<A>(String why) implements ConversationResult<A> {}

    /// The partner tried.
    record Failed<A>(String why) implements ConversationResult<A> {}

    /// One of the two said what the other did not expect.
    record NotUnderstood<A>(String why) implements ConversationResult<A> {}

    /// Nothing is heard of the partner any more.
    record Silent<A>(String why) implements ConversationResult<A> {}

    /// The initiator did not want it any more.
    record Cancelled<A>() implements ConversationResult<A> {}
}
