package rsal.fault;

import java.util.Optional;
import java.util.random.RandomGenerator;
import rsal.device.Subscription;

/// Brings faults about in the robots of a robot system. All calls on the scheduler's thread.
public interface FaultInjection {
    /// Why a fault can't be had, in a sentence; empty when it can. May be asked before the system has started.
    ///
    /// @param device name within the robot (`laser`); empty when the whole robot is meant
    Optional<String> refusal(String robot, String device, Fault fault);

    /// Begins a fault. Several at once add up.
    ///
    /// @param device name within the robot (`laser`); empty when the whole robot is meant
    /// @param random a stream of this fault's own
    /// @return ends it; a robot that was gone may have to wait for room until it appears
    /// @throws IllegalArgumentException when there is a [#refusal]
    Subscription begin(String robot, String device, Fault fault, RandomGenerator random);
}
