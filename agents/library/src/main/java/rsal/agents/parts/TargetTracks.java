package rsal.agents.parts;

import java.time.Duration;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import rsal.agent.Blackboard;
import rsal.agent.message.PoseReport;
import rsal.data.Pose2d;

/// Where others were when they last said so, on their hearer's blackboard. One not heard of for a while is
/// forgotten.
public final class TargetTracks {
    private static final Duration MEMORY = Duration.ofSeconds(10);

    private final Blackboard blackboard;
    private final Duration memory;

    public TargetTracks(Blackboard blackboard) {
        this(blackboard, MEMORY);
    }

    /// @param memory for how long it knows where one was
    public TargetTracks(Blackboard blackboard, Duration memory) {
        this.blackboard = blackboard;
        this.memory = memory;
    }

    /// @return whether nothing was known of that robot
    public boolean note(PoseReport report) {
        boolean discovered = of(report.robot()).isEmpty();
        blackboard.write(PoseReport.TOPIC, report.robot(), report, memory);
        return discovered;
    }

    public void forget(String robot) {
        blackboard.erase(PoseReport.TOPIC, robot);
    }

    /// Where a robot is, in the map; empty when nothing is known of it.
    public Optional<Pose2d> of(String robot) {
        return report(robot).map(PoseReport::mapFromBase);
    }

    /// What a robot said last; empty when nothing is known of it.
    public Optional<PoseReport> report(String robot) {
        return blackboard.read(PoseReport.TOPIC, robot).map(Blackboard.Note::content);
    }

    /// Where they are, in the map, by id.
    public SortedMap<String, Pose2d> of(Predicate<PoseReport> wanted) {
        var poses = new TreeMap<String, Pose2d>();
        for (Blackboard.Note<PoseReport> note : blackboard.read(PoseReport.TOPIC)) {
            if (wanted.test(note.content())) {
                poses.put(note.content().robot(), note.content().mapFromBase());
            }
        }
        return poses;
    }
}
