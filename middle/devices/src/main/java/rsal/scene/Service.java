package rsal.scene;

import java.util.List;
import java.util.Optional;

/// What the file of a world asks a robot server to offer at a port: devices of a driver.
///
/// @param driver `stage`, `amcl`
/// @param port of the server
/// @param devices that it offers there, `position2d:0`
/// @param needs devices of others that it works with, with their ports, `6665:laser:0`
/// @param robot whose devices they are, by id; empty when they are no robot's
public record Service(String driver, int port, List<String> devices, List<String> needs, Optional<String> robot) {
    public Service {
        devices = List.copyOf(devices);
        needs = List.copyOf(needs);
    }
}
