package rsal.agents.patrol;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rsal.agents.patrol.strategy.VisitGaps;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.metric.RobotState;
import rsal.metric.RunState;
import rsal.metric.SignalType;
import rsal.settings.Arguments;

/// Places that a team watches, and for how long nobody has really been at each of them: at each instant
/// (instantaneous idleness), and between two visits, as most articles about patrols report. A robot that stays
/// at a place and says so again makes no further visit.
public final class IdlenessMetric implements MetricType {
    static final SignalType IDLE_TIME = SignalType.ofRun(
            "idleness", "s", "time since the last visit of a watched place, once a second for each place");

    private static final QuantityType GAP =
            QuantityType.of("visitGap", "s", "mean over watched places of the mean time between two visits");
    private static final QuantityType DEVIATION = QuantityType.of(
            "visitGapDeviation", "s", "standard deviation over watched places of the mean time between two visits");

    private static final double NEAR = 1.0; // m
    private static final double PERIOD = 1.0; // s between two samples

    @Override
    public String key() {
        return "idleness";
    }

    @Override
    public String description() {
        return "Time for which no robot was truly within 1 m of each place that a team watches.";
    }

    @Override
    public List<QuantityType> quantities() {
        return List.of(GAP, DEVIATION);
    }

    @Override
    public List<SignalType> signals() {
        return List.of(IDLE_TIME);
    }

    @Override
    public Metric create(Arguments arguments, RunState run) {
        return new WatchedPlaces(run);
    }

    private static final class WatchedPlaces implements Metric {
        private final RunState run;
        private final Map<Point2d, Double> visited = new LinkedHashMap<>(); // when [s], by place
        private final Map<String, Set<Point2d>> staying =
                new LinkedHashMap<>(); // by robot, places visited and not left
        private List<Point2d> places = List.of();
        private VisitGaps gaps = new VisitGaps(0, 0);
        private double next; // s
        private double began; // s

        WatchedPlaces(RunState run) {
            this.run = run;
        }

        @Override
        public void onMessage(String sender, Object content) {
            switch (content) {
                case Watch said -> watch(said.mapFromPlaces());
                case Visited said ->
                    run.robot(said.robot())
                            .flatMap(RobotState::mapFromBase)
                            .ifPresent(mapFromBase -> visit(said.robot(), said.mapFromPlace(), mapFromBase));
                default -> {} // for others
            }
        }

        /// These are watched from now on.
        private void watch(List<Point2d> mapFromPlaces) {
            visited.clear();
            staying.clear();
            mapFromPlaces.forEach(place -> visited.put(place, run.time()));
            places = List.copyOf(visited.keySet());
            gaps = new VisitGaps(places.size(), 0);
            began = run.time();
            next = run.time() + PERIOD;
        }

        /// A robot says that it has been at a place.
        ///
        /// @param mapFromBase where it really is
        private void visit(String robot, Point2d mapFromPlace, Pose2d mapFromBase) {
            if (isNear(mapFromBase, mapFromPlace) && visited.containsKey(mapFromPlace)) {
                double now = run.time() - began;
                int place = places.indexOf(mapFromPlace);
                if (staying.computeIfAbsent(robot, _ -> new HashSet<>()).add(mapFromPlace)) {
                    gaps.visit(place, now);
                } else {
                    gaps.stay(place, now);
                }
                visited.put(mapFromPlace, run.time());
            }
        }

        private static boolean isNear(Pose2d mapFromBase, Point2d mapFromPlace) {
            return mapFromBase.position().distanceTo(mapFromPlace) <= NEAR;
        }

        @Override
        public void onStep() {
            double now = run.time();
            if (!visited.isEmpty() && now >= next) {
                next += PERIOD;
                staying.forEach(this::leave);
                visited.values().forEach(last -> run.sample(IDLE_TIME, now - last));
            }
        }

        /// Forgets the places that a robot is no longer near.
        private void leave(String robot, Set<Point2d> near) {
            run.robot(robot)
                    .flatMap(RobotState::mapFromBase)
                    .ifPresent(mapFromBase -> near.removeIf(place -> !isNear(mapFromBase, place)));
        }

        @Override
        public double value(String quantity, List<String> names) {
            if (places.isEmpty()) {
                return Double.NaN;
            }
            double now = run.time() - began;
            return quantity.equals(GAP.word()) ? gaps.meanGap(now) : gaps.deviation(now);
        }
    }
}
