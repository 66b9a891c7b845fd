package rsal.scene;

import rsal.data.Prism;

/// A piece of a body with what others make of it.
///
/// @param prism in the body's frame; its own color counts no more
public record Block(Prism prism, Surface surface) {}
