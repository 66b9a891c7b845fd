package rsal.agents.formation;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Interest;
import rsal.agent.Message;
import rsal.agent.message.PoseReport;
import rsal.data.Pose2d;

/// Which robots are near, as they say themselves. Of the others nothing is kept, so that a thousand robots need not
/// remember a million places; one that is not heard of any more is forgotten.
final class Neighbors {
    private static final Duration MEMORY = Duration.ofSeconds(10);
    private static final Duration LOOK = Duration.ofSeconds(1);

    private final AgentContext self;
    private final double near;
    private final Map<String, Instant> heard = new HashMap<>(); // when last, by robot
    private @Nullable Pose2d mapFromBase;
    private int shown = -1;

    /// @param near up to which distance a robot is a neighbor [m]
    Neighbors(AgentContext self, double near) {
        this.self = self;
        this.near = near;
    }

    void begin(Interest<PoseReport> interest) {
        self.subscribe(PoseReport.TOPIC, interest, this::hear);
        self.scheduler().every(LOOK, this::show);
    }

    /// Its own robot is here now.
    void isAt(Pose2d mapFromOwn) {
        mapFromBase = mapFromOwn;
    }

    private void hear(Message<PoseReport> message) {
        Pose2d here = mapFromBase;
        PoseReport report = message.content();
        if (here != null && here.distanceTo(report.mapFromBase()) <= near) {
            heard.put(report.robot(), message.time());
        } else if (!heard.isEmpty()) {
            heard.remove(report.robot());
        }
    }

    private void show() {
        Instant oldest = self.scheduler().instant().minus(MEMORY);
        heard.values().removeIf(time -> time.isBefore(oldest));
        if (heard.size() != shown) {
            shown = heard.size();
            self.show("neighbors", String.valueOf(shown));
        }
    }
}
