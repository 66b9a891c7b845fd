package rsal.engine;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.engine.event.ChattyTopics;
import rsal.engine.report.Answer;
import rsal.robot.Robot;
import rsal.settings.Suggestion;

/// What devices had told last and agents had in mind when a run ended, for those who look at it afterwards.
record FinalState(
        Map<String, Answer> readings,
        Map<String, Answer> agents,
        Answer topics,
        Answer communication,
        ChattyTopics routine) {
    static FinalState at(RunAssembly stage, Iterable<Robot> robots, List<String> agents, Duration time, long now) {
        var readings = new HashMap<String, Answer>();
        robots.forEach(robot -> readings.put(robot.id(), stage.readings(robot.id(), time)));
        var minds = new HashMap<String, Answer>();
        for (String agent : agents) {
            try {
                minds.put(agent, stage.inside(agent, now));
            } catch (IllegalArgumentException e) { // it can't tell
                minds.put(agent, new Answer.Refused(String.valueOf(e.getMessage())));
            }
        }
        return new FinalState(
                readings,
                minds,
                new Answer.Counted(stage.topics()),
                new Answer.Heard(stage.hearings()),
                stage.routine());
    }

    Answer readings(String robot) {
        return known(readings, robot);
    }

    Answer agent(String name) {
        return known(agents, name);
    }

    private static Answer known(Map<String, Answer> all, String name) {
        return Optional.ofNullable(all.get(name))
                .orElseGet(() -> new Answer.Refused("The run is over, and had no '%s'. %s"
                        .formatted(
                                name,
                                Suggestion.among(
                                        name, all.keySet().stream().sorted().toList()))));
    }
}
