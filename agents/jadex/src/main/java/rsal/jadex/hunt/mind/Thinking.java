package rsal.jadex.hunt.mind;

/// What a hunter tells its mind. Any thread may call these; the mind thinks of it later, in that order.
public interface Thinking {
    /// Whether it knows where the prey is.
    void knowsPrey(boolean known);

    void preyIsCaught();
}
