package rsal.navigation.carmen;

import java.time.Instant;
import rsal.navigation.carmen.LineFields.Misread;

/// Finds out when messages were sent, from the two times that stand at their ends.
final class Clock {
    static final int MOTION = 0;
    static final int SCAN = 1;
    private static final double LATEST = 1e11; // s; thousands of years

    private enum Source {
        NONE,
        SENDER,
        LOGGER
    }

    private Source source = Source.NONE;
    private final double[] last = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY}; // by kind
    private final double[] lastBack = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    private final int[] back = new int[2];

    /// Reads `time host loggerTime`, the end of each message.
    ///
    /// @param kind of the message
    Instant read(LineFields fields, int kind) throws Misread {
        double sender = fields.finite("time");
        fields.word();
        double logger = fields.finite("logger's time");
        if (fields.hasNext()) { // before the clock believes what may be no time at all
            throw new Misread(
                    "a count that is not that of its readings",
                    "Behind its time stands '%s'.".formatted(LineFields.brief(fields.rest())));
        }
        if (source == Source.NONE && (sender > 0 || logger > 0)) {
            source = sender > 0 ? Source.SENDER : Source.LOGGER;
        }
        double reported = source == Source.SENDER ? sender : logger;
        if (!(Math.abs(reported) <= LATEST)) {
            throw new Misread("an impossible time", "Its time is '%s' s.".formatted(reported));
        }
        double time = reported > 0 ? inOrder(reported, kind) : Math.max(0, last[kind]);
        last[kind] = time;
        return Instant.ofEpochSecond((long) time, (long) ((time - (long) time) * 1e9));
    }

    private double inOrder(double reported, int kind) throws Misread {
        if (reported >= last[kind]) {
            back[kind] = 0;
            return reported;
        }
        back[kind] = reported >= lastBack[kind] ? back[kind] + 1 : 1;
        lastBack[kind] = reported;
        if (back[kind] <= CarmenReader.RESTART) {
            throw new Misread(
                    "back in time",
                    "Its time is '%s' s, that of the one before '%s' s.".formatted(reported, last[kind]));
        }
        back[kind] = 0;
        lastBack[kind] = Double.NEGATIVE_INFINITY;
        return reported;
    }
}
