package rsal.engine.operator;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import rsal.agent.message.GoalReached;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Navigator;
import rsal.device.Navigator.Result;
import rsal.engine.agent.Agents;
import rsal.engine.arbitration.CommandArbiter;
import rsal.engine.arbitration.Teleoperation;
import rsal.engine.communication.Faults;
import rsal.engine.event.EventLog;
import rsal.engine.report.Answer;
import rsal.engine.report.SentGoal.Status;
import rsal.engine.report.Words;
import rsal.engine.robot.RobotTeam;
import rsal.engine.world.SimulatedWorld;

/// What people tell robots to do, and all of them to stop. All calls on the run's thread.
public final class RobotCommands {
    private final OccupancyGrid map;
    private final EventLog eventLog;
    private final Faults faults;
    private final SimulatedWorld world;
    private final RobotTeam team;
    private final Agents agents;
    private final SentGoals goals;
    private boolean stopped;
    private boolean armed; // by people, and not stopped since

    public RobotCommands(
            OccupancyGrid map,
            EventLog eventLog,
            Faults faults,
            SimulatedWorld world,
            RobotTeam team,
            Agents agents,
            SentGoals goals) {
        this.map = map;
        this.eventLog = eventLog;
        this.faults = faults;
        this.world = world;
        this.team = team;
        this.agents = agents;
        this.goals = goals;
    }

    /// Has a robot drive somewhere: by an agent, if it has a navigator and one takes such orders; else its agents wait
    /// until it is there.
    ///
    /// @param given when somebody said so [ns]
    /// @return [Answer.Sent], or why not
    public Answer goTo(String id, Pose2d mapFromGoal, long given) {
        Optional<Answer> nobody = nobody(id);
        if (nobody.isPresent()) {
            return nobody.get();
        }
        Optional<Answer> refused = notFree(mapFromGoal.position());
        if (refused.isPresent()) {
            return refused.get();
        }
        boolean navigates =
                team.robot(id).flatMap(robot -> robot.find(Navigator.class)).isPresent();
        return navigates && agents.takeOrdersFor(id)
                ? askAgent(id, mapFromGoal, given)
                : command(id, reported -> send(reported, id, mapFromGoal, given));
    }

    private Answer send(Teleoperation reported, String id, Pose2d mapFromGoal, long given) {
        return switch (reported.navigator(given)) {
            case Teleoperation.Navigation.Refused(Answer why) -> why;
            case Teleoperation.Navigation.Ready(Navigator navigator) -> {
                int goal = goals.send(id, mapFromGoal);
                reported.goTo(navigator, mapFromGoal, result -> ended(goal, result));
                yield new Answer.Sent(goal);
            }
        };
    }

    private void ended(int goal, Result result) {
        switch (result) {
            case Result.Reached reached when reached.isSure() -> goals.end(goal, Status.SUCCEEDED, "");
            case Result.Cancelled(String why) -> goals.end(goal, Status.CANCELED, why);
            case Result.Reached _, Result.NoPath _, Result.Stuck _ -> goals.end(goal, Status.ABORTED, Words.of(result));
        }
    }

    private void ended(int goal, GoalReached end) {
        if (end.reached()) {
            goals.end(goal, Status.SUCCEEDED, "");
        } else if (end.cancelled()) {
            goals.end(goal, Status.CANCELED, "The robot's agent called it off.");
        } else {
            goals.end(goal, Status.ABORTED, end.outcome());
        }
    }

    /// Why nothing can be there, by the map.
    private Optional<Answer> notFree(Point2d place) {
        int column = map.column(place.x());
        int row = map.row(place.y());
        String where = place.rounded();
        if (!map.contains(column, row)) {
            return Optional.of(new Answer.Refused("%s is outside the map.".formatted(where)));
        }
        return switch (map.at(column, row)) {
            case OccupancyGrid.FREE -> Optional.empty();
            case OccupancyGrid.UNKNOWN ->
                Optional.of(new Answer.Refused("%s is in unknown space of the map.".formatted(where)));
            default -> Optional.of(new Answer.Refused("There is a wall at %s.".formatted(where)));
        };
    }

    private Answer askAgent(String id, Pose2d mapFromGoal, long given) {
        Optional<Answer> refused = team.teleoperation(id).flatMap(reported -> reported.leave(given));
        if (refused.isPresent()) {
            return refused.get();
        }
        int goal = goals.send(id, mapFromGoal);
        agents.ask(id, mapFromGoal, end -> ended(goal, end));
        return new Answer.Sent(goal);
    }

    public Answer abilities(String id) {
        return command(id, reported -> new Answer.Able(reported.abilities()));
    }

    /// @param given when somebody said so [ns]
    public Answer behave(String id, String behavior, long given) {
        Answer answer = command(id, reported -> reported.behave(behavior, given));
        if (answer instanceof Answer.Done) {
            goals.cancel(id, behavior.isEmpty() ? "It was told nothing any more." : "It was told to " + behavior + ".");
        }
        return answer;
    }

    /// @param heard when its driver said so [ns]
    public Answer drive(String id, String driver, Twist2d velocity, long heard) {
        return velocity.isFinite()
                ? command(id, reported -> reported.drive(driver, velocity, heard))
                : new Answer.Refused("A velocity must be finite, not '%s'.".formatted(velocity));
    }

    public Answer letGo(String id, String driver) {
        return command(id, reported -> reported.letGo(driver));
    }

    private Answer command(String id, Function<Teleoperation, Answer> order) {
        return nobody(id)
                .or(() -> team.teleoperation(id).map(order))
                .orElseGet(() -> new Answer.Refused("Robot '%s' has no drive.".formatted(id)));
    }

    /// Says why a robot can't be told anything at all, if so.
    private Optional<Answer> nobody(String id) {
        if (!team.has(id)) {
            return Optional.of(world.unknown(id));
        }
        return faults.isGone(id)
                ? Optional.of(new Answer.Refused("Robot '%s' is gone.".formatted(id)))
                : Optional.empty();
    }

    /// Lets those who are driven by hand go on, as long as their drivers are heard.
    ///
    /// @param now [ns]
    public void beat(long now) {
        team.teleoperation().forEach(reported -> reported.beat(now));
    }

    /// Switches all motors off.
    public Answer stop() {
        stopped = true;
        armed = false;
        team.teleoperation().forEach(Teleoperation::stop);
        eventLog.event("operator", "", "emergency stop");
        return new Answer.Stopped(team.teleoperation().size());
    }

    /// Switches them on again, but for those of robots that somebody has switched off one by one, before or meanwhile:
    /// there was another reason for that.
    public Answer rearm() {
        stopped = false;
        armed = true;
        arbiters().forEach(CommandArbiter::rearm);
        List<String> off = team.robots().keySet().stream()
                .filter(id -> team.teleoperation(id)
                        .filter(reported -> reported.arbiter().isSwitchedOff())
                        .isPresent())
                .toList();
        eventLog.event(
                "operator", "", off.isEmpty() ? "motors on" : "motors on, but not those of " + String.join(", ", off));
        return new Answer.Armed(team.teleoperation().size() - off.size(), off);
    }

    /// Switches those of one robot: it alone stands, or it alone may move while the others stand.
    public Answer stop(String id, boolean stop) {
        return command(id, reported -> {
            if (stop) {
                reported.switchOff();
            } else {
                reported.arbiter().switchOn();
            }
            stopped &= arbiters().anyMatch(CommandArbiter::isStopped);
            eventLog.event("operator", id, stop ? "motors off" : "motors on");
            return new Answer.Done();
        });
    }

    private Stream<CommandArbiter> arbiters() {
        return team.teleoperation().stream().map(Teleoperation::arbiter);
    }

    /// Motors are off from the beginning, as after an emergency stop, where robots are not armed by themselves:
    /// real ones move only when somebody wants them to.
    public void begin() {
        stopped = team.robots().values().stream()
                .flatMap(robot -> robot.find(DriveBase.class).stream())
                .anyMatch(base -> !base.enabled());
        if (stopped) {
            team.teleoperation().forEach(Teleoperation::stop);
            eventLog.event("operator", "", "motors are off until somebody switches them on");
        }
    }

    /// Whether the emergency stop holds for all robots.
    public boolean stopped() {
        return stopped && arbiters().allMatch(CommandArbiter::isOff);
    }

    /// A robot has left.
    public void left(String robot) {
        goals.abort(robot, "The robot left.");
    }

    /// A robot has joined. It stands still, too, while the emergency stop holds. If it came with its motors off, they
    /// stay off until people arm the robots, and are switched on if they have done so before.
    public void joined(String robot) {
        boolean cameOff = team.robot(robot)
                .flatMap(one -> one.find(DriveBase.class))
                .filter(base -> !base.enabled())
                .isPresent();
        if (stopped || (cameOff && !armed)) {
            team.teleoperation(robot).ifPresent(Teleoperation::stop);
            if (!stopped) {
                eventLog.event("operator", robot, "motors are off until somebody switches them on");
                stopped = arbiters().allMatch(CommandArbiter::isOff);
            }
        } else if (cameOff) {
            team.teleoperation(robot).map(Teleoperation::arbiter).ifPresent(CommandArbiter::rearm);
            eventLog.event("operator", robot, "motors on, as those of the other robots");
        }
    }
}
