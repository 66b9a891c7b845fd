package rsal.stage.playercfg;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import rsal.settings.Location;

/// Where a device is, as `key:host:port:interface:index`; all but the last two may be left out, or be empty.
///
/// @param key which of its driver's places it takes, `odometry`; may be empty
/// @param host of the server; empty when it is this one
/// @param port of the server; empty when it is the one that the command line says
/// @param type its interface, `position2d`
/// @param index among the devices of its interface
public record DriverAddress(String key, String host, OptionalInt port, String type, int index, Location location) {
    /// On which a server listens that is not told otherwise.
    static final int USUAL_PORT = 6665;

    private static final int MOST_PORT = 65_535;
    private static final int MOST_INDEX = 65_535;
    private static final int PARTS = 5;

    /// @return empty when a text is not an address
    static Optional<DriverAddress> parse(String text, Location location) {
        List<String> parts = List.of(text.split(":", -1));
        int missing = PARTS - parts.size();
        if (parts.size() < 2 || missing < 0) {
            return Optional.empty();
        }
        String port = missing > 2 ? "" : parts.get(2 - missing);
        String type = parts.get(3 - missing);
        OptionalInt number = number(port, 1, MOST_PORT);
        OptionalInt index = number(parts.get(4 - missing), 0, MOST_INDEX);
        boolean whole = (port.isEmpty() || number.isPresent()) && !type.isEmpty() && index.isPresent();
        return whole
                ? Optional.of(new DriverAddress(
                        missing > 0 ? "" : parts.get(0),
                        missing > 1 ? "" : parts.get(1 - missing),
                        number,
                        type,
                        index.getAsInt(),
                        location))
                : Optional.empty();
    }

    private static OptionalInt number(String text, int least, int most) {
        try {
            int number = Integer.parseInt(text);
            return number >= least && number <= most ? OptionalInt.of(number) : OptionalInt.empty();
        } catch (NumberFormatException _) {
            return OptionalInt.empty();
        }
    }

    /// The same on a server's port, unless it names one, or another host.
    DriverAddress at(int usual) {
        return port.isPresent() || !isHere()
                ? this
                : new DriverAddress(key, host, OptionalInt.of(usual), type, index, location);
    }

    static boolean isPort(double number) {
        return number >= 1 && number <= MOST_PORT && number == Math.rint(number);
    }

    /// The port, when the command line says nothing.
    public int portOrUsual() {
        return port.orElse(USUAL_PORT);
    }

    public boolean isHere() {
        return host.isEmpty() || host.equals("localhost");
    }

    /// What it is on its server: `position2d:0`.
    public String device() {
        return type + ":" + index;
    }

    /// Without its key: `6665:position2d:0`.
    String place() {
        return (isHere() ? "" : host + ":") + portOrUsual() + ":" + device();
    }
}
