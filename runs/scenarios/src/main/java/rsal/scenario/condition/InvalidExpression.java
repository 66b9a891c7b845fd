package rsal.scenario.condition;

/// A text that is no condition or metric.
public final class InvalidExpression extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final int position;
    private final String remedy;

    /// @param position of the error in the text, from 0
    /// @param remedy what to try; may be empty
    InvalidExpression(int position, String message, String remedy) {
        super(message);
        this.position = position;
        this.remedy = remedy;
    }

    public int position() {
        return position;
    }

    public String remedy() {
        return remedy;
    }
}
