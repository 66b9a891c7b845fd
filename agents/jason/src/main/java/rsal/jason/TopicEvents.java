package rsal.jason;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import java.util.Optional;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.agent.Topics;

/// What agents say on the common topics, as events `+heard(Topic,From,Content)`. Of topics' names AgentSpeak has
/// `goal_reached` for `goal-reached`.
final class TopicEvents {
    static final String FUNCTOR = "heard";
    static final int ARITY = 3;

    private TopicEvents() {}

    static String name(Topic<?> topic) {
        return topic.name().replace('-', '_');
    }

    static Optional<Topic<?>> topic(String name) {
        return Topics.installed().stream()
                .filter(topic -> name(topic).equals(name) || topic.name().equals(name))
                .findFirst();
    }

    static Literal of(Message<?> message) {
        return ASSyntax.createLiteral(
                FUNCTOR, Terms.atom(name(message.topic())), Terms.atom(message.sender()), Terms.of(message.content()));
    }
}
