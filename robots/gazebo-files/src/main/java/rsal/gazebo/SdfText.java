package rsal.gazebo;

/// Texts of worlds, as messages quote them.
final class SdfText {
    private static final int LONGEST = 80;

    private SdfText() {}

    static String shortened(String text) {
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST - 1) + "…";
    }
}
