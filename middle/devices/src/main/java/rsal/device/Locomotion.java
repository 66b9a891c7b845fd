package rsal.device;

/// What a device is, besides, that moves its whole robot: a base, and all that drives one. Two agents that
/// command such devices of one robot would take it from each other again and again.
public interface Locomotion {}
