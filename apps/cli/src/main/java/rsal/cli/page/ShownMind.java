package rsal.cli.page;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import rsal.cli.terminal.TextTable;
import tools.jackson.databind.JsonNode;

/// What is in an agent, as people read it, for `rsal agent mind`.
final class ShownMind {
    private static final Set<String> UNWANTED = Set.of("REACHED", "NOT_WANTED");
    private static final Pattern LONG_NUMBER = Pattern.compile("(?<![\\w.])(-?\\d+\\.\\d{4,})(E-?\\d+)?(?!\\w)");
    private static final int DECIMALS = 3;

    private ShownMind() {}

    /// @param agent as the page is told
    static String text(String name, JsonNode agent) {
        var text = new StringBuilder();
        JsonNode mind = agent.path("mind");
        boolean hasMind = !mind.isMissingNode() && !mind.isNull();
        String state = words(agent.path("state"));
        section(text, "Does", state.isEmpty() ? "" : "  %s%n".formatted(state));
        section(text, "Believes", beliefs(hasMind ? mind.path("beliefs") : agent.path("shown")));
        if (hasMind) {
            Predicate<JsonNode> isUnwanted =
                    goal -> UNWANTED.contains(goal.path("state").asString());
            section(text, "Wants", goals(mind.path("goals"), isUnwanted.negate()));
            section(text, "Does not want now", goals(mind.path("goals"), isUnwanted));
        }
        section(text, "History", history(agent.path("history")));
        section(text, "Talks", talks(agent.path("talks")));
        section(text, "Mailbox", mail(agent.path("mail")));
        if (!hasMind) {
            text.append(
                    agent.path("status").asString("").equals("RUNNING")
                            ? "'%s' shows no goals, only its state and beliefs.%n".formatted(name)
                            : "'%s' does not run.%n".formatted(name));
        }
        return text.toString();
    }

    /// With numbers as short as the page has them: `0.46695204089382697` is `0.467`.
    static String words(JsonNode said) {
        return LONG_NUMBER.matcher(said.asString("")).replaceAll(number -> {
            BigDecimal brief = new BigDecimal(number.group(1)).setScale(DECIMALS, RoundingMode.HALF_UP);
            String exponent = number.group(2);
            return brief.stripTrailingZeros().toPlainString() + (exponent == null ? "" : exponent);
        });
    }

    private static void section(StringBuilder text, String title, String lines) {
        if (!lines.isEmpty()) {
            text.append(title).append('\n').append(lines);
        }
    }

    private static String beliefs(JsonNode beliefs) {
        var lines = new TextTable("  ");
        beliefs.forEach(belief -> lines.row(words(belief.path("name")), words(belief.path("value"))));
        return lines.toString();
    }

    /// Each with what is done for it, the ways that it has, and why the last one failed.
    private static String goals(JsonNode goals, Predicate<JsonNode> which) {
        var lines = new TextTable("  ");
        goals.valueStream().filter(which).forEach(goal -> {
            lines.row(
                    goal.path("state").asString().toLowerCase(Locale.ROOT).replace('_', ' '),
                    "%s (%s)".formatted(words(goal.path("name")), words(goal.path("urgency"))));
            also(lines, "does: ", joined(goal.path("steps"), " > "));
            also(lines, "plans: ", joined(goal.path("plans"), ", "));
            also(lines, "failed: ", words(goal.path("failure")));
        });
        return lines.toString();
    }

    private static void also(TextTable lines, String title, String words) {
        if (!words.isEmpty()) {
            lines.row("", "  " + title + words);
        }
    }

    private static String joined(JsonNode words, String between) {
        return words.valueStream().map(ShownMind::words).collect(Collectors.joining(between));
    }

    private static String history(JsonNode history) {
        var lines = new TextTable("  ");
        history.forEach(change -> lines.row(
                seconds(change),
                change.path("kind").asString().toLowerCase(Locale.ROOT),
                words(change.path("name")),
                words(change.path("words"))));
        return lines.toString();
    }

    private static String talks(JsonNode talks) {
        var lines = new TextTable("  ");
        talks.forEach(talk -> lines.row(
                seconds(talk),
                words(talk.path("from")) + " → " + words(talk.path("to")),
                words(talk.path("act")),
                words(talk.path("words"))));
        return lines.toString();
    }

    private static String mail(JsonNode mail) {
        var lines = new TextTable("  ");
        mail.forEach(one -> lines.row(
                seconds(one),
                words(one.path("from")) + (one.path("forAll").asBoolean() ? " → all" : ""),
                words(one.path("topic")),
                words(one.path("words"))));
        return lines.toString();
    }

    private static String seconds(JsonNode said) {
        return String.format(Locale.ROOT, "%.1f s", said.path("time").asDouble());
    }
}
