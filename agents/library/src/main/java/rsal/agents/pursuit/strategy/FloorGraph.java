package rsal.agents.pursuit.strategy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.data.DistanceTransform;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Walls;

/// The part of a map that a robot can reach, as places a few decimeters apart with the lengths of the paths between
/// neighbors.
///
/// Each cell of the floor belongs to the place that is nearest by path: a Voronoi diagram in the grid, by one wave from
/// all places (Dijkstra with buckets; steps cost 10 and 14 tenths of a cell). Places whose cells touch are neighbors.
/// Paths along places are about a tenth longer than those in the grid, some by a third.
public final class FloorGraph {
    /// No place.
    public static final int NONE = -1;

    private static final double CELL = 0.1; // m, about
    private static final double SPACING = 0.7; // m between places, more where there would be too many
    private static final int MOST = 1200; // places, about
    private static final int STRAIGHT = 10;
    private static final int DIAGONAL = 14;
    private static final int BUCKETS = 16; // more than the longest step

    private final OccupancyGrid map;
    private final int stride; // cells of the map in one of the graph
    private final int width;
    private final int height;
    private final double unit; // m in a tenth of a cell's side
    private final int[] owners; // place by cell
    private final List<Point2d> places = new ArrayList<>();
    private int[][] neighbors = {};
    private double[][] lengths = {};
    private double[][] distances = {}; // from each place; empty until they are asked for
    private @Nullable BitSet[] views = {};
    private double sight; // m, of the views
    private final int[] queue;

    private FloorGraph(OccupancyGrid map, Point2d start, double clearance) {
        this.map = map;
        this.stride = Math.max(1, (int) Math.round(CELL / map.resolution()));
        this.width = Math.max(1, map.width() / stride);
        this.height = Math.max(1, map.height() / stride);
        this.unit = stride * map.resolution() / STRAIGHT;
        double[] clear = clearances(clearance);
        int first = nearestOpen(clear, start);
        this.owners = new int[width * height];
        Arrays.fill(owners, NONE);
        if (first == NONE) {
            this.queue = new int[1];
            return;
        }
        boolean[] floor = reachable(clear, first);
        List<Integer> seeds = seeds(clear, floor);
        connect(floor, seeds);
        this.distances = new double[places.size()][0];
        this.views = new BitSet[places.size()];
        this.queue = new int[places.size() + 1];
    }

    /// @param map what robots know of the floor
    /// @param mapFromStart somewhere on the part that counts
    /// @param clearance of paths to all that is not free [m]
    /// @return empty when nothing within a meter of the start has the clearance
    public static Optional<FloorGraph> of(OccupancyGrid map, Point2d mapFromStart, double clearance) {
        var graph = new FloorGraph(map, mapFromStart, clearance);
        return graph.size() == 0 ? Optional.empty() : Optional.of(graph);
    }

    /// How many places there are. They are numbered from 0.
    public int size() {
        return places.size();
    }

    public Point2d place(int place) {
        return places.get(place);
    }

    /// Shared: not to be written to.
    public int[] neighbors(int place) {
        return neighbors[place];
    }

    /// Lengths of the paths to the neighbors, in their order [m]; shared.
    public double[] lengths(int place) {
        return lengths[place];
    }

    /// The place to which a point of the map belongs, or the nearest one where no robot can be.
    public int nearest(Point2d point) {
        int column = column(point);
        int row = row(point);
        if (column >= 0 && column < width && row >= 0 && row < height && owners[row * width + column] != NONE) {
            return owners[row * width + column];
        }
        int best = 0;
        for (int place = 1; place < size(); place++) {
            if (places.get(place).distanceTo(point) < places.get(best).distanceTo(point)) {
                best = place;
            }
        }
        return best;
    }

    /// Lengths of the paths from a place to all [m]; shared, computed at the first request.
    public double[] distances(int from) {
        double[] known = distances[from];
        if (known.length > 0) {
            return known;
        }
        var computed = new double[size()];
        Arrays.fill(computed, Double.POSITIVE_INFINITY);
        computed[from] = 0;
        var waiting = new boolean[size()];
        int head = 0;
        int tail = 0;
        queue[tail++] = from;
        while (head != tail) {
            int place = queue[head];
            head = head + 1 == queue.length ? 0 : head + 1;
            waiting[place] = false;
            int[] around = neighbors[place];
            for (int i = 0; i < around.length; i++) {
                double length = computed[place] + lengths[place][i];
                if (length < computed[around[i]]) {
                    computed[around[i]] = length;
                    if (!waiting[around[i]]) {
                        waiting[around[i]] = true;
                        queue[tail] = around[i];
                        tail = tail + 1 == queue.length ? 0 : tail + 1;
                    }
                }
            }
        }
        distances[from] = computed;
        return computed;
    }

    /// The next place on the way from one to another; the same where it is there.
    public int next(int from, int to) {
        double[] left = distances(to);
        int best = from;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; from != to && i < neighbors[from].length; i++) {
            int around = neighbors[from][i];
            double length = lengths[from][i] + left[around];
            if (length < least) {
                least = length;
                best = around;
            }
        }
        return best;
    }

    /// The places that a robot at one sees; shared.
    ///
    /// @param range [m]; the same in all calls, or else all is computed again
    public BitSet seen(int from, double range) {
        if (range != sight) {
            Arrays.fill(views, null);
            sight = range;
        }
        BitSet known = views[from];
        if (known == null) {
            var walls = new Walls(map);
            known = new BitSet(size());
            for (int place = 0; place < size(); place++) {
                if (places.get(from).distanceTo(places.get(place)) <= range
                        && !walls.standBetween(places.get(from), places.get(place))) {
                    known.set(place);
                }
            }
            views[from] = known;
        }
        return known;
    }

    private int column(Point2d point) {
        return Math.floorDiv(map.column(point.x()), stride);
    }

    private int row(Point2d point) {
        return Math.floorDiv(map.row(point.y()), stride);
    }

    private Point2d middle(int cell) {
        return new Point2d(
                map.x(cell % width * stride + stride / 2), map.y(Math.floorDiv(cell, width) * stride + stride / 2));
    }

    /// Of the cells, to all that is not free [m]; 0 where that is less than a robot needs.
    private double[] clearances(double least) {
        var clear = new double[width * height];
        DistanceTransform.measure(
                map.width(), map.height(), cell -> map.cells()[cell] != OccupancyGrid.FREE, (row, squares) -> {
                    if (row % stride != stride / 2 || Math.floorDiv(row, stride) >= height) {
                        return;
                    }
                    for (int column = 0; column < width; column++) {
                        double distance = Math.sqrt(squares[column * stride + stride / 2]) * map.resolution();
                        clear[Math.floorDiv(row, stride) * width + column] = distance >= least ? distance : 0;
                    }
                });
        return clear;
    }

    /// Within a meter; or none.
    private int nearestOpen(double[] clear, Point2d start) {
        int best = NONE;
        double least = 1.0; // m
        for (int cell = 0; cell < clear.length; cell++) {
            double distance = clear[cell] > 0 ? middle(cell).distanceTo(start) : Double.POSITIVE_INFINITY;
            if (distance < least) {
                least = distance;
                best = cell;
            }
        }
        return best;
    }

    private boolean[] reachable(double[] clear, int first) {
        var floor = new boolean[clear.length];
        var found = new int[clear.length];
        int end = 0;
        found[end++] = first;
        floor[first] = true;
        for (int next = 0; next < end; next++) {
            for (int direction = 0; direction < 8; direction++) {
                int cell = step(found[next], direction);
                if (cell != NONE && clear[cell] > 0 && !floor[cell]) {
                    floor[cell] = true;
                    found[end++] = cell;
                }
            }
        }
        return floor;
    }

    /// The neighbor of a cell; even directions are straight.
    private int step(int cell, int direction) {
        int column = cell % width + DX[direction];
        int row = Math.floorDiv(cell, width) + DY[direction];
        return column < 0 || column >= width || row < 0 || row >= height ? NONE : row * width + column;
    }

    private static final int[] DX = {1, 1, 0, -1, -1, -1, 0, 1};
    private static final int[] DY = {0, 1, 1, 1, 0, -1, -1, -1};

    /// Cells of places: the one with the most room in each square, as far as no other place is near by path; then
    /// cells that are far from all of these.
    private List<Integer> seeds(double[] clear, boolean[] floor) {
        int area = 0;
        for (boolean cell : floor) {
            area += cell ? 1 : 0;
        }
        double side = STRAIGHT * unit; // m
        double spacing = Math.max(SPACING, Math.sqrt(area * side * side / MOST));
        int square = Math.max(1, (int) Math.round(spacing / side));
        var roomiest = new TreeMap<Integer, Integer>(); // cell by square
        for (int cell = 0; cell < floor.length; cell++) {
            if (floor[cell]) {
                int key =
                        Math.floorDiv(Math.floorDiv(cell, width), square) * width + Math.floorDiv(cell % width, square);
                Integer before = roomiest.get(key);
                if (before == null || clear[cell] > clear[before]) {
                    roomiest.put(key, cell);
                }
            }
        }
        var seeds = new ArrayList<Integer>();
        var near = new int[floor.length]; // how far the wave from a seed still goes there
        int reach = square * STRAIGHT;
        for (int cell : roomiest.values()) {
            cover(cell, reach, floor, near, seeds);
        }
        for (int cell = 0; cell < floor.length; cell++) {
            if (floor[cell]) {
                cover(cell, reach, floor, near, seeds);
            }
        }
        return seeds;
    }

    private void cover(int seed, int reach, boolean[] floor, int[] near, List<Integer> seeds) {
        if (near[seed] > 0) {
            return;
        }
        seeds.add(seed);
        near[seed] = reach;
        var cells = new ArrayList<Integer>(List.of(seed));
        for (int next = 0; next < cells.size(); next++) {
            int from = cells.get(next);
            for (int direction = 0; direction < 8; direction++) {
                int cell = step(from, direction);
                int left = near[from] - cost(direction);
                if (cell != NONE && floor[cell] && left > near[cell]) {
                    near[cell] = left;
                    cells.add(cell);
                }
            }
        }
    }

    private static int cost(int direction) {
        return direction % 2 == 0 ? STRAIGHT : DIAGONAL;
    }

    /// One wave from all places gives each cell to one; where waves meet, their places are neighbors.
    private void connect(boolean[] floor, List<Integer> seeds) {
        var far = new int[floor.length];
        Arrays.fill(far, Integer.MAX_VALUE);
        var buckets = new ArrayList<List<Integer>>();
        for (int i = 0; i < BUCKETS; i++) {
            buckets.add(new ArrayList<>());
        }
        for (int seed : seeds) {
            far[seed] = 0;
            owners[seed] = places.size();
            places.add(middle(seed));
            buckets.getFirst().add(seed);
        }
        int empty = 0;
        for (int distance = 0; empty < BUCKETS; distance++) {
            List<Integer> bucket = buckets.get(distance % BUCKETS);
            empty = bucket.isEmpty() ? empty + 1 : 0;
            for (int i = 0; i < bucket.size(); i++) {
                int from = bucket.get(i);
                for (int direction = 0; far[from] == distance && direction < 8; direction++) {
                    int cell = step(from, direction);
                    int cost = distance + cost(direction);
                    if (cell != NONE && floor[cell] && cost < far[cell]) {
                        far[cell] = cost;
                        owners[cell] = owners[from];
                        buckets.get(cost % BUCKETS).add(cell);
                    }
                }
            }
            bucket.clear();
        }
        var edges = new ArrayList<TreeMap<Integer, Double>>();
        places.forEach(_ -> edges.add(new TreeMap<>()));
        for (int cell = 0; cell < floor.length; cell++) {
            for (int direction = 0; floor[cell] && direction < 8; direction++) {
                int other = step(cell, direction);
                if (other != NONE && floor[other] && owners[other] != owners[cell]) {
                    edges.get(owners[cell])
                            .merge(owners[other], (far[cell] + far[other] + cost(direction)) * unit, Math::min);
                }
            }
        }
        neighbors = new int[places.size()][];
        lengths = new double[places.size()][];
        for (int place = 0; place < places.size(); place++) {
            neighbors[place] =
                    edges.get(place).keySet().stream().mapToInt(i -> i).toArray();
            lengths[place] =
                    edges.get(place).values().stream().mapToDouble(i -> i).toArray();
        }
    }
}
