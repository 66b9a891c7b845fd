package rsal.scenario.run;

import java.util.List;
import rsal.system.Bridge;

/// What became of an operator's command.
public sealed interface Answer {
    record Done() implements Answer {}

    /// Something was added.
    ///
    /// @param name of it
    record Added(String name) implements Answer {}

    /// Robots are offered to others.
    record Bridged(List<Bridge.Offer> offers) implements Answer {
        public Bridged {
            offers = List.copyOf(offers);
        }
    }

    record Able(Abilities abilities) implements Answer {}

    /// @param readings newest of each device, in the robot's order
    record Read(List<Reading> readings) implements Answer {
        public Read {
            readings = List.copyOf(readings);
        }
    }

    /// @param topics what was said so far, by topic
    record Counted(List<TopicTraffic> topics) implements Answer {
        public Counted {
            topics = List.copyOf(topics);
        }
    }

    /// @param communication by sender, listener and topic; nothing where it is not limited
    record Heard(List<Hearing> communication) implements Answer {
        public Heard {
            communication = List.copyOf(communication);
        }
    }

    record Seen(Inside agent) implements Answer {}

    /// @param why a sentence for people
    record Refused(String why) implements Answer {}
}
