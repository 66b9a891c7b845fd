package rsal.agent.message;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;

/// Presence of an agent: at its start, at its end, and when another agent asks.
///
/// @param robot id of the sender's robot; empty when it has none
/// @param kind whether the agent has started, asks who is there, answers, or ends
/// @param to name of the agent that is asked or answered; empty for all
public record Hello(String robot, Kind kind, String to) implements MessageContent {
    public static final Topic<Hello> TOPIC = new Topic<>("hello", Hello.class);

    public Hello {
        MessageCheck.given("robot", robot);
        MessageCheck.given("kind", kind);
        MessageCheck.given("to", to);
    }

    /// What an agent says about its presence.
    public enum Kind {
        /// I am here: at the start.
        HELLO,
        /// Who is there? All answer.
        PING,
        /// I am here: the answer to a ping.
        PONG,
        /// I go.
        BYE
    }

    @Override
    public String words() {
        return switch (kind) {
            case HELLO -> "Hello, I am here.";
            case PING -> "Who is there?";
            case PONG -> "%s, I am here.".formatted(to);
            case BYE -> "Bye.";
        };
    }

    /// Who is there is asked and answered again and again.
    @Override
    public Optional<String> eventKind() {
        return kind == Kind.PING || kind == Kind.PONG ? Optional.empty() : MessageContent.super.eventKind();
    }
}
