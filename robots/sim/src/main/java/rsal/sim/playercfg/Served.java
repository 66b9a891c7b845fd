package rsal.sim.playercfg;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import rsal.scene.Service;
import rsal.sim.stage.Findings;
import rsal.sim.stage.Kind;
import rsal.sim.stage.StageModel;
import rsal.sim.stage.StageWorld;

/// Finds out which models of a world a configuration's drivers serve.
final class Served {
    private static final int MOST_NAMED = 8; // of models in a message

    private final StageWorld world;
    private final Findings findings;
    private final Map<String, StageModel> models = new LinkedHashMap<>();
    private final Map<String, String> robots = new HashMap<>(); // that models are part of, by the names of both

    Served(StageWorld world, Findings findings) {
        this.world = world;
        this.findings = findings;
        world.forEach(model -> models.put(model.name(), model));
        world.models().forEach(this::findRobots);
    }

    private void findRobots(StageModel model) {
        if (model.traits().kind() instanceof Kind.Position) {
            model.forEach(part -> robots.put(part.name(), model.name().replace('/', '.')));
        } else {
            model.children().forEach(this::findRobots);
        }
    }

    /// What a driver serves, by port.
    ///
    /// @param simulates whether it serves models of the world
    List<Service> of(Driver driver, boolean simulates) {
        Optional<String> robot = simulates ? model(driver).flatMap(base -> serve(driver, base)) : Optional.empty();
        var byPort = new LinkedHashMap<Integer, List<String>>();
        for (Address address : driver.provides()) {
            byPort.computeIfAbsent(address.portOrUsual(), _ -> new ArrayList<>())
                    .add(address.device());
        }
        List<String> needs = driver.requires().stream().map(Address::place).toList();
        return byPort.entrySet().stream()
                .map(port -> new Service(driver.name(), port.getKey(), port.getValue(), needs, robot))
                .toList();
    }

    private Optional<StageModel> model(Driver driver) {
        boolean plain = driver.provides().stream().allMatch(a -> a.type().equals(Interfaces.SIMULATION));
        Optional<Driver.Option> option = driver.option("model");
        if (option.isEmpty()) {
            if (!plain) {
                findings.error(
                        driver.location(),
                        "This (stage) does not say which (model) it serves.",
                        "Write model \"NAME\", with a model of the world.");
            }
            return Optional.empty();
        }
        Optional<String> name = ConfigReader.text(option.get().value());
        Optional<StageModel> model = name.map(models::get);
        if (model.isEmpty()) {
            findings.error(
                    option.get().value().location(),
                    "There is no model %s in (%s)."
                            .formatted(
                                    Findings.shortened(option.get().value().describe()),
                                    Findings.shortened(world.title())),
                    name.map(this::remedy).orElse("Write model \"NAME\"."));
        }
        return model;
    }

    private String remedy(String read) {
        String some = world.models().stream()
                .map(StageModel::name)
                .limit(MOST_NAMED)
                .map(Findings::shortened)
                .collect(Collectors.joining(", "));
        return findings.maybe(
                read,
                models.keySet(),
                "It has %s%s.".formatted(some, world.models().size() > MOST_NAMED ? ", …" : ""));
    }

    /// Each interface serves the first model of its type, at or below the base, that no other of the driver does.
    ///
    /// @return the robot that they are part of
    private Optional<String> serve(Driver driver, StageModel base) {
        Set<String> used = new HashSet<>();
        for (Address address : driver.provides()) {
            String type = Interfaces.MODELS.get(address.type());
            if (type != null && !use(base, type, used)) {
                findings.error(
                        address.location(),
                        "(%s) has no model of type (%s)%s for (%s)."
                                .formatted(
                                        Findings.shortened(base.name()),
                                        type,
                                        use(base, type, new HashSet<>()) ? " left" : "",
                                        address.device()),
                        "Add one to it in the world, or leave the interface out.");
            }
        }
        Optional<String> robot = Optional.ofNullable(robots.get(base.name()));
        if (robot.isEmpty()) {
            findings.warn(
                    driver.location(),
                    "(%s) is part of no robot; it has no devices in a run.".formatted(Findings.shortened(base.name())),
                    "");
        }
        return robot;
    }

    private static boolean use(StageModel model, String type, Set<String> used) {
        if (type.equals(Interfaces.typeOf(model.traits().kind())) && used.add(model.name())) {
            return true;
        }
        for (StageModel child : model.children()) {
            if (use(child, type, used)) {
                return true;
            }
        }
        return false;
    }
}
