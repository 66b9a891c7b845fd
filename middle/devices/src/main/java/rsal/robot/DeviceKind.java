package rsal.robot;

import rsal.device.Device;
import rsal.settings.Plugin;

/// A kind of devices that robots carry, as an IMU: registered once, by [java.util.ServiceLoader], and known
/// everywhere. Part files name it as their `type` and set its parameters. Its readings are records: recordings,
/// tables and the page take their fields from them. Faults can silence or freeze it; errors can be added to
/// readings that are [rsal.data.Perturbable].
///
/// Who makes its devices is registered by the robot system, as that of the simulator by
/// `rsal.sim.device.SimulatedKind`.
public interface DeviceKind extends Plugin {
    /// The contract that its devices fulfil.
    Class<? extends Device> makes();

    /// What its devices read: a record of numbers, flags, texts, words of an enumeration, arrays of numbers, or
    /// of records and lists of records of these.
    Class<? extends Record> reads();
}
