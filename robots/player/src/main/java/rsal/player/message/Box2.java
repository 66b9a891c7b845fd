package rsal.player.message;

/// How large something flat is [m].
///
/// @param width along y
/// @param length along x
public record Box2(double width, double length) {}
