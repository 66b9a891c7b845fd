package rsal.ros2.link;

/// What other programs say, which may be as long as they like and have anything in it, for people to read.
public final class PeerText {
    private static final int LONGEST = 200; // characters that are shown

    private PeerText() {}

    /// One line of it.
    public static String shown(String text) {
        return shown(text, LONGEST);
    }

    /// @param longest characters; what follows them is left out
    public static String shown(String text, int longest) {
        boolean isWhole = text.length() <= longest;
        String line = (isWhole ? text : text.substring(0, longest))
                .replaceAll("[\\p{Cc}\\u2028\\u2029]+", " ")
                .strip();
        return isWhole ? line : line + "…";
    }
}
