package rsal.jason;

import java.util.Objects;
import rsal.agent.Topic;

/// What an agent says to others in AgentSpeak: a performative after KQML and a term. Java agents may hear it, and say
/// it.
///
/// @param performative `tell`, `untell`, `achieve`, `askOne`…
/// @param content a term as AgentSpeak writes it: `bid(3.5)`
/// @param id of it, among those of its speaker; empty when nobody is to answer it
/// @param inReplyTo the id of what it answers; empty when it answers nothing
public record Speech(String performative, String content, String id, String inReplyTo) {
    public static final Topic<Speech> TOPIC = new Topic<>("speech", Speech.class);

    public Speech {
        Objects.requireNonNull(performative, "A speech act must have a performative.");
        Objects.requireNonNull(content, "A speech act must have a content.");
        Objects.requireNonNull(id, "A speech act must have an id, even if it is empty.");
        Objects.requireNonNull(inReplyTo, "A speech act must say what it replies to, even if nothing.");
    }

    /// `tell: bid(3.5)`
    @Override
    public String toString() {
        return performative + ": " + content;
    }
}
