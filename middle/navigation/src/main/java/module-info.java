/// Localization, planning and avoidance. The algorithms work on plain values and know nothing of devices, threads
/// or clocks; only `rsal.navigation.device` makes devices of them, which robot systems, agents and scenarios meet
/// through the contracts of `rsal.devices`.
module rsal.navigation {
    requires transitive rsal.devices;
    requires static org.jspecify;

    exports rsal.navigation.amcl;
    exports rsal.navigation.avoid;
    exports rsal.navigation.control;
    exports rsal.navigation.dwa;
    exports rsal.navigation.explore;
    exports rsal.navigation.grid;
    exports rsal.navigation.jumppoint;
    exports rsal.navigation.log;
    exports rsal.navigation.mpc;
    exports rsal.navigation.nd;
    exports rsal.navigation.parameter;
    exports rsal.navigation.passage;
    exports rsal.navigation.recovery;
    exports rsal.navigation.replay;
    exports rsal.navigation.rooms;
    exports rsal.navigation.scanmatch;
    exports rsal.navigation.slam;
    exports rsal.navigation.snd;
    exports rsal.navigation.spread;
    exports rsal.navigation.traffic;
    exports rsal.navigation.vfh;
    exports rsal.navigation.wavefront;

    uses rsal.navigation.control.ControllerType;
    uses rsal.navigation.control.GoalCheckerType;
    uses rsal.navigation.control.PlannerType;
    uses rsal.navigation.control.ProgressCheckerType;
    uses rsal.navigation.log.LogFormat;
    uses rsal.navigation.recovery.RecoveryType;
    uses rsal.navigation.traffic.TrafficType;

    provides rsal.navigation.control.ControllerType with
            rsal.navigation.control.DwaControllerType,
            rsal.navigation.control.MpcControllerType,
            rsal.navigation.control.NdControllerType,
            rsal.navigation.control.SndControllerType,
            rsal.navigation.control.VfhControllerType;
    provides rsal.navigation.control.GoalCheckerType with
            rsal.navigation.control.StoppedGoalCheckerType,
            rsal.navigation.control.ToleranceGoalCheckerType;
    provides rsal.navigation.control.PlannerType with
            rsal.navigation.control.JumpPointPlannerType,
            rsal.navigation.control.WavefrontPlannerType;
    provides rsal.navigation.control.ProgressCheckerType with
            rsal.navigation.control.MovementProgressCheckerType,
            rsal.navigation.control.PathProgressCheckerType;
    provides rsal.navigation.log.LogFormat with
            rsal.navigation.carmen.CarmenFormat;
    provides rsal.navigation.recovery.RecoveryType with
            rsal.navigation.recovery.BackUpRecoveryType,
            rsal.navigation.recovery.LookAroundRecoveryType,
            rsal.navigation.recovery.MultiPointTurnRecoveryType,
            rsal.navigation.recovery.SpinRecoveryType,
            rsal.navigation.recovery.TurnAroundRecoveryType,
            rsal.navigation.recovery.WaitRecoveryType;
    provides rsal.navigation.traffic.TrafficType with
            rsal.navigation.traffic.NoTrafficType,
            rsal.navigation.traffic.CentralTrafficType,
            rsal.navigation.traffic.RightOfWayType;
    provides rsal.robot.DeviceDriver with
            rsal.navigation.device.AmclDriver,
            rsal.navigation.device.ExploredDriver,
            rsal.navigation.device.ExplorerDriver,
            rsal.navigation.device.JumpPointDriver,
            rsal.navigation.device.NavigatorDriver,
            rsal.navigation.device.OdometryLocalizerDriver,
            rsal.navigation.device.PlacesDriver,
            rsal.navigation.device.SlamDriver,
            rsal.navigation.device.WavefrontDriver;
}
