package rsal.server.history;

import java.io.IOException;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import rsal.engine.report.Answer;
import rsal.recording.Playback;
import rsal.recording.Playback.Reported;
import rsal.server.description.PlottableNumbers;
import rsal.server.message.Messages.PastNumbers;

/// What devices of a recorded run's robots have told, as [NumberHistory] has it of a live one: of robots that somebody
/// asked about, of each from the beginning to the end. All methods may be called from any thread.
public final class RecordedNumbers {
    private static final int MOST_SAMPLES = 6000; // of a robot
    private static final Duration PIECE = Duration.ofSeconds(10); // between them viewers are shown what they look at

    private final Playback playback;
    private final Set<String> robots;
    private final NumberHistory history = new NumberHistory();
    private final Set<String> read = new HashSet<>();

    /// @param robots that were ever there
    public RecordedNumbers(Playback playback, Set<String> robots) {
        this.playback = playback;
        this.robots = Set.copyOf(robots);
    }

    /// What a number of a device was; nothing when nobody knows. The first time that takes as long as reading through
    /// the recording.
    public synchronized PastNumbers past(String robot, String device, String number) throws IOException {
        if (robots.contains(robot) && read.add(robot)) {
            read(robot);
        }
        return history.past(robot, device, number);
    }

    private void read(String robot) throws IOException {
        Duration until = playback.until();
        Duration spacing = until.minus(playback.from()).dividedBy(MOST_SAMPLES);
        for (Duration from = playback.from().minusNanos(1); from.compareTo(until) < 0; from = from.plus(PIECE)) {
            Duration end = from.plus(PIECE);
            for (Reported reported : playback.reported(robot, from, end.compareTo(until) < 0 ? end : until, spacing)) {
                history.keep(robot, PlottableNumbers.of(new Answer.Read(reported.time(), reported.readings())));
            }
        }
    }
}
