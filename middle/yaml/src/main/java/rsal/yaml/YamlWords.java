package rsal.yaml;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/// Says what is wrong with a YAML text in words of those who write it: a parser's are made of its tokens (`<scalar>`).
final class YamlWords {
    private static final Pattern UNEXPECTED = Pattern.compile("expected (.+?), but (?:found|got) (.+)");
    private static final Pattern BEGINNING = Pattern.compile("found character '(.+?)' that cannot start any token.*");

    private static final Map<String, String> TOKENS = Map.ofEntries(
            Map.entry("<scalar>", "a text or a number"),
            Map.entry("<block end>", "the end of a group or list"),
            Map.entry("<block mapping start>", "a group of settings (name: value)"),
            Map.entry("<block sequence start>", "a list"),
            Map.entry("<stream end>", "the end of the file"),
            Map.entry("<document start>", "the end of the file"), // after which another text might begin
            Map.entry("<document end>", "the end of the text"),
            Map.entry("<alias>", "an alias (*name)"),
            Map.entry("<anchor>", "an anchor (&name)"),
            Map.entry("<tag>", "a tag (!name)"),
            Map.entry("<directive>", "a directive (%)"),
            Map.entry("the node content", "a value"),
            Map.entry("-", "an entry of a list (-)"),
            Map.entry("?", "a setting (name: value)"));

    private static final Map<String, String> KNOWN = Map.of(
            "mapping values are not allowed here",
            "a colon (:) can't stand here",
            "mapping keys are not allowed here",
            "a setting (name: value) can't begin here",
            "sequence entries are not allowed here",
            "a list (-) can't begin here",
            "could not find expected ':'",
            "a name has no colon (:) after it",
            "found unexpected end of stream",
            "a quote is opened and not closed");

    private YamlWords() {}

    /// @param problem as the parser has it
    static String of(String problem) {
        Matcher unexpected = UNEXPECTED.matcher(problem);
        if (unexpected.matches()) {
            String there = token(unexpected.group(2));
            return unexpected.group(1).equals("<block end>")
                    ? there + " can't stand here, or not indented like this"
                    : "%s must stand here, not %s".formatted(token(unexpected.group(1)), there);
        }
        Matcher beginning = BEGINNING.matcher(problem);
        if (beginning.matches()) {
            return beginning.group(1).contains("TAB")
                    ? "lines are indented by spaces, not by tabs"
                    : "a text that begins with '%s' needs quotes".formatted(beginning.group(1));
        }
        return KNOWN.getOrDefault(
                problem, problem.lines().findFirst().orElse("").strip());
    }

    private static String token(String name) {
        String bare = name.replaceAll("^'(.+)'$", "$1");
        return TOKENS.getOrDefault(bare, bare.length() == 1 ? "'" + bare + "'" : name);
    }
}
