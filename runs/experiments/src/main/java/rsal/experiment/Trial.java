package rsal.experiment;

/// One run of an experiment.
///
/// @param number from 1, in the order of the design
public record Trial(int number, Combination combination, long seed) {}
