package rsal.scenario;

import java.time.Duration;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import rsal.settings.Location;

/// What somebody who starts a run wants otherwise than its scenario says.
///
/// @param configuration empty for the first
/// @param arguments by name, as typed
/// @param mas key of an agent host
/// @param mrs key of a robot system
/// @param clock `simulated` or `wall`
/// @param with a scenario that joins it, `distribution` or `distribution:found`
/// @param limit simulated time after which the run ends
/// @param speed simulated over real time; +∞ for as fast as it can
public record RunOptions(
        Optional<String> configuration,
        Map<String, String> arguments,
        OptionalLong seed,
        Optional<String> mas,
        Optional<String> mrs,
        Optional<String> clock,
        Optional<String> with,
        Optional<Duration> limit,
        OptionalDouble speed) {
    public static final RunOptions NONE = new RunOptions(
            Optional.empty(),
            Map.of(),
            OptionalLong.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty());

    public RunOptions {
        arguments = Collections.unmodifiableMap(new LinkedHashMap<>(arguments));
    }

    public RunOptions withConfiguration(String name) {
        return new RunOptions(Optional.of(name), arguments, seed, mas, mrs, clock, with, limit, speed);
    }

    public RunOptions withArguments(Map<String, String> typed) {
        return new RunOptions(configuration, typed, seed, mas, mrs, clock, with, limit, speed);
    }

    /// The same with the value that the scenario has for an argument.
    RunOptions withoutArgument(String name) {
        var others = new LinkedHashMap<>(arguments);
        others.remove(name);
        return withArguments(others);
    }

    public RunOptions withSeed(long number) {
        return new RunOptions(configuration, arguments, OptionalLong.of(number), mas, mrs, clock, with, limit, speed);
    }

    public RunOptions withHost(String key) {
        return new RunOptions(configuration, arguments, seed, Optional.of(key), mrs, clock, with, limit, speed);
    }

    /// On the agent host and by the clock that the scenario names.
    public RunOptions onItsHost() {
        return new RunOptions(
                configuration, arguments, seed, Optional.empty(), mrs, Optional.empty(), with, limit, speed);
    }

    /// In real time, on another agent host.
    public RunOptions inRealTimeOn(String host) {
        return new RunOptions(
                configuration, arguments, seed, Optional.of(host), mrs, Optional.of("wall"), with, limit, speed);
    }

    /// @param scenario that joins it
    public RunOptions withJoined(String scenario) {
        return new RunOptions(configuration, arguments, seed, mas, mrs, clock, Optional.of(scenario), limit, speed);
    }

    public RunOptions withLimit(Duration time) {
        return new RunOptions(configuration, arguments, seed, mas, mrs, clock, with, Optional.of(time), speed);
    }

    public RunOptions withSpeed(double factor) {
        return new RunOptions(configuration, arguments, seed, mas, mrs, clock, with, limit, OptionalDouble.of(factor));
    }

    /// Where errors about an argument are reported to be that was typed.
    public Location locationOf(String argument) {
        return Location.of("--set " + argument + "=" + arguments.get(argument));
    }
}
