package rsal.agent.protocol;

import java.util.Locale;

/// What somebody does by saying something: those of FIPA's communicative acts (SC00037J) that its interaction
/// protocols are made of.
public enum Performative {
    ACCEPT_PROPOSAL,
    AGREE,
    CANCEL,
    CFP,
    FAILURE,
    INFORM,
    NOT_UNDERSTOOD,
    PROPOSE,
    REFUSE,
    REJECT_PROPOSAL,
    REQUEST,
    SUBSCRIBE;

    /// As FIPA writes it: `accept-proposal`.
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
