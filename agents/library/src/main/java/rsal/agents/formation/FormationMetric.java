package rsal.agents.formation;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rsal.agents.formation.FormationSlots.Slot;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.metric.RobotState;
import rsal.metric.RunState;
import rsal.metric.SignalType;
import rsal.settings.Arguments;

/// How well robots keep a formation: where they should be now, as who leads them said last, and for how long
/// they were not yet in place. Between two messages places move as the last one foretold.
public final class FormationMetric implements MetricType {
    static final QuantityType FORMING =
            QuantityType.of("formationTime", "s", "time so far in which a formation was not complete");
    static final SignalType ERROR = SignalType.ofRobots(
            "formationError", "m", "true distance of a robot from its place, while the formation is complete");

    private static final double FRESH = 2; // s; then nobody leads any more
    private static final double ROUNDING = 1e-6; // s; of differences of times

    @Override
    public String key() {
        return "formation";
    }

    @Override
    public String description() {
        return "Distance of robots from their places in a formation, and time until a formation is complete.";
    }

    @Override
    public List<QuantityType> quantities() {
        return List.of(FORMING);
    }

    @Override
    public List<SignalType> signals() {
        return List.of(ERROR);
    }

    @Override
    public Metric create(Arguments arguments, RunState run) {
        return new Formations(run);
    }

    private static final class Formations implements Metric {
        private final RunState run;
        private final Map<String, Said> newest = new TreeMap<>(); // by leader
        private double looked = Double.NaN; // s
        private Duration forming = Duration.ZERO;

        /// @param time since the run's start [s]
        private record Said(double time, FormationSlots slots) {
            boolean isFresh(double now) {
                return now - time <= FRESH + ROUNDING;
            }
        }

        Formations(RunState run) {
            this.run = run;
        }

        @Override
        public void onMessage(String sender, Object content) {
            if (content instanceof FormationSlots slots) {
                newest.put(sender, new Said(run.time(), slots));
            }
        }

        @Override
        public void onStep() {
            double before = looked;
            looked = run.time();
            if (!newest.isEmpty()) {
                look(before, looked);
            }
        }

        /// @param before time of the last step; NaN for the first [s]
        private void look(double before, double now) {
            for (RobotState robot : run.robots()) {
                if (robot.isTrue()) {
                    robot.mapFromBase()
                            .ifPresent(mapFromBase -> mapFromSlot(robot.id(), now)
                                    .ifPresent(mapFromSlot ->
                                            run.sample(ERROR, robot.id(), mapFromSlot.distanceTo(mapFromBase))));
                }
            }
            if (!Double.isNaN(before) && newest.values().stream().anyMatch(said -> isForming(said, now))) {
                forming = forming.plus(seconds(now - before));
            }
        }

        private static boolean isForming(Said said, double now) {
            return said.isFresh(now) && !said.slots.slots().isEmpty() && !said.slots.formed();
        }

        /// Where a robot should be now; empty when it is in no formation, or this is not in place.
        private Optional<Pose2d> mapFromSlot(String robot, double now) {
            for (Said said : newest.values()) {
                Slot slot = said.slots.slots().get(robot);
                if (slot != null && said.isFresh(now) && said.slots.formed()) {
                    return Optional.of(FormationSlots.at(slot, seconds(now - said.time), said.slots.ahead()));
                }
            }
            return Optional.empty();
        }

        private static Duration seconds(double seconds) {
            return Duration.ofNanos(Math.round(seconds * 1e9));
        }

        @Override
        public double value(String quantity, List<String> names) {
            return forming.toNanos() / 1e9;
        }
    }
}
