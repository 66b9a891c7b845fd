package rsal.jason;

import jason.JasonException;
import jason.asSemantics.Message;
import jason.asSyntax.Atom;
import jason.asSyntax.Term;
import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.settings.Suggestion;

/// Carries Jason's messages on a topic.
final class MessageSender {
    private final AgentContext self;
    private final AgentSpeakAgent agent;
    private int sent;

    MessageSender(AgentContext self, AgentSpeakAgent agent) {
        this.self = self;
        this.agent = agent;
    }

    void begin() {
        var reader = new TermReader(agent.reasoner());
        self.subscribe(Speech.TOPIC, message -> hear(message.sender(), message.content(), reader));
    }

    /// An id for the next message: of this agent alone, as Jason's own are counted for the whole process.
    String nextId(String prefix) {
        return prefix + ++sent;
    }

    /// @throws JasonException when nobody has that name, so that the one that says it can do something else
    void send(Message message) throws JasonException {
        String to = Terms.unquoted(message.getReceiver());
        if (self.directory().find(to).isEmpty()) {
            List<String> names = self.directory().agents().stream()
                    .map(Directory.Entry::name)
                    .toList();
            throw new JasonException(
                    "There is no agent '%s'. %s".formatted(to, Suggestion.among(to, names)),
                    new Atom("receiver_not_found"));
        }
        self.send(to, Speech.TOPIC, speech(message));
    }

    void broadcast(Message message) {
        message.setMsgId(nextId(Message.msgIdPrefix));
        self.publish(Speech.TOPIC, speech(message));
    }

    private static Speech speech(Message message) {
        Object content = message.getPropCont();
        String answers = message.getInReplyTo();
        return new Speech(
                message.getIlForce(),
                content instanceof Term term ? Terms.written(term) : String.valueOf(content),
                message.getMsgId(),
                answers == null ? "" : answers);
    }

    private void hear(String sender, Speech speech, TermReader reader) {
        if (AgentSpeak.TAKEN.contains(sender)) {
            agent.complain(
                    "Messages of agent '%s' are ignored: in AgentSpeak, this name is a source of an agent's own beliefs."
                            .formatted(sender));
            return;
        }
        Term content;
        try {
            content = reader.read(speech.content());
        } catch (IllegalArgumentException e) {
            agent.complain("Agent '%s' sent a content that is not a term: %s".formatted(sender, speech));
            return;
        }
        var message = new Message(
                speech.performative(),
                Terms.quoted(sender),
                Terms.quoted(self.name()),
                content,
                speech.id().isEmpty() ? nextId(Message.msgIdPrefix) : speech.id());
        if (!speech.inReplyTo().isEmpty()) {
            message.setInReplyTo(speech.inReplyTo());
        }
        agent.hear(message);
    }
}
