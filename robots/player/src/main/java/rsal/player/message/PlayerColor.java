package rsal.player.message;

/// A color, each share 0 to 255.
///
/// @param alpha 0 is opaque, 255 transparent
public record PlayerColor(int alpha, int red, int green, int blue) {}
