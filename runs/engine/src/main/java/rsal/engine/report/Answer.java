package rsal.engine.report;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.agent.bdi.Mind;
import rsal.data.OccupancyGrid;
import rsal.settings.Suggestion;
import rsal.system.ExportedDevice;

/// What became of an operator's command.
public sealed interface Answer {
    record Done() implements Answer {}

    /// Something was added.
    ///
    /// @param name of it
    record Added(String name) implements Answer {}

    /// A robot was sent somewhere.
    ///
    /// @param goal its id, as [SentGoal] has it
    record Sent(int goal) implements Answer {}

    /// Motors are off.
    ///
    /// @param robots of how many
    record Stopped(int robots) implements Answer {}

    /// Motors are on again.
    ///
    /// @param on of how many robots
    /// @param off robots whose motors stay off, as somebody has switched them off one by one
    record Armed(int on, List<String> off) implements Answer {
        public Armed {
            off = List.copyOf(off);
        }
    }

    /// Robots are offered to others.
    record Bridged(List<ExportedDevice> offers) implements Answer {
        public Bridged {
            offers = List.copyOf(offers);
        }
    }

    record Able(Abilities abilities) implements Answer {}

    /// @param time since the run's start
    /// @param readings newest of each device, in the robot's order
    record Read(Duration time, List<Reading> readings) implements Answer {
        public Read {
            readings = List.copyOf(readings);
        }
    }

    /// @param byTopic what agents say all the time: all topics, with the newest of those that were wanted, oldest first
    record Repeated(Map<String, List<SentMessage>> byTopic) implements Answer {
        public Repeated {
            byTopic = Map.copyOf(byTopic);
        }
    }

    /// @param grid as [rsal.device.Navigator#costMap] has it; empty when the robot plans its ways by none
    record Costed(Optional<OccupancyGrid> grid) implements Answer {}

    /// @param topics what was said so far, by topic
    record Counted(List<TopicTraffic> topics) implements Answer {
        public Counted {
            topics = List.copyOf(topics);
        }
    }

    /// @param communication by sender, listener and topic; nothing where it is not limited
    record Heard(List<Reception> communication) implements Answer {
        public Heard {
            communication = List.copyOf(communication);
        }
    }

    record Seen(AgentInspection agent) implements Answer {}

    /// @param time since the run's start
    /// @param minds what those agents believe and want that show it, by name
    record Minded(Duration time, Map<String, Mind.View> minds) implements Answer {
        public Minded {
            minds = Map.copyOf(minds);
        }
    }

    /// @param links between robots that have agents; each pair once, those that hear nothing of each other left out
    /// @param ofChosen whether there are too many robots to tell more than those of one
    record Linked(List<Link> links, boolean ofChosen) implements Answer {
        /// Nobody hears anybody.
        public static final Linked NONE = new Linked(List.of(), false);

        public Linked {
            links = List.copyOf(links);
        }
    }

    /// @param why a sentence for people
    record Refused(String why) implements Answer {
        /// There is no agent of this name.
        ///
        /// @param known names of those that there are
        public static Refused noAgent(String name, Collection<String> known) {
            String remedy = Suggestion.among(name, known.stream().sorted().toList());
            return new Refused("There is no agent '%s'. %s".formatted(name, remedy));
        }
    }
}
