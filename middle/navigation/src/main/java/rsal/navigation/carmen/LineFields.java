package rsal.navigation.carmen;

/// The words of a line, one after the other.
final class LineFields {
    private final String line;
    private int next;

    LineFields(String line) {
        this.line = line;
    }

    /// A line that doesn't say what its kind promises.
    static final class Misread extends Exception {
        private static final long serialVersionUID = 1;
        private final String reason;

        /// @param reason what is counted
        /// @param what with the value
        Misread(String reason, String what) {
            super(what, null, false, false); // bad lines may be many
            this.reason = reason;
        }

        String reason() {
            return reason;
        }
    }

    boolean hasNext() {
        while (next < line.length() && line.charAt(next) <= ' ') {
            next++;
        }
        return next < line.length();
    }

    String word() throws Misread {
        if (!hasNext()) {
            throw new Misread("cut short", "The line ends where more should follow.");
        }
        int start = next;
        while (next < line.length() && line.charAt(next) > ' ') {
            next++;
        }
        return line.substring(start, next);
    }

    void skip(int words) throws Misread {
        for (int i = 0; i < words; i++) {
            word();
        }
    }

    /// What is left of the line, without blanks around it.
    String rest() {
        String rest = line.substring(next).strip();
        next = line.length();
        return rest;
    }

    /// Any number; NaN and ±∞ may be written (`nan`, `-inf`).
    double number() throws Misread {
        String word = word();
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            return switch (word.toLowerCase(java.util.Locale.ROOT)) {
                case "nan", "-nan", "+nan" -> Double.NaN;
                case "inf", "+inf", "infinity" -> Double.POSITIVE_INFINITY;
                case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
                default -> throw new Misread("not a number", "'%s' should be a number.".formatted(brief(word)));
            };
        }
    }

    double finite(String what) throws Misread {
        double number = number();
        if (!Double.isFinite(number)) {
            throw new Misread("not finite", "The %s is '%s'.".formatted(what, number));
        }
        return number;
    }

    int count(String what, int most) throws Misread {
        String word = word();
        try {
            int count = Integer.parseInt(word);
            if (count >= 0 && count <= most) {
                return count;
            }
        } catch (NumberFormatException _) {
            // told below
        }
        throw new Misread(
                "an impossible count", "The number of %s is '%s', not 0 to %d.".formatted(what, brief(word), most));
    }

    static String brief(String word) {
        return word.length() <= 40 ? word : word.substring(0, 40) + "…";
    }
}
