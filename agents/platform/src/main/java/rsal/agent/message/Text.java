package rsal.agent.message;

import rsal.agent.MessageContent;
import rsal.agent.Topic;

/// Free words, for people and for agents that know how to read them.
public record Text(String words) implements MessageContent {
    public static final Topic<Text> TOPIC = new Topic<>("text", Text.class);

    public Text {
        MessageCheck.given("words", words);
    }
}
