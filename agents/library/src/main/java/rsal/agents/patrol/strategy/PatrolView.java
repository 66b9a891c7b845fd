package rsal.agents.patrol.strategy;

import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;

/// What a robot knows when it decides where to go next: the places, the living members of its team in the order
/// of their names, and what these have reported. Times are in s since this robot began to patrol; those of other
/// robots' clocks differ, and what was before is negative. Members and places have numbers from 0. A strategy
/// only reads it.
public final class PatrolView {
    /// Stands for a place that is not known.
    public static final int NONE = -1;

    private final PatrolGraph graph;
    private final RandomGenerator random;
    private final double[] visited; // by place
    private final boolean[] isKnown; // by place, whether a visit is known
    private double now;
    private int self;
    private int members = 1;
    private int team; // hash of the members' names
    private int[] at = {NONE};
    private int[] next = {NONE};
    private double[] arrival = {Double.POSITIVE_INFINITY};
    private int[][] notes = {{}};
    private double[] lengths;

    /// Places of which no visit is known count as visited at time 0.
    ///
    /// @param random of this robot's own
    public PatrolView(PatrolGraph graph, RandomGenerator random) {
        this.graph = graph;
        this.random = random;
        this.visited = new double[graph.size()];
        this.isKnown = new boolean[graph.size()];
        this.lengths = new double[graph.size()];
    }

    /// A new moment.
    ///
    /// @param time [s]
    /// @param lengthsFromHere of the paths from where the robot is to each place [m]; handed over
    public void set(double time, double[] lengthsFromHere) {
        now = time;
        lengths = lengthsFromHere;
    }

    /// Who is in the team now; nothing is known of them until [#report].
    ///
    /// @param number the robot's own, among the names of all members
    /// @param names of all members, in ascending order
    public void setTeam(int number, List<String> names) {
        int size = names.size();
        self = number;
        members = size;
        team = names.hashCode();
        at = filled(size);
        next = filled(size);
        arrival = new double[size];
        Arrays.fill(arrival, Double.POSITIVE_INFINITY);
        notes = new int[size][0];
    }

    private static int[] filled(int size) {
        var none = new int[size];
        Arrays.fill(none, NONE);
        return none;
    }

    /// What a member has reported last, the robot itself too.
    ///
    /// @param from the place at which it was last, or to which it is nearest
    /// @param to where it goes; [#NONE] while it goes nowhere
    /// @param when it will arrive there, as far as can be known [s]
    /// @param note of its strategy ([PatrolStrategy#note])
    public void report(int member, int from, int to, double when, int[] note) {
        at[member] = from;
        next[member] = to;
        arrival[member] = when;
        notes[member] = note;
    }

    /// A member was at a place; an older report changes nothing.
    ///
    /// @param time [s]; negative when that was before this robot began
    public void visit(int place, double time) {
        visited[place] = isKnown[place] ? Math.max(visited[place], time) : time;
        isKnown[place] = true;
    }

    public PatrolGraph graph() {
        return graph;
    }

    public double now() {
        return now;
    }

    /// Random numbers of this robot's own.
    public RandomGenerator random() {
        return random;
    }

    /// The robot's own number.
    public int self() {
        return self;
    }

    /// A number that is another one, almost surely, when other members are in the team.
    public int team() {
        return team;
    }

    /// How many robots patrol, with this one.
    public int members() {
        return members;
    }

    /// Where a member was last, or the place that it is nearest to; [#NONE] when not known.
    public int at(int member) {
        return at[member];
    }

    /// Where a member goes; [#NONE] when not known.
    public int next(int member) {
        return next[member];
    }

    /// When a member will be where it goes; +∞ when not known.
    public double arrival(int member) {
        return arrival[member];
    }

    /// What the strategy of a member last wanted the others to know; not to be written to.
    public int[] note(int member) {
        return notes[member];
    }

    /// When a member was last at a place, as far as is known.
    public double visited(int place) {
        return visited[place];
    }

    /// Time since a member was last at a place, as far as is known.
    public double idle(int place) {
        return now - visited[place];
    }

    /// Length of the path from the robot to a place [m]; +∞ when there is none.
    public double lengthTo(int place) {
        return lengths[place];
    }

    /// The place where the robot was last, or the one that it is nearest to.
    public int here() {
        return at[self] == NONE ? nearest() : at[self];
    }

    private int nearest() {
        int best = 0;
        for (int place = 1; place < lengths.length; place++) {
            best = lengths[place] < lengths[best] ? place : best;
        }
        return best;
    }

    /// How many other members go to a place.
    public int intended(int place) {
        int count = 0;
        for (int member = 0; member < members; member++) {
            count += member != self && next[member] == place ? 1 : 0;
        }
        return count;
    }

    /// The mean of all [#idle].
    public double meanIdle() {
        return now - Arrays.stream(visited).average().orElse(now);
    }

    /// The largest of all [#idle].
    public double mostIdle() {
        return now - Arrays.stream(visited).min().orElse(now);
    }
}
