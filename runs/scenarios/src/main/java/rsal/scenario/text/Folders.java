package rsal.scenario.text;

import java.util.regex.Pattern;

/// Keeps folders of this machine out of what is given to others, as these tell names of users.
public final class Folders {
    /// An absolute path of files, at the beginning of a word or behind what an option is set to.
    private static final Pattern ABSOLUTE =
            Pattern.compile("(?<=^|[\\s='\"(\\[,])/(?:[^\\s'\"()/:,]+/)+(?=[^\\s'\"/])");

    private Folders() {}

    /// The same words with the names of files alone: `map log.gz --out d` of `map /home/bob/log.gz --out
    /// /tmp/d`.
    public static String without(String words) {
        return ABSOLUTE.matcher(words).replaceAll("");
    }
}
