package rsal.agent.message;

import rsal.agent.Topic;

/// Presence: said at the start and the end of an agent, and when somebody asks.
///
/// @param robot id of the sender's robot; empty when it has none
/// @param kind of greeting
/// @param to name of the agent it asks or answers; empty for all
public record Hello(String robot, Kind kind, String to) {
    public static final Topic<Hello> TOPIC = new Topic<>("hello", Hello.class);

    public Hello {
        Check.given("robot", robot);
        Check.given("kind", kind);
        Check.given("to", to);
    }

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
}
