package rsal.agents.patrol.strategy;

import java.util.Arrays;

/// For how long places had no visitor. Two means are in use, which differ: the mean over all places of the mean
/// gap between two visits, as most articles report; and the time average of the present idleness, which is half
/// of that when visits are regular.
public final class VisitGaps {
    private final double warmUp;
    private final double[] visited; // s, by place; the warm-up's end before any visit
    private final double[] sums; // of gaps, by place
    private final double[] squares; // of gaps, by place
    private final int[] counts; // of gaps, by place
    private double worst;
    private double end;

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

    private void count(int place, double time) {
        double gap = time - visited[place];
        double counted = time - Math.max(visited[place], warmUp);
        double before = gap - counted; // idleness when counting began
        sums[place] += gap;
        counts[place]++;
        squares[place] += (gap * gap - before * before) / 2;
        worst = Math.max(worst, gap);
    }

    /// No more visits.
    ///
    /// @param time after the warm-up [s]
    public void end(double time) {
        end = time;
        for (int place = 0; place < visited.length; place++) {
            double gap = time - visited[place];
            double before = Math.max(0, warmUp - visited[place]);
            squares[place] += (gap * gap - before * before) / 2;
            worst = Math.max(worst, gap);
            if (counts[place] == 0) {
                sums[place] = gap;
                counts[place] = 1;
            }
        }
    }

    /// The mean over places of the mean time between two visits [s].
    public double meanGap() {
        double sum = 0;
        for (int place = 0; place < sums.length; place++) {
            sum += sums[place] / counts[place];
        }
        return sum / sums.length;
    }

    /// The time average of the mean over places of the time since the last visit [s].
    public double meanIdleness() {
        return Arrays.stream(squares).sum() / squares.length / (end - warmUp);
    }

    /// The longest time without a visit of a place [s].
    public double worst() {
        return worst;
    }

    /// Visits that counted, but for the first of places with none.
    public int visits() {
        return Arrays.stream(counts).sum();
    }

    /// The standard deviation over places of the mean time between two visits [s].
    public double deviation() {
        double mean = meanGap();
        double sum = 0;
        for (int place = 0; place < sums.length; place++) {
            sum += Math.pow(sums[place] / counts[place] - mean, 2);
        }
        return Math.sqrt(sum / sums.length);
    }
}
