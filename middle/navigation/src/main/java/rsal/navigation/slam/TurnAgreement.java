package rsal.navigation.slam;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/// Whether the robot turned as its wheels say: a scan tells, too. A laser that is mounted upside down, or whose
/// readings are in the wrong order, sees a mirrored world in which it turns the other way, and fits into it as well as
/// into the real one: nothing else tells that the map is mirrored.
///
/// @param count of steps, from one scan that was kept to the next, at which the wheels turned and a scan was matched
/// @param opposed of them, at which the scan turned the other way
public record TurnAgreement(int count, int opposed) {
    private static final double LEAST = 0.1; // rad; smaller turns may be the wheels' error
    private static final int FEWEST = 8; // that all are opposed by chance is once in 256 times
    private static final double MOST = 0.75; // of them, to be reversed

    /// Whether most turns are opposed, of so many that it can't be chance (the sign test: W. Dixon, A. Mood, The
    /// Statistical Sign Test, Journal of the American Statistical Association 41, 1946). In maps of logs that are
    /// right (seven with usual noise of wheels, four of them with twice that, too) one of 20 is at most.
    public boolean isReversed() {
        return count >= FEWEST && opposed > MOST * count;
    }

    static TurnAgreement of(List<Relation> relations) {
        Map<Integer, Relation> wheels = new HashMap<>();
        for (Relation relation : relations) {
            if (relation.source() == Relation.Source.ODOMETRY) {
                wheels.put(relation.to(), relation);
            }
        }
        int count = 0;
        int opposed = 0;
        for (Relation relation : relations) {
            Relation reported = wheels.get(relation.to());
            if (relation.source() == Relation.Source.SCANS && reported != null) {
                double turn = reported.fromFromTo().theta();
                if (Math.abs(turn) >= LEAST) {
                    count++;
                    opposed += turn * relation.fromFromTo().theta() < 0 ? 1 : 0;
                }
            }
        }
        return new TurnAgreement(count, opposed);
    }
}
