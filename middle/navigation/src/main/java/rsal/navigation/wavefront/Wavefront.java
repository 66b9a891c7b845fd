package rsal.navigation.wavefront;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.navigation.wavefront.Wave.Guide;

/// Finds the cheapest way over a [CostMap]: a [Wave] spreads from the goal and leaves in each cell what the way to
/// the goal costs from there (the navigation function NF1 of J.-C. Latombe, Robot Motion Planning, 1991, with
/// costs). The way follows it downhill and is then pulled straight.
///
/// The wave of a goal is kept when it is asked for again: robots with the same goal share it, and to plan again
/// under way costs next to nothing. Around obstacles that are not on the map it searches from the start, and knows
/// from the kept wave what the way would cost without them (a heuristic for A* that is exact where no obstacle is
/// in the way): that takes the less the smaller the detour. Over a map that
/// has changed a little, waves are mended ([#over]). What is planned never depends on what was planned before.
///
/// May be asked on any thread, by several at once.
public final class Wavefront implements GlobalPlanner {
    private static final double NO_DEARER = 1.02;
    private static final int STRIDE = 4; // cells; how closely corners are looked for

    private final CostMap map;
    private final OccupancyGrid grid;
    private final int width;
    private final Waves waves;

    public Wavefront(CostMap map) {
        this(map, new Waves(map));
    }

    private Wavefront(CostMap map, Waves waves) {
        this.map = map;
        this.grid = map.grid();
        this.width = grid.width();
        this.waves = waves;
    }

    /// The same over a map that has changed. If that is not much, no more than one cell of [CostChanges#SHARE],
    /// it takes over the waves that are kept here and mends them when it is asked for their goals; the map may
    /// also have grown or shrunk. This one may still be asked, but keeps no waves any more.
    public Wavefront over(CostMap next) {
        return new Wavefront(next, waves.over(next));
    }

    /// For how many goals waves are kept.
    public int kept() {
        return waves.kept();
    }

    @Override
    public CostMap map() {
        return map;
    }

    /// Plans a way. A start too near to obstacles is left by the shortest way. A goal where the robot can't be, or to
    /// which nothing leads, is replaced by the nearest place to which something does, when that is no farther than
    /// `slack` [m] away. There is none to where ways get too long to count.
    public Plan plan(Point2d start, Point2d goal, double slack) {
        return plan(start, goal, slack, List.of());
    }

    private Plan find(Point2d start, Point2d goal, double slack) {
        var ends = Ends.of(map, start, goal, slack);
        if (ends instanceof Ends.None(var why)) {
            return why;
        }
        var cells = (Ends.Cells) ends;
        return waves.from(cells.goal(), wave -> toGoal(wave, cells, start, goal))
                .orElseGet(() -> waves.borrow(wave -> {
                    wave.start(cells.goal(), straightTo(cells.start()));
                    return toGoal(wave, cells, start, goal);
                }))
                .orElseGet(() ->
                        waves.borrow(wave -> fromStart(wave, cells, straightTo(cells.goal()), start, goal, slack)));
    }

    @Override
    public Plan plan(Point2d start, Point2d goal, double slack, List<Point2d> obstacles) {
        try {
            return obstacles.isEmpty() ? find(start, goal, slack) : around(obstacles, start, goal, slack);
        } catch (Wave.TooFar tooFar) {
            return new Plan.None(tooFar.why());
        }
    }

    private Plan around(List<Point2d> obstacles, Point2d start, Point2d goal, double slack) {
        return waves.borrow(wave -> {
            obstacles.forEach(obstacle -> map.around(obstacle, wave::block));
            var ends = Ends.of(map, start, goal, slack, wave::isOpen);
            if (ends instanceof Ends.None(var why)) {
                return why;
            }
            var cells = (Ends.Cells) ends;
            return waves.from(cells.goal(), kept -> {
                        kept.spread(cells.start());
                        int known = kept.known();
                        return fromStart(wave, cells, cell -> Math.min(kept.at(cell), known), start, goal, slack);
                    })
                    .orElseGet(() -> fromStart(wave, cells, straightTo(cells.goal()), start, goal, slack));
        });
    }

    /// What ways from a start to several goals cost [m], as those that [#plan] finds; +∞ where none does. One wave
    /// from the start, as far as it must spread; to a single goal it is hurried.
    public List<Double> costs(Point2d start, List<Point2d> goals, double slack) {
        return waves.borrow(wave -> {
            var costs = new ArrayList<Double>();
            boolean started = false;
            for (Point2d goal : goals) {
                if (!(Ends.of(map, start, goal, slack) instanceof Ends.Cells cells)) {
                    costs.add(Double.POSITIVE_INFINITY);
                    continue;
                }
                if (!started) {
                    wave.start(cells.start(), goals.size() == 1 ? straightTo(cells.goal()) : null);
                    started = true;
                }
                int end = nearestReached(wave, cells, goal, slack);
                costs.add(end < 0 ? Double.POSITIVE_INFINITY : cost(wave.at(end), start, cells.start()));
            }
            return List.copyOf(costs);
        });
    }

    /// The cell of a goal or else the nearest to which a way leads, −1 when there is none or the way is too long to
    /// count.
    private int nearestReached(Wave wave, Ends.Cells ends, Point2d goal, double slack) {
        try {
            return wave.spread(ends.goal())
                    ? ends.goal()
                    : Ends.nearest(grid, goal, slack, cell -> wave.isOpen(cell) && wave.at(cell) != Wave.UNREACHED);
        } catch (Wave.TooFar _) {
            return -1;
        }
    }

    /// [m]
    private double cost(int ofCells, Point2d start, int startCell) {
        return ofCells * grid.resolution() / CostMap.SIDE + start.distanceTo(grid.middle(startCell));
    }

    /// What the way to a goal costs from everywhere; +∞ also where it is too long to count; empty when the robot can be
    /// nowhere within `slack` [m] of it.
    public Optional<NavigationFunction> everywhere(Point2d goal, double slack) {
        return everywhere(List.of(goal), slack);
    }

    /// What the way to the nearest of several goals costs from everywhere; goals of which the robot can be nowhere
    /// within `slack` [m] have no part in it, and it is empty when none is left.
    public Optional<NavigationFunction> everywhere(List<Point2d> goals, double slack) {
        var wave = new Wave(map);
        boolean started = false;
        for (Point2d goal : goals) {
            int cell = grid.contains(grid.column(goal.x()), grid.row(goal.y()))
                    ? Ends.nearest(grid, goal, slack, map::isOpen)
                    : -1;
            if (cell >= 0) {
                wave.start(cell);
                started = true;
            }
        }
        if (!started) {
            return Optional.empty();
        }
        try {
            wave.spread(-1);
        } catch (Wave.TooFar _) {
            // what it has not reached stays out of reach
        }
        return Optional.of(new NavigationFunction(grid, wave));
    }

    /// @param wave from the goal
    private Optional<Plan> toGoal(Wave wave, Ends.Cells ends, Point2d start, Point2d goal) {
        return wave.spread(ends.start())
                ? Optional.of(path(wave, downhill(wave, ends.start()), wave.at(ends.start()), start, goal))
                : Optional.empty();
    }

    /// @param wave that has not started
    private Plan fromStart(Wave wave, Ends.Cells ends, Guide guide, Point2d start, Point2d goal, double slack) {
        wave.start(ends.start(), guide);
        int end = wave.spread(ends.goal())
                ? ends.goal()
                : Ends.nearest(grid, goal, slack, cell -> wave.isOpen(cell) && wave.at(cell) != Wave.UNREACHED);
        if (end < 0) {
            return Ends.apart(goal);
        }
        int[] cells = downhill(wave, end);
        for (int i = 0, j = cells.length - 1; i < j; i++, j--) {
            int swapped = cells[i];
            cells[i] = cells[j];
            cells[j] = swapped;
        }
        return path(wave, cells, wave.at(end), start, goal);
    }

    /// The octile distance, as if nothing were in the way.
    private Guide straightTo(int target) {
        int column = target % width;
        int row = target / width;
        return cell -> {
            int cellRow = cell / width;
            int dx = Math.abs(cell - cellRow * width - column);
            int dy = Math.abs(cellRow - row);
            return CostMap.SIDE * Math.max(dx, dy) + (CostMap.diagonal(CostMap.SIDE) - CostMap.SIDE) * Math.min(dx, dy);
        };
    }

    /// The cells from one to the wave's source.
    private static int[] downhill(Wave wave, int from) {
        var cells = new int[64];
        int count = 0;
        for (int cell = from; cell >= 0; cell = wave.towardsSource(cell)) {
            if (count == cells.length) {
                cells = Arrays.copyOf(cells, 2 * count);
            }
            cells[count++] = cell;
        }
        return Arrays.copyOf(cells, count);
    }

    private Plan.Found path(Wave wave, int[] cells, int cost, Point2d start, Point2d goal) {
        var points = new ArrayList<Point2d>();
        points.add(start);
        Point2d first = grid.middle(cells[0]);
        if (grid.cell(start) != cells[0]) {
            points.add(first); // out of the obstacle's reach first
        }
        pullStraight(cells, wave, points);
        if (grid.cell(goal) == cells[cells.length - 1]) {
            points.set(points.size() - 1, goal);
        }
        return new Plan.Found(
                new Path2d(points),
                cost(cost, start, cells[0]),
                points.getLast().distanceTo(goal));
    }

    /// Leaves out the cells that a straight line may skip without being dearer.
    private void pullStraight(int[] cells, Wave wave, List<Point2d> points) {
        int last = cells.length - 1;
        int anchor = 0;
        while (anchor < last) {
            int reached = anchor + 1;
            int next = Math.min(anchor + STRIDE, last);
            while (next > reached && isStraight(wave, cells[anchor], cells[next])) {
                reached = next;
                next = Math.min(next + STRIDE, last);
            }
            anchor = reached;
            points.add(grid.middle(cells[anchor]));
        }
        if (last == 0) {
            points.add(grid.middle(cells[0]));
        }
    }

    private boolean isStraight(Wave wave, int from, int to) {
        double along = Math.abs(wave.at(from) - wave.at(to)) * grid.resolution() / CostMap.SIDE;
        return map.straightCost(grid.middle(from), grid.middle(to), wave::isOpen) <= along * NO_DEARER;
    }
}
