package rsal.player.message;

/// How large something is [m].
///
/// @param width along y
/// @param length along x
public record Box3(double width, double length, double height) {}
