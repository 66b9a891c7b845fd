package rsal.scenario.condition;

/// What is known of a run at an instant: all that a condition can ask.
public interface Facts {
    /// Simulated time since the start [s].
    double time();

    /// Touches so far, with walls and with each other, of robots that are simulated here; NaN when none is, as
    /// nobody counts those of others.
    double collisions();

    /// Touches so far of walls (and of all else that is no robot); likewise.
    double wallCollisions();

    /// How many robots a role has.
    int robots(String role);

    /// How many robots of a role have been caught so far: said so, and it was true.
    int caught(String role);

    /// How many robots of a role have reached the place where they were sent last.
    int arrived(String role);

    /// How many robots of a role are gone now, by a fault.
    int gone(String role);

    /// How many faults have begun so far, each counted once for each device, robot or kind of messages that has it.
    long faults();

    /// How many messages were said so far, each counted once, however many hear it.
    long messages();

    /// How many messages were heard so far, each counted once for each agent that heard it.
    long heardMessages();

    /// How many messages were lost so far, each counted once for each agent that did not hear it.
    long lostMessages();

    /// Share of the floor that robots can get to which is free on the maps that they draw, 0 to 1; NaN while there is
    /// no such map in the frame of the world, or no truth to compare with.
    double explored();

    /// How many things of a group there are and will be.
    int things(String group);

    /// How many things of a group lie in their depot, in truth.
    int collected(String group);

    /// How many things of a group somebody has found: said where they are, and was right by a meter.
    int found(String group);

    /// How many things of a group a robot has got to that was to, in truth.
    int reached(String group);

    /// For how long a formation was not in place so far, from when it was first told until now [s].
    double forming();

    /// How many robots of a role draw a map and can still get to where it ends.
    int exploring(String role);

    /// How many messages of a topic were said so far.
    long messages(String topic);

    /// How many of a topic were heard so far, as [#heardMessages()] counts.
    long heardMessages(String topic);

    /// How many of a topic were lost so far, as [#lostMessages()] counts.
    long lostMessages(String topic);

    /// How far the two nearest robots of two roles truly are from each other now [m]; NaN while there are no
    /// two.
    double distance(String role, String other);

    /// How many robots of a role truly are in a place now.
    int within(String role, String place);

    /// How often robots of a role have truly come into a place so far; who starts there has not come.
    int visits(String role, String place);

    /// What an agent published last under a name; NaN before the first.
    double metric(String name);
}
