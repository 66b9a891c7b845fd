package rsal.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.scenario.RobotReader.Role;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Section;
import rsal.settings.Suggestion;

/// What robots of a scenario can be called by: their roles and ids.
///
/// @param open whether there may be more of them, in a world with errors: then no name is wrong
record RobotNames(List<Role> roles, boolean open) {
    /// Whether an error may have hidden any of them.
    boolean mayLackSome() {
        return open || !roles.stream().allMatch(Role::complete);
    }

    /// Those of one role.
    Optional<Role> role(String name) {
        return roles.stream().filter(role -> role.name().equals(name)).findFirst();
    }

    /// Notes each argument that should name robots and names none.
    ///
    /// @param section that the arguments were read from
    void check(Section section, List<Parameter<?>> parameters, Arguments arguments) {
        for (Parameter<?> parameter : parameters) {
            parameter.ofRobots().ifPresent(robots -> check(section, robots, arguments.get(robots)));
        }
    }

    private void check(Section section, Parameter<?> parameter, String name) {
        var known = new ArrayList<>(roles.stream().map(Role::name).toList());
        if (parameter.options().contains(name) || known.contains(name) || mayBeUnread(name)) {
            return;
        }
        var ids = roles.stream()
                .flatMap(role -> role.robots().stream())
                .map(robot -> robot.spec().id())
                .toList();
        if (!ids.contains(name)) {
            ids.stream()
                    .filter(id -> Suggestion.closest(name, List.of(id)).isPresent())
                    .forEach(known::add);
            section.problem(
                    parameter.name(),
                    "'%s' must be %s, not '%s'.".formatted(section.path(parameter.name()), parameter.expected(), name),
                    Suggestion.among(name, known));
        }
    }

    /// An error elsewhere can have hidden robots.
    private boolean mayBeUnread(String name) {
        return open || roles.stream().anyMatch(role -> !role.complete() && name.startsWith(role.name()));
    }
}
