package rsal.ros2.simulation;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import java.util.stream.IntStream;
import rsal.ros2.cdr.RosMessage;

/// `simulation_interfaces/EntityFilters`: which entities somebody asks for. Expressions come from anybody, so
/// that their length and the work on them are bounded.
final class EntityFilter {
    private static final int LONGEST = 200; // characters
    private static final int MOST_LOOKS = 1_000_000; // at characters of names, in all

    private final Pattern name;
    private final List<Integer> categories; // empty for all
    private int looks;

    private EntityFilter(Pattern name, List<Integer> categories) {
        this.name = name;
        this.categories = categories;
    }

    /// A filter, or why there can be none.
    sealed interface Read {
        record Filter(EntityFilter filter) implements Read {}

        record Refused(ResultCode result) implements Read {}
    }

    static Read of(RosMessage filters) {
        if (!filters.message("tags").get("tags", List.class).isEmpty()) {
            return new Read.Refused(ResultCode.unsupported("Entities have no tags here. Leave 'tags' empty."));
        }
        if (filters.message("bounds").integer("type") != 0) {
            return new Read.Refused(
                    ResultCode.unsupported("Entities can't be chosen by bounds. Leave 'bounds' empty."));
        }
        String filter = filters.text("filter");
        if (filter.length() > LONGEST) {
            return new Read.Refused(ResultCode.failed(
                    "The filter has %d characters. At most %d are allowed.".formatted(filter.length(), LONGEST)));
        }
        List<Integer> categories = filters.messages("categories").stream()
                .map(each -> (int) each.integer("category"))
                .toList();
        try {
            return new Read.Filter(new EntityFilter(Pattern.compile(filter), categories));
        } catch (PatternSyntaxException e) {
            return new Read.Refused(ResultCode.failed(
                    "The filter '%s' is not a regular expression: %s.".formatted(filter, e.getDescription())));
        }
    }

    /// Those that fit.
    ///
    /// @param names all of them
    /// @param categories theirs
    /// @return empty when the expression takes too long
    Optional<List<String>> matching(List<String> names, int[] categories) {
        try {
            return Optional.of(IntStream.range(0, names.size())
                    .filter(i -> this.categories.isEmpty() || this.categories.contains(categories[i]))
                    .mapToObj(names::get)
                    .filter(each -> name.matcher(new Watched(each)).find())
                    .toList());
        } catch (TooMuchWork | StackOverflowError e) {
            return Optional.empty();
        }
    }

    private static final class TooMuchWork extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    /// A name that counts how often it is looked at, as some expressions take as good as forever.
    private final class Watched implements CharSequence {
        private final CharSequence text;

        Watched(CharSequence text) {
            this.text = text;
        }

        @Override
        public char charAt(int index) {
            looks++;
            if (looks > MOST_LOOKS) {
                throw new TooMuchWork();
            }
            return text.charAt(index);
        }

        @Override
        public int length() {
            return text.length();
        }

        @Override
        public CharSequence subSequence(int start, int end) {
            return new Watched(text.subSequence(start, end));
        }

        @Override
        public String toString() {
            return text.toString();
        }
    }
}
