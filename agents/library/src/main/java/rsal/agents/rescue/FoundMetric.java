package rsal.agents.rescue;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.NameKind;
import rsal.metric.QuantityType;
import rsal.metric.RunState;
import rsal.metric.ThingState;
import rsal.settings.Arguments;

/// Of which things an agent has said where they are, and was right.
public final class FoundMetric implements MetricType {
    static final QuantityType FOUND = QuantityType.of(
                    "found", "", "things whose position an agent has reported", NameKind.THINGS_TO_REACH)
            .countingAll();

    private static final double RIGHT = 1.0; // m by which who says where a thing is may be wrong

    @Override
    public String key() {
        return "found";
    }

    @Override
    public String description() {
        return "Counts the things with a marker that are found: an agent has reported their position with an error of"
                + " at most 1 m.";
    }

    @Override
    public List<QuantityType> quantities() {
        return List.of(FOUND);
    }

    @Override
    public Metric create(Arguments arguments, RunState run) {
        return new Findings(run);
    }

    private static final class Findings implements Metric {
        private final RunState run;
        private final Set<String> found = new HashSet<>(); // things
        private final Map<String, Integer> byGroup = new HashMap<>(); // how many

        Findings(RunState run) {
            this.run = run;
        }

        @Override
        public void onMessage(String sender, Object content) {
            if (content instanceof VictimFound said) {
                run.things().stream()
                        .filter(thing -> thing.marker().orElse(-1) == said.victim() && isRight(said, thing))
                        .findFirst()
                        .ifPresent(thing -> note(thing, said.robot()));
            }
        }

        private static boolean isRight(VictimFound said, ThingState thing) {
            return thing.mapFromThing().position().distanceTo(said.mapFromVictim()) <= RIGHT;
        }

        private void note(ThingState thing, String robot) {
            if (found.add(thing.name())) {
                byGroup.merge(thing.group(), 1, Integer::sum);
                run.event("found", thing.name(), "is found by " + robot);
            }
        }

        @Override
        public double value(String quantity, List<String> names) {
            return byGroup.getOrDefault(names.getFirst(), 0);
        }
    }
}
