package rsal.agents.swarm;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.metric.RobotState;
import rsal.metric.RunState;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// How the robots of a run stand to each other, by their true poses. Computed only when asked for: the time grows with
/// the square of the number of robots.
public final class SwarmMetric implements MetricType {
    static final Parameter<Double> LINK =
            Parameter.number("link", 1.8, 0.1, 1000, "m", "Robots that are nearer than this belong to one cluster.");
    static final QuantityType POLARIZATION = QuantityType.of(
            "polarization", "", "length of the mean of all headings: 1 if all are equal (order parameter)");
    static final QuantityType CLUSTER =
            QuantityType.of("largestCluster", "", "share of the robots that are in the largest cluster");
    static final QuantityType SPREAD =
            QuantityType.of("spread", "m", "root mean square of the distances of all robots from their center");
    static final QuantityType NEAREST =
            QuantityType.of("nearestDistance", "m", "mean distance of a robot from the nearest other one");

    @Override
    public String key() {
        return "swarm";
    }

    @Override
    public String description() {
        return "Order, clusters and distances of all robots.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(LINK);
    }

    @Override
    public List<QuantityType> quantities() {
        return List.of(POLARIZATION, CLUSTER, SPREAD, NEAREST);
    }

    @Override
    public Metric create(Arguments arguments, RunState run) {
        return new Swarm(run, arguments.get(LINK));
    }

    private record Swarm(RunState run, double link) implements Metric {
        @Override
        public double value(String quantity, List<String> names) {
            var poses = new ArrayList<Pose2d>();
            for (RobotState robot : run.robots()) {
                robot.mapFromBase().filter(_ -> robot.isTrue()).ifPresent(poses::add);
            }
            if (poses.isEmpty()) {
                return Double.NaN;
            }
            if (quantity.equals(POLARIZATION.word())) {
                return polarization(poses);
            }
            if (quantity.equals(CLUSTER.word())) {
                return largestCluster(poses, link);
            }
            return quantity.equals(SPREAD.word()) ? spread(poses) : nearest(poses);
        }
    }

    /// After T. Vicsek et al. (1995).
    static double polarization(List<Pose2d> poses) {
        double x = 0;
        double y = 0;
        for (Pose2d pose : poses) {
            x += StrictMath.cos(pose.theta());
            y += StrictMath.sin(pose.theta());
        }
        return Math.sqrt(x * x + y * y) / poses.size();
    }

    static double largestCluster(List<Pose2d> poses, double link) {
        var group = new int[poses.size()]; // number of the first robot that is linked
        Arrays.fill(group, -1);
        int largest = 0;
        var open = new ArrayList<Integer>();
        for (int first = 0; first < group.length; first++) {
            if (group[first] >= 0) {
                continue;
            }
            group[first] = first;
            open.add(first);
            int size = 0;
            while (!open.isEmpty()) {
                int one = open.removeLast();
                size++;
                for (int other = 0; other < group.length; other++) {
                    if (group[other] < 0 && poses.get(one).distanceTo(poses.get(other)) <= link) {
                        group[other] = first;
                        open.add(other);
                    }
                }
            }
            largest = Math.max(largest, size);
        }
        return (double) largest / poses.size();
    }

    static double spread(List<Pose2d> poses) {
        double x = poses.stream().mapToDouble(Pose2d::x).average().orElse(Double.NaN);
        double y = poses.stream().mapToDouble(Pose2d::y).average().orElse(Double.NaN);
        var center = new Pose2d(x, y, 0);
        return Math.sqrt(poses.stream()
                .mapToDouble(pose -> center.distanceTo(pose) * center.distanceTo(pose))
                .average()
                .orElse(Double.NaN));
    }

    static double nearest(List<Pose2d> poses) {
        if (poses.size() < 2) {
            return Double.NaN;
        }
        double sum = 0;
        for (int one = 0; one < poses.size(); one++) {
            double least = Double.POSITIVE_INFINITY;
            for (int other = 0; other < poses.size(); other++) {
                if (other != one) {
                    least = Math.min(least, poses.get(one).distanceTo(poses.get(other)));
                }
            }
            sum += least;
        }
        return sum / poses.size();
    }
}
