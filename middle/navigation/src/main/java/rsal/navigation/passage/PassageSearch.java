package rsal.navigation.passage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;

/// Finds the passages of a map, as [Passages] says.
final class PassageSearch {
    /// What of a path between a passage and a wide place belongs to neither [m]: a robot with its middle here is out of
    /// the door, though no other can pass it yet.
    private static final double MOUTH = 0.25;

    private final CostMap open;
    private final DistanceField toNotFree;
    private final OccupancyGrid grid;
    private final double body;
    private final double half; // of the width in which two robots pass [m]
    private final boolean[] wide;
    private final int width;

    /// @param body radius of the circle that a robot turns in [m]
    /// @param half of the width from which on two can pass [m]
    PassageSearch(CostMap open, DistanceField toNotFree, double body, double half) {
        this.open = open;
        this.toNotFree = toNotFree;
        this.grid = open.grid();
        this.body = body;
        this.half = half;
        this.width = grid.width();
        this.wide = new boolean[grid.cells().length];
        for (int cell = 0; cell < wide.length; cell++) {
            wide[cell] = open.isOpen(cell) && toNotFree.at(cell) - grid.resolution() / 2 >= half;
        }
        dropSmall();
    }

    /// Places in which a robot that has left a passage could not stand free of it do not count as wide.
    private void dropSmall() {
        var label = new int[wide.length];
        Arrays.fill(label, -1);
        for (int start = 0; start < wide.length; start++) {
            if (wide[start] && label[start] < 0) {
                IntList part = part(start, wide, label, start);
                if (extent(part) < 2 * body) {
                    for (int i = 0; i < part.size(); i++) {
                        wide[part.get(i)] = false;
                    }
                }
            }
        }
    }

    /// The longer side of the box around cells [m].
    private double extent(IntList cells) {
        int left = Integer.MAX_VALUE;
        int right = 0;
        int bottom = Integer.MAX_VALUE;
        int top = 0;
        for (int i = 0; i < cells.size(); i++) {
            int column = cells.get(i) % width;
            int row = cells.get(i) / width;
            left = Math.min(left, column);
            right = Math.max(right, column);
            bottom = Math.min(bottom, row);
            top = Math.max(top, row);
        }
        return grid.resolution() * (1 + Math.max(right - left, top - bottom));
    }

    /// The cells that are connected to one, also across corners.
    private IntList part(int start, boolean[] in, int[] label, int name) {
        var part = new IntList();
        part.add(start);
        label[start] = name;
        for (int i = 0; i < part.size(); i++) {
            int cell = part.get(i);
            for (int row = -width; row <= width; row += width) {
                for (int next = cell + row - 1; next <= cell + row + 1; next++) {
                    if (next >= 0 && next < in.length && in[next] && label[next] < 0) {
                        label[next] = name;
                        part.add(next);
                    }
                }
            }
        }
        return part;
    }

    Passages find() {
        var flood = new WideFlood(width, grid.height(), open::isOpen, cell -> wide[cell]);
        boolean[] narrow = narrow(flood);
        var indices = new int[wide.length];
        Arrays.fill(indices, -1);
        var parts = new ArrayList<IntList>();
        for (int start = 0; start < narrow.length; start++) {
            if (narrow[start] && indices[start] < 0) {
                parts.add(part(start, narrow, indices, parts.size()));
            }
        }
        var places = new WaitingPlaces(open, toNotFree, body);
        var all = new ArrayList<Passage>();
        for (IntList part : parts) {
            List<Gate> gates = gates(part, flood, indices, places);
            var cells = new ArrayList<Point2d>();
            for (int i = 0; i < part.size(); i++) {
                cells.add(grid.middle(part.get(i)));
            }
            all.add(new Passage(all.size(), middle(part, flood), gates, cells));
        }
        return Passages.of(grid, indices, all);
    }

    /// Fronts, what is deeper than corners, and the paths from there to wide cells.
    private boolean[] narrow(WideFlood flood) {
        var narrow = new boolean[wide.length];
        double corner = Math.sqrt(2) * half + 2 * grid.resolution(); // m; no corner of a room is as deep
        int mouth = (int) (WideFlood.STEP * MOUTH / grid.resolution());
        int deep = (int) (WideFlood.STEP * corner / grid.resolution());
        for (int cell = 0; cell < wide.length; cell++) {
            if (!wide[cell] && flood.isReached(cell) && (flood.distance(cell) > deep || isFront(cell, flood))) {
                for (int on = cell; flood.distance(on) > mouth && !narrow[on]; on = flood.parent(on)) {
                    narrow[on] = true;
                }
            }
        }
        return narrow;
    }

    /// Whether the waves that come here and to a neighbor are from wide cells far apart.
    private boolean isFront(int cell, WideFlood flood) {
        for (int side = 0; side < 8; side++) {
            int next = flood.neighbor(cell, side);
            if (flood.isReached(next) && apart(flood.source(cell), flood.source(next)) > half) {
                return true;
            }
        }
        return false;
    }

    private double apart(int one, int other) {
        return grid.resolution() * Math.hypot(one % width - other % width, one / width - other / width);
    }

    /// The deepest cell: all robots of one size find the same.
    private Point2d middle(IntList part, WideFlood flood) {
        int deepest = part.get(0);
        for (int i = 1; i < part.size(); i++) {
            int cell = part.get(i);
            int more = flood.distance(cell) - flood.distance(deepest);
            if (more > 0 || (more == 0 && cell < deepest)) {
                deepest = cell;
            }
        }
        return grid.middle(deepest);
    }

    /// Wide cells beside a passage, those near each other together.
    private List<Gate> gates(IntList part, WideFlood flood, int[] indices, WaitingPlaces places) {
        var mouths = new ArrayList<IntList>();
        for (int i = 0; i < part.size(); i++) {
            int parent = flood.parent(part.get(i));
            if (indices[parent] < 0) {
                join(mouths, flood.source(parent));
            }
        }
        return mouths.stream().map(mouth -> gate(mouth, part, indices, places)).toList();
    }

    private void join(List<IntList> mouths, int cell) {
        var joined = new IntList();
        joined.add(cell);
        mouths.removeIf(mouth -> {
            boolean near = false;
            for (int i = 0; i < mouth.size() && !near; i++) {
                near = apart(mouth.get(i), cell) <= half / 2;
            }
            if (near) {
                for (int i = 0; i < mouth.size(); i++) {
                    joined.add(mouth.get(i));
                }
            }
            return near;
        });
        mouths.add(joined);
    }

    private Gate gate(IntList mouth, IntList part, int[] indices, WaitingPlaces places) {
        Point2d mean = mean(mouth);
        int gate = mouth.get(0);
        for (int i = 1; i < mouth.size(); i++) {
            if (grid.middle(mouth.get(i)).distanceTo(mean) < grid.middle(gate).distanceTo(mean)) {
                gate = mouth.get(i);
            }
        }
        Point2d mapFromGate = grid.middle(gate);
        var near = new IntList();
        for (int i = 0; i < part.size(); i++) {
            if (grid.middle(part.get(i)).distanceTo(mapFromGate) < half) {
                near.add(part.get(i));
            }
        }
        Point2d inside = mean(near.size() == 0 ? part : near);
        double heading = Math.atan2(mapFromGate.y() - inside.y(), mapFromGate.x() - inside.x());
        return new Gate(mapFromGate, heading, places.near(gate, heading, indices));
    }

    private Point2d mean(IntList cells) {
        double x = 0;
        double y = 0;
        for (int i = 0; i < cells.size(); i++) {
            x += grid.x(cells.get(i) % width);
            y += grid.y(cells.get(i) / width);
        }
        return new Point2d(x / cells.size(), y / cells.size());
    }

    /// What is wide around gates where nobody can wait becomes part of their passages, so that these grow
    /// to the next place with room: a chain. Where robots would have no wide place left, all stays as it
    /// was: without one there are no passages.
    ///
    /// @return whether that makes any cell narrow
    boolean closeGatesWithoutRoom(Passages found) {
        boolean[] before = wide.clone();
        boolean closed = false;
        for (Passage passage : found.all()) {
            for (Gate gate : passage.gates()) {
                if (gate.waitingPlaces().isEmpty()) {
                    close(gate.mapFromGate());
                    closed = true;
                }
            }
        }
        if (closed) {
            dropSmall();
            keepLast(before);
        }
        return !Arrays.equals(before, wide);
    }

    /// In each connected part of where robots can be that has no wide cell left, makes those wide that were
    /// before.
    private void keepLast(boolean[] before) {
        var open = new boolean[wide.length];
        for (int cell = 0; cell < open.length; cell++) {
            open[cell] = this.open.isOpen(cell);
        }
        var label = new int[wide.length];
        Arrays.fill(label, -1);
        for (int start = 0; start < open.length; start++) {
            if (open[start] && label[start] < 0) {
                IntList part = part(start, open, label, start);
                boolean isLost = true;
                for (int i = 0; i < part.size() && isLost; i++) {
                    isLost = !wide[part.get(i)];
                }
                for (int i = 0; i < part.size() && isLost; i++) {
                    wide[part.get(i)] = before[part.get(i)];
                }
            }
        }
    }

    private void close(Point2d around) {
        int reach = (int) Math.ceil(2 * body / grid.resolution());
        int column = grid.column(around.x());
        int row = grid.row(around.y());
        for (int r = row - reach; r <= row + reach; r++) {
            for (int c = column - reach; c <= column + reach; c++) {
                if (grid.contains(c, r) && Math.hypot(c - column, r - row) <= reach) {
                    wide[r * width + c] = false;
                }
            }
        }
    }
}
