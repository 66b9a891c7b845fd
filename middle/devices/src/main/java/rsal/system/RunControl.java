package rsal.system;

import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import rsal.data.Pose2d;
import rsal.device.GoalHandle;
import rsal.device.SimulationControl.Placement;

/// What programs may do to a run over a [Bridge], as people do: they pause it, step it, end it, and change
/// its simulated world. What is done to the world is an event of the run. Called on the run's thread, except
/// [#execute].
public interface RunControl extends Executor {
    /// Does something on the run's thread between two steps, also while the run is paused. Any thread may
    /// call. What comes after the end is dropped.
    @Override
    void execute(Runnable work);

    /// Whether the run's time is simulated: only such a run can be paused and stepped.
    boolean isPausable();

    boolean isPaused();

    /// Lets time stand still from the next step on. Does nothing where it can't be paused.
    ///
    /// @return when time stands still, or has been resumed before
    CompletionStage<Void> pause();

    void resume();

    /// Ends the run with the next step.
    void end();

    /// Goes on for some steps, then the run is paused again. One such order at a time.
    ///
    /// @param count from 1
    /// @return after each step, how many were made; at the end, how many there were: fewer when it was
    ///         canceled or the run was resumed
    /// @throws IllegalStateException when the run is not paused, or still makes steps
    GoalHandle<Long, Long> step(long count);

    /// What can be put into the simulated world.
    List<Spawnable> spawnables();

    /// Whether something new can have a name: nothing has it, and no robot had it.
    boolean isFree(String name);

    /// Puts something new into the simulated world.
    ///
    /// @param kind name of one of the [#spawnables]
    /// @param name one that [#isFree]
    Placement spawn(String kind, String name, Pose2d mapFromEntity);

    /// Puts a robot or a thing somewhere, standing still. The robot's localizer gets the new pose.
    Placement place(String entity, Pose2d mapFromEntity);

    /// Takes a robot with its agents, or a thing, out of the simulated world.
    Placement remove(String entity);

    /// Removes all that was put there by [#spawn] of this control.
    void removeSpawned();

    /// Puts robots and things back where they were when the run began, standing still. Localizers get these
    /// poses. Time, agents, batteries and actuators stay as they are.
    ///
    /// @return names of those that were removed since then, and so stay away
    List<String> restore();

    /// A kind of robots or things.
    ///
    /// @param name `pioneer2dx`
    /// @param description a sentence
    record Spawnable(String name, String description, boolean isRobot) {}
}
