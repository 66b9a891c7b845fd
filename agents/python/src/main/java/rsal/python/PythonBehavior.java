package rsal.python;

import java.time.Duration;
import java.time.Instant;
import rsal.agent.AgentContext;
import rsal.behavior.Behavior;
import rsal.behavior.Percept;
import rsal.behavior.Surroundings;
import rsal.data.Odometry;
import rsal.data.Twist2d;
import rsal.python.PythonRequests.Heard;

/// A behavior whose code is in Python. The pilot never waits for it: Python gets what the robot senses, and the pilot
/// takes the newest velocity that Python has answered, which follows from what was sensed one update (0.1 s) before.
/// Without an answer for 0.5 s the behavior wants to stand still.
final class PythonBehavior implements Behavior {
    private static final Duration STALE = Duration.ofMillis(500);

    private final AgentContext self;
    private final Heard heard;
    private final int number;
    private volatile Answer newest = new Answer(Twist2d.STOP, Instant.MIN);

    private record Answer(Twist2d velocity, Instant at) {}

    /// What Python gets.
    ///
    /// @param ranges as [Surroundings] has them [m]
    private record Sensed(Instant time, Odometry odometry, float[] ranges) {}

    /// @param number under which Python hears what is sensed
    PythonBehavior(AgentContext self, Heard heard, int number) {
        this.self = self;
        this.heard = heard;
        this.number = number;
    }

    /// What Python wants. On the agent's lane.
    void answer(Twist2d velocity) {
        newest = new Answer(velocity, self.scheduler().instant());
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        float[] ranges = new float[Surroundings.SECTORS];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = percept.surroundings().range(i);
        }
        var sensed = new Sensed(percept.time(), percept.odometry(), ranges);
        self.scheduler().execute(() -> heard.hear(number, true, sensed));
        Answer answer = newest;
        return answer.at.isBefore(percept.time().minus(STALE)) ? Twist2d.STOP : answer.velocity;
    }
}
