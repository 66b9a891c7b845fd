package rsal.ros2.rosbridge;

/// What a server says, which may be as long as it likes and have anything in it, for people to read.
final class PeerText {
    private static final int LONGEST = 200; // characters that are shown

    private PeerText() {}

    /// One line of it.
    static String shown(String text) {
        return shown(text, LONGEST);
    }

    /// @param longest characters; what follows them is left out
    static String shown(String text, int longest) {
        boolean isWhole = text.length() <= longest;
        String line = (isWhole ? text : text.substring(0, longest))
                .replaceAll("[\\p{Cc}\\u2028\\u2029]+", " ")
                .strip();
        return isWhole ? line : line + "…";
    }
}
