package rsal.ros2.tf;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTransform.Quaternion;

/// What [TransformBuffer] answers, found the slow way: all transforms in a list, frames as a graph that is
/// searched, and rotations as matrices which turn about an axis. Without limits, and for trees without loops.
final class ObviousTransforms {
    private final long history; // ns
    private final List<StampedTransform> moving = new ArrayList<>();
    private final Map<String, StampedTransform> fixed = new HashMap<>();

    ObviousTransforms(long history) {
        this.history = history;
    }

    void add(StampedTransform added) {
        fixed.remove(added.child());
        long newest = of(added.child()).mapToLong(StampedTransform::stamp).max().orElse(added.stamp());
        boolean wentBack = added.stamp() < newest - history;
        moving.removeIf(each -> each.child().equals(added.child()) && (wentBack || each.stamp() == added.stamp()));
        moving.add(added);
        long last = wentBack ? added.stamp() : Math.max(newest, added.stamp());
        moving.removeIf(each -> each.child().equals(added.child()) && each.stamp() < last - history);
    }

    void addFixed(StampedTransform added) {
        moving.removeIf(each -> each.child().equals(added.child()));
        fixed.put(added.child(), added);
    }

    private java.util.stream.Stream<StampedTransform> of(String child) {
        return moving.stream().filter(each -> each.child().equals(child));
    }

    /// Where a frame is in a parent.
    ///
    /// @param matrix 4 × 4, row by row
    private record Edge(String parent, String child, double[] matrix) {}

    private List<Edge> edges(long stamp) {
        var edges = new ArrayList<Edge>();
        fixed.values().forEach(each -> edges.add(edge(each)));
        Set<String> children = moving.stream().map(StampedTransform::child).collect(Collectors.toSet());
        for (String child : children) {
            Comparator<StampedTransform> byStamp = Comparator.comparingLong(StampedTransform::stamp);
            Optional<StampedTransform> before =
                    of(child).filter(each -> each.stamp() <= stamp).max(byStamp);
            Optional<StampedTransform> after =
                    of(child).filter(each -> each.stamp() >= stamp).min(byStamp);
            if (before.isPresent() && after.isPresent()) {
                edges.add(between(before.get(), after.get(), stamp));
            }
        }
        return edges;
    }

    private static Edge edge(StampedTransform each) {
        return new Edge(each.parent(), each.child(), matrix(each.parentFromChild()));
    }

    private static Edge between(StampedTransform before, StampedTransform after, long stamp) {
        if (!before.parent().equals(after.parent()) || before.stamp() == after.stamp()) {
            return edge(before);
        }
        double share = (stamp - before.stamp()) / (double) (after.stamp() - before.stamp());
        double[] from = matrix(before.parentFromChild());
        double[] to = matrix(after.parentFromChild());
        double[] turned = times(from, power(times(inverse(rotation(from)), rotation(to)), share));
        for (int row = 0; row < 3; row++) {
            turned[4 * row + 3] = (1 - share) * from[4 * row + 3] + share * to[4 * row + 3];
        }
        return new Edge(before.parent(), before.child(), turned);
    }

    /// The matrix of one frame in another one; empty where the frames are not joined at that time.
    ///
    /// @param stamp 0 for the newest that all in between have
    Optional<double[]> find(String target, String source, long stamp) {
        if (stamp != 0) {
            return path(edges(stamp), target, source).map(ObviousTransforms::product);
        }
        var last = new ArrayList<Edge>();
        fixed.values().forEach(each -> last.add(edge(each)));
        moving.stream()
                .collect(Collectors.toMap(
                        StampedTransform::child, each -> each, (one, two) -> one.stamp() > two.stamp() ? one : two))
                .values()
                .forEach(each -> last.add(edge(each)));
        return path(last, target, source).flatMap(steps -> {
            long common = steps.stream()
                    .map(step -> step.edge.child)
                    .filter(child -> !fixed.containsKey(child))
                    .mapToLong(child ->
                            of(child).mapToLong(StampedTransform::stamp).max().orElseThrow())
                    .min()
                    .orElse(0);
            return common == 0 ? Optional.of(product(steps)) : find(target, source, common);
        });
    }

    /// @param isDown from the parent to the child
    private record Step(Edge edge, boolean isDown) {}

    private static Optional<List<Step>> path(List<Edge> edges, String target, String source) {
        var open = new ArrayDeque<List<Step>>();
        var ends = new ArrayDeque<String>();
        var seen = new java.util.HashSet<String>(Set.of(target));
        open.add(List.of());
        ends.add(target);
        while (!open.isEmpty()) {
            List<Step> steps = open.remove();
            String end = ends.remove();
            if (end.equals(source)) {
                return Optional.of(steps);
            }
            for (Edge edge : edges) {
                boolean isDown = edge.parent.equals(end);
                String next = isDown ? edge.child : edge.parent;
                if ((isDown || edge.child.equals(end)) && seen.add(next)) {
                    var longer = new ArrayList<>(steps);
                    longer.add(new Step(edge, isDown));
                    open.add(longer);
                    ends.add(next);
                }
            }
        }
        return Optional.empty();
    }

    private static double[] product(List<Step> steps) {
        double[] product = matrix(FrameTransform.NONE);
        for (Step step : steps) {
            product = times(product, step.isDown ? step.edge.matrix : inverse(step.edge.matrix));
        }
        return product;
    }

    static double[] matrix(FrameTransform transform) {
        Quaternion turned = transform.rotation();
        double[] x = turned.rotated(1, 0, 0);
        double[] y = turned.rotated(0, 1, 0);
        double[] z = turned.rotated(0, 0, 1);
        return new double[] {
            x[0],
            y[0],
            z[0],
            transform.x(),
            x[1],
            y[1],
            z[1],
            transform.y(),
            x[2],
            y[2],
            z[2],
            transform.z(),
            0,
            0,
            0,
            1
        };
    }

    private static double[] times(double[] one, double[] two) {
        var product = new double[16];
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 4; column++) {
                for (int i = 0; i < 4; i++) {
                    product[4 * row + column] += one[4 * row + i] * two[4 * i + column];
                }
            }
        }
        return product;
    }

    private static double[] rotation(double[] matrix) {
        double[] rotation = matrix.clone();
        for (int row = 0; row < 3; row++) {
            rotation[4 * row + 3] = 0;
        }
        return rotation;
    }

    private static double[] inverse(double[] matrix) {
        var inverse = new double[16];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                inverse[4 * row + column] = matrix[4 * column + row];
                inverse[4 * row + 3] -= matrix[4 * column + row] * matrix[4 * column + 3];
            }
        }
        inverse[15] = 1;
        return inverse;
    }

    /// A rotation by a share of its angle about its axis (O. Rodrigues).
    private static double[] power(double[] rotation, double share) {
        double angle = Math.acos(Math.clamp((rotation[0] + rotation[5] + rotation[10] - 1) / 2, -1, 1));
        double scale = 2 * Math.sin(angle);
        if (scale < 1e-9) {
            return matrix(FrameTransform.NONE);
        }
        double x = (rotation[9] - rotation[6]) / scale;
        double y = (rotation[2] - rotation[8]) / scale;
        double z = (rotation[4] - rotation[1]) / scale;
        double cosine = Math.cos(share * angle);
        double sine = Math.sin(share * angle);
        double rest = 1 - cosine;
        return new double[] {
            cosine + x * x * rest,
            x * y * rest - z * sine,
            x * z * rest + y * sine,
            0,
            y * x * rest + z * sine,
            cosine + y * y * rest,
            y * z * rest - x * sine,
            0,
            z * x * rest - y * sine,
            z * y * rest + x * sine,
            cosine + z * z * rest,
            0,
            0,
            0,
            0,
            1
        };
    }
}
