package rsal.server.message;

import java.util.List;
import java.util.function.Supplier;
import rsal.settings.InvalidSettings;

/// A request is turned down: with a status, a sentence, and for settings all their errors.
public final class Refusal extends RuntimeException {
    private static final long serialVersionUID = 1;
    private static final int LONGEST = 300; // characters of what a request is answered with

    private final int status;
    private final String sentence;
    private final transient List<Messages.FieldError> problems;

    public Refusal(int status, String message) {
        this(status, message, List.of());
    }

    /// With the first of the errors alone, where there is no form to show all of them in.
    public Refusal(int status, InvalidSettings invalid) {
        this(status, invalid.problems().getFirst().message());
    }

    public Refusal(int status, String message, List<Messages.FieldError> problems) {
        super(message, null, false, false); // expected, so without the cost of a stack trace
        this.status = status;
        this.sentence = message;
        this.problems = problems;
    }

    /// What a request says, if it makes sense.
    ///
    /// @param read throws an [IllegalArgumentException] with a sentence when it makes none
    public static <T> T unless(Supplier<T> read) {
        try {
            return read.get();
        } catch (IllegalArgumentException e) {
            String why = String.valueOf(e.getMessage());
            throw new Refusal(400, why.length() <= LONGEST ? why : why.substring(0, LONGEST) + "…");
        }
    }

    public int status() {
        return status;
    }

    /// The message.
    public String sentence() {
        return sentence;
    }

    public List<Messages.FieldError> problems() {
        return problems;
    }

    /// What a person typed, short enough for a sentence.
    public static String shortened(String text) {
        return text.length() <= 80 ? text : text.substring(0, 77) + "...";
    }
}
