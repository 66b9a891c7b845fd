package rsal.stage;

/// Of a box that holds a model: along x, y and z of its frame [m]; none negative.
public record Size(double x, double y, double z) {
    static final Size NONE = new Size(0, 0, 0);
}
