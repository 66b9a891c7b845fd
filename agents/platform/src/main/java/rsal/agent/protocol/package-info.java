/// Conversations between agents, by the interaction protocols of FIPA: each has two sides, and a table that
/// says which act may follow which. An agent makes one object for each kind of conversation it takes part in,
/// on whichever side: `new Request<>(self, "open-door", Door.class, Opened.class)`; all that use one name talk
/// to each other.
///
/// Messages may be lost, late or doubled. So the initiator of a conversation says again what was not answered,
/// asks a partner that works for long whether it still does, and learns in bounded time that one is silent
/// ([RetryPolicy]); what comes twice is heard once. In a perfect network this costs nothing but the questions
/// whether a partner still works.
///
/// Sources: FIPA SC00026H (request), SC00029H (contract net), SC00030H (iterated contract net), SC00035H
/// (subscribe), SC00036H (propose), XC00031F (English auction), XC00032F (Dutch auction), SC00037J
/// (communicative acts), SC00061G (parameters of messages). We depart from them in that acts are counted, and
/// that numbers of acts heard are sent along, which is what makes conversations safe against loss.
@NullMarked
package rsal.agent.protocol;

import org.jspecify.annotations.NullMarked;
