package rsal.agents.patrol.strategy;

import java.util.Arrays;

/// For how long places had no visitor. Two means are in use, which differ: the mean over all places of the mean
/// gap between two visits, as most articles report; and the time average of the present idleness, which is half
/// of that when visits are regular.
public final class VisitGaps {
    private final double warmUp;
    private final double[] visited; // s, by place, until when somebody was there; 0 before any visit
    private final double[] sums; // of gaps, by place
    private final double[] squares; // of gaps, by place
    private final int[] counts; // of gaps, by place
    private double worst;

    /// @param warmUp time that does not count [s]; gaps count from a place's last visit before its end
    public VisitGaps(int places, double warmUp) {
        this.warmUp = warmUp;
        this.visited = new double[places];
        this.sums = new double[places];
        this.squares = new double[places];
        this.counts = new int[places];
    }

    /// Somebody is at a place.
    ///
    /// @param time not before that of the last visit [s]
    public void visit(int place, double time) {
        if (time >= warmUp && time > visited[place]) {
            count(place, time);
        }
        visited[place] = Math.max(visited[place], time);
    }

    /// Somebody is still at a place since the last visit: no new visit, but nobody has left it alone.
    ///
    /// @param time not before that of the last visit [s]
    public void stay(int place, double time) {
        visited[place] = Math.max(visited[place], time);
    }

    private void count(int place, double time) {
        double gap = time - visited[place];
        double counted = time - Math.max(visited[place], warmUp);
        double before = gap - counted; // idleness when counting began
        sums[place] += gap;
        counts[place]++;
        squares[place] += (gap * gap - before * before) / 2;
        worst = Math.max(worst, gap);
    }

    /// The mean over places of the mean time between two visits until now; of a place that had no visit since
    /// counting began, the time since its last one [s].
    public double meanGap(double now) {
        double sum = 0;
        for (int place = 0; place < sums.length; place++) {
            sum += meanGap(place, now);
        }
        return sum / sums.length;
    }

    private double meanGap(int place, double now) {
        return counts[place] == 0 ? now - visited[place] : sums[place] / counts[place];
    }

    /// The standard deviation over places of the mean time between two visits until now [s].
    public double deviation(double now) {
        double mean = meanGap(now);
        double sum = 0;
        for (int place = 0; place < sums.length; place++) {
            sum += Math.pow(meanGap(place, now) - mean, 2);
        }
        return Math.sqrt(sum / sums.length);
    }

    /// The time average of the mean over places of the time since the last visit [s].
    ///
    /// @param now after the warm-up [s]
    public double meanIdleness(double now) {
        double sum = 0;
        for (int place = 0; place < sums.length; place++) {
            double gap = now - visited[place];
            double before = Math.max(0, warmUp - visited[place]);
            sum += squares[place] + (gap * gap - before * before) / 2;
        }
        return sum / sums.length / (now - warmUp);
    }

    /// The longest time without a visit of a place until now [s].
    public double worst(double now) {
        double longest = worst;
        for (double last : visited) {
            longest = Math.max(longest, now - last);
        }
        return longest;
    }

    /// Visits that counted.
    public int visits() {
        return Arrays.stream(counts).sum();
    }
}
