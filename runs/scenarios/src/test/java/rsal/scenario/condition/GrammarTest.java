package rsal.scenario.condition;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.fail;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.metric.NameKind;
import rsal.metric.QuantityType;
import rsal.metric.SignalType;
import rsal.scenario.condition.Grammar.Names;

class GrammarTest {
    private static final List<String> ROLES = List.of("prey", "hunter", "fast-prey");
    private static final MetricWords METRICS = new MetricWords(
            Stream.concat(
                            RunQuantities.ALL.stream(),
                            Stream.of(
                                    QuantityType.of("caught", "", "", NameKind.ROLE)
                                            .countingAll(),
                                    QuantityType.of("found", "", "", NameKind.THINGS_TO_REACH)
                                            .countingAll(),
                                    QuantityType.of("formationTime", "s", "")))
                    .toList(),
            Stream.concat(
                            RunQuantities.SIGNALS.stream(),
                            Stream.of(
                                    SignalType.ofRobots("captureDistance", "m", ""),
                                    SignalType.ofRobots("formationError", "m", ""),
                                    SignalType.ofRun("idleness", "s", "")))
                    .toList(),
            false);
    private static final Names NAMES = new Names(ROLES, List.of("can", "cup"), List.of("cup"), List.of("den"), METRICS);

    /// With a metric that is a program from who knows where.
    private static final Names OPEN =
            new Names(ROLES, List.of(), List.of(), List.of(), MetricWords.of(List.of(), true));

    private static Names names() {
        return new Names(ROLES, List.of(), List.of(), List.of(), METRICS);
    }

    private static final Map<String, Double> VALUES = Map.ofEntries(
            Map.entry("time", 100.0),
            Map.entry("collisions", 3.0),
            Map.entry("wallCollisions", 1.0),
            Map.entry("explored", 0.97),
            Map.entry("formationTime", 7.0),
            Map.entry("exploring(hunter)", 1.0),
            Map.entry("collected(can)", 4.0),
            Map.entry("found(cup)", 5.0),
            Map.entry("reached(cup)", 3.0),
            Map.entry("caught(prey)", 1.0),
            Map.entry("arrived(hunter)", 1.0),
            Map.entry("gone(hunter)", 1.0),
            Map.entry("gone(prey)", 0.0),
            Map.entry("faults", 4.0),
            Map.entry("sentMessages", 20.0),
            Map.entry("receivedMessages", 30.0),
            Map.entry("lostMessages", 50.0),
            Map.entry("sentMessages(pose)", 5.0),
            Map.entry("sentMessages(\"fleet/tasks\")", 6.0),
            Map.entry("receivedMessages(pose)", 7.0),
            Map.entry("lostMessages(pose)", 8.0),
            Map.entry("distance(prey, hunter)", 1.5),
            Map.entry("within(prey, den)", 2.0),
            Map.entry("visits(hunter, den)", 3.0),
            Map.entry("metric(load)", 0.4));

    private static final Set<String> COUNTED_ALL =
            Set.of("arrived(hunter)", "collected(cup)", "found(cup)", "caught(fast-prey)");

    private static final Facts FACTS = new Facts() {
        @Override
        public double value(Quantity quantity) {
            return VALUES.getOrDefault(quantity.toString(), Double.NaN);
        }

        @Override
        public boolean holdsForAll(Quantity quantity) {
            return COUNTED_ALL.contains(quantity.toString());
        }
    };

    @ParameterizedTest
    @CsvSource({
        "time > 99.5, true",
        "time > 100, false",
        "time >= 100, true",
        "time < 100, false",
        "time <= 100, true",
        "time == 100, true",
        "time != 100, false",
        "time > -1, true",
        "collisions > 2, true",
        "wallCollisions > 1, false",
        "caught(prey) >= 1, true",
        "arrived(hunter) == 1, true",
        "allArrived(hunter), true",
        "allArrived(prey), false",
        "gone(hunter) == 1, true",
        "gone(prey) > 0, false",
        "faults > 3, true",
        "sentMessages == 20, true",
        "receivedMessages > 30, false",
        "lostMessages < 50, false",
        "explored > 0.96, true",
        "exploring(hunter) == 0, false",
        "collected(can) == 4, true",
        "allCollected(can), false",
        "allCollected(cup), true",
        "found(cup) == 5, true",
        "allFound(cup), true",
        "reached(cup) >= 3, true",
        "allReached(cup), false",
        "sentMessages(pose) == 5, true",
        "'sentMessages(\"fleet/tasks\") == 6', true",
        "receivedMessages(pose) > 7, false",
        "lostMessages(pose) >= 8, true",
        "'distance(prey, hunter) < 2', true",
        "'distance(hunter, prey) < 2', false", // nothing is known
        "'within(prey, den) == 2', true",
        "'visits(hunter,den) > 3', false",
        "metric(load) < 0.5, true",
        "metric(other) < 0.5, false",
        "allCaught(prey), false",
        "allCaught(fast-prey), true",
        "not allCaught(prey), true",
        "not not time > 0, true",
        "time > 0 and collisions > 5, false",
        "time > 0 or collisions > 5, true",
        "time > 0 or time > 0 and time < 0, true", // and binds stronger
        "(time > 0 or time > 0) and time < 0, false",
        "not time > 0 or time > 0, true", // not binds strongest
        "'  time>99and(  collisions>2 )  ', true",
    })
    void saysWhatHolds(String text, boolean holds) {
        assertThat(Grammar.condition(text, NAMES).holds(FACTS)).isEqualTo(holds);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "firstTime(allCaught(prey) and time > 10)",
                "count(collisions)",
                "count(caught(prey))",
                "count(collected(can))",
                "firstTime(allCollected(can))",
                "count(reached(cup))",
                "firstTime(allFound(cup) and not allReached(cup))",
                "distance",
                "distance(hunter)",
                "p95(poseError)",
                "max(poseError(hunter))",
                "mean(captureDistance)",
                "rms(formationError(prey))",
                "count(formationTime)",
                "count(sentMessages(pose))",
                "count(lostMessages(\"fleet/tasks\"))",
                "min(distance(prey, hunter))",
                "quantile(0.9, distance(prey, hunter))",
                "quantile(0.25, poseError(prey))",
                "timeWeightedMean(within(prey, den))",
                "last(visits(hunter, den))",
                "last(metric(load))",
                "mean(metric(\"energy used\"))",
                "firstTime(metric(load) > 0.9 or visits(prey, den) >= 2)",
            })
    void readsMeasuresAsTheyAreWritten(String text) {
        assertThat(Grammar.metric(text, NAMES)).hasToString(text);
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
                    time                     | 4  | <, <=, >, >=, == or != must stand here, not the end.
                    time > much              | 7  | a number must stand here, not 'much'.
                    time > 3 and             | 12 | a condition or quantity must stand here, not the end.
                    time > 3 time < 4        | 9  | and, or, or the end must stand here, not 'time'.
                    (time > 3                | 9  | ')' must stand here, not the end.
                    allCaught(pray)          | 10 | No robots have the role 'pray'.
                    allCaught()              | 10 | a role of robots must stand here, not ')'.
                    allCougt(prey)           | 0  | 'allCougt' is not a condition or quantity.
                    time > 3; exit()         | 8  | ';' can't stand here.
                    time = 3                 | 5  | <, <=, >, >=, == or != must stand here, not '='.
                    visits(prey, pen) > 1    | 13 | No place is called 'pen'.
                    visits(prey) > 1         | 11 | ',' must stand here, not ')'.
                    sentMessages() > 1           | 13 | a topic of messages must stand here, not ')'.
                    metric(3) > 1            | 7  | the name of a metric must stand here, not '3'.
                    ${time}                  | 0  | '$' can't stand here.
                    """)
    void pointsAtTheError(String text, int position, String message) {
        assertThatThrownBy(() -> Grammar.condition(text, names()))
                .isInstanceOfSatisfying(InvalidExpression.class, e -> {
                    assertThat(e).hasMessage(message);
                    assertThat(e.position()).isEqualTo(position);
                });
    }

    @Test
    void guessesWhatWasMeant() {
        assertThat(remedy("allCougt(prey)")).contains("Maybe 'allCaught' was meant?");
        assertThat(remedy("allCaught(pray)")).contains("Maybe 'prey' was meant?");
        assertThatThrownBy(() -> Grammar.metric("p94(poseError)", names()))
                .isInstanceOfSatisfying(
                        InvalidExpression.class, e -> assertThat(e.remedy()).contains("p95"));
        assertThatThrownBy(() -> Grammar.metric("p95(poseEror)", names()))
                .isInstanceOfSatisfying(
                        InvalidExpression.class, e -> assertThat(e.remedy()).contains("poseError"));
    }

    private static String remedy(String text) {
        try {
            Grammar.condition(text, names());
            return fail("%s is no condition.", text);
        } catch (InvalidExpression e) {
            return e.remedy();
        }
    }

    @Test
    void saysWhatADistanceBetweenTwoRolesLacks() {
        assertThatThrownBy(() -> Grammar.metric("distance(prey, hunter)", NAMES))
                .isInstanceOfSatisfying(
                        InvalidExpression.class, e -> assertThat(e.remedy()).contains("min(distance("));
        assertThatThrownBy(() -> Grammar.metric("quantile(95, poseError)", NAMES))
                .hasMessage("A quantile is from 0 to 1.");
    }

    /// Of a recording, whose programs are not read, all that is no metric of every run may be one of theirs.
    @ParameterizedTest
    @ValueSource(strings = {"fed(cat) > 3", "allFed(cat) and hunger < 2", "path(\"a b\", cat) >= 1"})
    void conditionsMayNameMetricsThatAreNotRead(String text) {
        Condition condition = Grammar.condition(text, OPEN);
        assertThat(condition).hasToString(text);
        assertThat(condition.holds(FACTS)).isFalse();
        assertThatThrownBy(() -> Grammar.condition(text, names())).isInstanceOf(InvalidExpression.class);
    }

    @ParameterizedTest
    @ValueSource(strings = {"mean(hunger)", "p95(hunger(cat))", "last(path(cat, mouse))", "count(fed(cat))"})
    void measuresMayNameMetricsThatAreNotRead(String text) {
        assertThat(Grammar.metric(text, OPEN)).hasToString(text);
        assertThatThrownBy(() -> Grammar.metric(text, names())).isInstanceOf(InvalidExpression.class);
    }

    @Test
    void refusesWhatIsTooLongOrTooDeep() {
        assertThatThrownBy(() -> Grammar.condition("(".repeat(900), names())).isInstanceOf(InvalidExpression.class);
        assertThatThrownBy(() -> Grammar.condition("not ".repeat(200) + "time > 1", names()))
                .isInstanceOf(InvalidExpression.class);
        assertThatThrownBy(() -> Grammar.condition(" ".repeat(2000), names())).isInstanceOf(InvalidExpression.class);
        assertThatThrownBy(() -> Grammar.condition("time > " + "9".repeat(900), names()))
                .isInstanceOf(InvalidExpression.class);
    }

    @Test
    void nonsenseGivesNothingButInvalidExpression() {
        String[] pieces = {
            "time",
            "allCaught",
            "(",
            ")",
            "prey",
            ">",
            "=",
            "and",
            "or",
            "not",
            "3",
            "-",
            ".",
            "$",
            "max",
            "poseError",
            "firstTime",
            "count",
            "quantile",
            "distance",
            "metric",
            "sentMessages",
            ",",
            "\"",
            "\"a b\"",
            " ",
            "ä",
            "\n",
            "\uD83D",
            "99999999999999999999"
        };
        for (long seed = 0; seed < 5000; seed++) {
            var random = new SplittableRandom(seed);
            var text = new StringBuilder();
            for (int i = random.nextInt(12); i >= 0; i--) {
                text.append(pieces[random.nextInt(pieces.length)]);
            }
            try {
                Grammar.condition(text.toString(), names()).holds(FACTS);
            } catch (InvalidExpression e) {
                assertThat(e.position()).as("seed %d", seed).isBetween(0, text.length());
            }
            try {
                Grammar.metric(text.toString(), seed % 2 == 0 ? names() : OPEN);
            } catch (InvalidExpression e) {
                assertThat(e).as("seed %d", seed).hasMessageNotContaining("null");
            }
        }
    }
}
