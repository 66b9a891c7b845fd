package rsal.scenario;

import java.util.List;
import java.util.function.Predicate;
import rsal.scenario.RunPlan.Mas;
import rsal.scenario.RunPlan.Mrs;
import rsal.settings.Location;
import rsal.settings.Problems;

/// Finds what can't be part of a run whose time is driven by a robot system: what needs real time, and a second system
/// that drives it.
final class DrivenTimeChecker {
    private final Location location;
    private final Problems problems;

    /// @param location of what names the robot systems
    DrivenTimeChecker(Location location, Problems problems) {
        this.location = location;
        this.problems = problems;
    }

    void check(List<Mrs> systems, Mas mas) {
        List<Mrs> driving = systems.stream().filter(DrivenTimeChecker::drives).toList();
        if (driving.isEmpty()) {
            return;
        }
        if (driving.size() > 1) {
            problems.add(
                    location,
                    "The time of a run can follow one simulator only, but it should follow those of '%s' and '%s'."
                            .formatted(driving.get(0).words(), driving.get(1).words()),
                    "");
        }
        String key = driving.getFirst().provider().key();
        Predicate<Mrs> needsRealTime =
                system -> !drives(system) && !system.provider().followsSchedulerTime();
        systems.stream()
                .filter(needsRealTime)
                .findFirst()
                .ifPresent(real -> problems.add(
                        location,
                        "The run follows the time of another simulator ('%s'), but robots of '%s' need real time."
                                .formatted(key, real.words()),
                        "Use simulated robots beside it, or leave that time out."));
        if (!mas.provider().followsSchedulerTime()) {
            problems.add(
                    location,
                    "The run follows the time of another simulator ('%s'), but the multi-agent system '%s' needs real time."
                            .formatted(key, mas.provider().key()),
                    "Use another multi-agent system, or leave that time out.");
        }
    }

    static boolean drives(Mrs system) {
        return system.provider().drivesTime(system.settings());
    }
}
