package rsal.agent.protocol;

import java.time.Instant;
import java.util.Optional;

/// What one says to another in a conversation, with the parameters that FIPA gives a message (SC00061G).
///
/// @param protocol as FIPA calls it: `fipa-request`
/// @param conversation its id, the same for all partners of one who speaks to several at once
/// @param from which side of the conversation says it
/// @param number counts what that side has said to this partner, from 1; what comes twice is known by it. 0 when
/// it says nothing new, but shows that it is there and what it has heard
/// @param heard number of the partner's newest act that had been heard when this was sent
/// @param replyBy when an answer is of use no more; empty when there is time
/// @param content what it is about, immutable; a text where the protocol has no more to say than why
public record Act(
        Performative performative,
        String protocol,
        String conversation,
        Side from,
        int number,
        int heard,
        Optional<Instant> replyBy,
        Object content) {

    /// The same, said again by one who has heard more meanwhile.
    Act again(int heardMeanwhile) {
        return new Act(performative, protocol, conversation, from, number, heardMeanwhile, replyBy, content);
    }

    /// For people: `cfp: Pickup[...]`.
    @Override
    public String toString() {
        return content.equals("") ? performative.toString() : performative + ": " + content;
    }
}
