package rsal.ros2.simulation;

import rsal.device.SimulationControl.Placement;
import rsal.ros2.cdr.CdrWriter;

/// `simulation_interfaces/Result`: what became of a request.
///
/// @param code one of these, or above 100 one of the service's own
/// @param why a sentence for people; empty when all is well
record ResultCode(int code, String why) {
    static final ResultCode OK = new ResultCode(1, "");

    static ResultCode unsupported(String why) {
        return new ResultCode(0, why);
    }

    static ResultCode notFound(String why) {
        return new ResultCode(2, why);
    }

    static ResultCode incorrectState(String why) {
        return new ResultCode(3, why);
    }

    static ResultCode failed(String why) {
        return new ResultCode(4, why);
    }

    static ResultCode of(Placement placement) {
        return placement instanceof Placement.Refused(String why) ? failed(why) : OK;
    }

    CdrWriter write(CdrWriter to) {
        return to.int8((byte) code).text(why);
    }

    /// A response that has nothing else.
    byte[] toBytes() {
        return write(new CdrWriter()).toBytes();
    }
}
