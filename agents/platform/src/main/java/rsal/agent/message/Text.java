package rsal.agent.message;

import rsal.agent.MessageContent;
import rsal.agent.Topic;

/// A text for people, and for agents that can read it.
///
/// @param words the text
public record Text(String words) implements MessageContent {
    public static final Topic<Text> TOPIC = new Topic<>("text", Text.class);

    public Text {
        MessageCheck.given("words", words);
    }
}
