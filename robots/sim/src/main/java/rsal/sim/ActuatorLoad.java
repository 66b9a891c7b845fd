package rsal.sim;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.device.SimulationControl.Carried;
import rsal.robot.RobotModel;
import rsal.robot.Shift;
import rsal.scene.Block;

/// What stands on one actuator of a robot.
///
/// @param devices by name
/// @param pieces of the body, by number from 0
record ActuatorLoad(List<String> devices, List<Integer> pieces, DeviceMount mount) {

    /// @param blocks of the body
    static List<ActuatorLoad> of(SimRobot robot, List<Block> blocks) {
        RobotModel model = robot.spec().model();
        var actuators = new LinkedHashMap<String, SimActuator>();
        robot.devices().forEach(device -> {
            if (device instanceof SimActuator actuator) {
                actuators.put(actuator.info().name(), actuator);
            }
        });
        var loads = new ArrayList<ActuatorLoad>();
        for (Map.Entry<String, SimActuator> carrier : actuators.entrySet()) {
            String name = carrier.getKey();
            var chain = new ArrayList<SimActuator>();
            model.carriersOf(name).forEach(own -> chain.add(actuators.get(own)));
            chain.add(carrier.getValue());
            List<String> devices = model.sensors().keySet().stream()
                    .filter(device -> name.equals(model.carriers().get(device)))
                    .toList();
            var pieces = new ArrayList<Integer>();
            for (int i = 0; i < blocks.size(); i++) {
                if (blocks.get(i).carrier().filter(name::equals).isPresent()) {
                    pieces.add(i);
                }
            }
            if (!devices.isEmpty() || !pieces.isEmpty()) {
                loads.add(new ActuatorLoad(devices, List.copyOf(pieces), new DeviceMount(List.copyOf(chain))));
            }
        }
        return List.copyOf(loads);
    }

    /// Where those are that have been carried somewhere.
    static List<Carried> carried(List<ActuatorLoad> loads) {
        if (loads.isEmpty()) {
            return List.of();
        }
        var carried = new ArrayList<Carried>();
        for (ActuatorLoad load : loads) {
            Shift shift = load.mount.now();
            if (!shift.isNone()) {
                carried.add(new Carried(load.devices, load.pieces, shift.baseFromMoved(), shift.rise()));
            }
        }
        return List.copyOf(carried);
    }
}
