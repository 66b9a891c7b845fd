package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/// Closed tours that together visit all places, and how many robots share each of them, evenly spaced. What it
/// promises is for ideal robots that do not disturb each other.
public final class PatrolPlan {
    private final PatrolGraph graph;
    private final List<int[]> tours;
    private final int[] robots; // by tour
    private final int[] tourOf; // by place
    private final double[] rounds; // s, by tour

    /// @param tours each place in one of them; handed over
    /// @param robots how many robots share each tour, at least 1; handed over
    PatrolPlan(PatrolGraph graph, List<int[]> tours, int[] robots) {
        this(
                graph,
                tours,
                robots,
                tours.stream().mapToDouble(tour -> Tours.time(graph, tour)).toArray());
    }

    private PatrolPlan(PatrolGraph graph, List<int[]> tours, int[] robots, double[] rounds) {
        this.graph = graph;
        this.tours = List.copyOf(tours);
        this.robots = robots;
        this.rounds = rounds;
        this.tourOf = new int[graph.size()];
        for (int tour = 0; tour < tours.size(); tour++) {
            for (int place : tours.get(tour)) {
                tourOf[place] = tour;
            }
        }
    }

    /// The same with two other tours; handed over.
    PatrolPlan with(int first, int[] its, int second, int[] others) {
        var changed = new ArrayList<>(tours);
        changed.set(first, its);
        changed.set(second, others);
        double[] times = rounds.clone();
        times[first] = Tours.time(graph, its);
        times[second] = Tours.time(graph, others);
        return new PatrolPlan(graph, changed, robots, times);
    }

    /// A number that is another one, almost surely, for another plan.
    int key() {
        int key = Arrays.hashCode(robots);
        for (int[] tour : tours) {
            key = 31 * key + Arrays.hashCode(tour);
        }
        return key;
    }

    /// How many tours there are.
    public int size() {
        return tours.size();
    }

    /// The places of a tour in their order.
    public int[] tour(int number) {
        return tours.get(number).clone();
    }

    /// How many robots share a tour.
    public int robots(int tour) {
        return robots[tour];
    }

    int[] places(int tour) {
        return tours.get(tour);
    }

    /// The tour that a place belongs to.
    int tourOf(int place) {
        return tourOf[place];
    }

    /// Time between two visits of each place of a tour [s].
    public double gap(int tour) {
        return rounds[tour] / robots[tour];
    }

    /// The longest time between two visits of a place [s].
    public double worst() {
        double worst = 0;
        for (int tour = 0; tour < tours.size(); tour++) {
            worst = Math.max(worst, gap(tour));
        }
        return worst;
    }

    /// The mean over all places of the time between two visits [s].
    public double meanGap() {
        double sum = 0;
        for (int tour = 0; tour < tours.size(); tour++) {
            sum += tours.get(tour).length * gap(tour);
        }
        return sum / graph.size();
    }

    /// All members of a team as places of the tours that they begin at, evenly spaced on each tour.
    ///
    /// @return for each member a tour and a position on it
    List<int[]> slots() {
        var slots = new ArrayList<int[]>();
        for (int tour = 0; tour < tours.size(); tour++) {
            int[] places = tours.get(tour);
            double round = rounds[tour];
            for (int robot = 0; robot < robots[tour]; robot++) {
                double ahead = round * robot / robots[tour];
                int position = 0;
                double done = 0;
                while (position < places.length - 1 && done < ahead - 1e-9) {
                    done += graph.time(places[position], places[position + 1]);
                    position++;
                }
                slots.add(new int[] {tour, position});
            }
        }
        return slots;
    }

    /// One tour over all places that all robots share (J. Elmaliach et al., "Multi-robot area patrol under
    /// frequency constraints", 2009).
    static PatrolPlan cycle(PatrolGraph graph, int members) {
        return cycle(graph, members, Tours.over(graph, all(graph)));
    }

    /// @param tour over all places
    static PatrolPlan cycle(PatrolGraph graph, int members, int[] tour) {
        return new PatrolPlan(graph, List.of(tour), new int[] {members});
    }

    static int[] all(PatrolGraph graph) {
        var all = new int[graph.size()];
        Arrays.setAll(all, place -> place);
        return all;
    }

    /// A tour for each robot over the places nearest to one of as many places that lie far from each other:
    /// after the graph-Voronoi cells of AHPA (2024). Differs in that cells grow from the places farthest from
    /// those before, not from where robots began, and in its tours, which are not Christofides's.
    static PatrolPlan voronoi(PatrolGraph graph, int members) {
        int cells = Math.min(members, graph.size());
        var origins = new int[cells];
        var cellOf = new int[graph.size()];
        Arrays.fill(cellOf, PatrolView.NONE);
        cellOf[0] = 0;
        for (int cell = 1; cell < cells; cell++) {
            double farthest = -1;
            for (int place = 0; place < graph.size(); place++) {
                double nearest = Double.POSITIVE_INFINITY;
                for (int before = 0; before < cell; before++) {
                    nearest = Math.min(nearest, graph.length(origins[before], place));
                }
                if (cellOf[place] == PatrolView.NONE && nearest > farthest) {
                    farthest = nearest;
                    origins[cell] = place;
                }
            }
            cellOf[origins[cell]] = cell;
        }
        var places = new ArrayList<List<Integer>>();
        for (int cell = 0; cell < cells; cell++) {
            places.add(new ArrayList<>());
        }
        for (int place = 0; place < graph.size(); place++) {
            int nearest = Math.max(0, cellOf[place]); // an origin is in its own cell
            for (int cell = 1; cell < cells; cell++) {
                if (graph.length(origins[cell], place) < graph.length(origins[nearest], place)) {
                    nearest = cell;
                }
            }
            places.get(nearest).add(place);
        }
        List<int[]> tours = places.stream()
                .map(cell -> Tours.over(
                        graph, cell.stream().mapToInt(Integer::intValue).toArray()))
                .toList();
        return new PatrolPlan(graph, tours, shares(cells, members));
    }

    /// As many robots for each tour as can be, one more for the first ones.
    static int[] shares(int tours, int members) {
        var shares = new int[tours];
        Arrays.setAll(shares, tour -> members / tours + (tour < members % tours ? 1 : 0));
        return shares;
    }
}
