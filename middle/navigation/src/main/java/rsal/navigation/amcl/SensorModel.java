package rsal.navigation.amcl;

/// How likely it is to see what was seen from a pose. May be shared by threads.
public sealed interface SensorModel permits LikelihoodField, BeamModel {
    /// Logarithm of the likelihood of all beams, seen from a pose in the map frame [m, rad]; 0 is the most there is.
    double log(Beams beams, double x, double y, double theta);

    /// Which model to use.
    enum Kind {
        /// How near beams end to walls: fast, and smooth.
        FIELD,
        /// How far beams should reach: knows what walls hide, costs a ray for each beam and particle.
        BEAM
    }
}
