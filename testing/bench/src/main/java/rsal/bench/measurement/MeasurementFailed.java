package rsal.bench.measurement;

/// What was to be measured did not happen, such as an answer within a minute. The message says what.
public final class MeasurementFailed extends RuntimeException {
    private static final long serialVersionUID = 1;

    public MeasurementFailed(String message) {
        super(message);
    }
}
