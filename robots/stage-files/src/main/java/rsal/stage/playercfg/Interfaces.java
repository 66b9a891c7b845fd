package rsal.stage.playercfg;

import java.util.Map;
import java.util.Set;
import rsal.stage.ModelKind;

/// Interfaces of devices, by the names that configurations use.
final class Interfaces {
    static final Set<String> ALL = Set.of(
            ("power gripper position2d sonar laser blobfinder ptz audio fiducial speech gps bumper dio aio ir wifi localize"
                            + " position3d simulation blinkenlight camera map planner log joystick speech_recognition opaque"
                            + " position1d actarray limb graphics2d rfid wsn graphics3d health imu pointcloud3d ranger"
                            + " vectormap blackboard stereo coopobject")
                    .split(" "));

    static final String SIMULATION = "simulation";

    /// Types of models that Stage serves, by interface.
    static final Map<String, String> MODELS = Map.of(
            "position2d", "position",
            "ranger", "ranger",
            "blobfinder", "blobfinder",
            "fiducial", "fiducial",
            "gripper", "gripper",
            "bumper", "bumper",
            "camera", "camera",
            "actarray", "actuator");

    /// What Stage serves of any model.
    static final Set<String> OF_ANY_MODEL = Set.of("speech", "graphics2d", "graphics3d");

    /// What to do about those that older versions of Stage served.
    static final Map<String, String> DROPPED = Map.of(
            "laser", "Provide a 'ranger', and add driver ( name \"rangertolaser\" ... ) for it.",
            "sonar", "Provide a 'ranger'.",
            "map", "Add driver ( name \"mapfile\" ... ).",
            "localize", "Add driver ( name \"amcl\" ... ).",
            "power", "Remove it.",
            "dio", "Remove it.",
            "ptz", "Remove it.",
            "wifi", "Remove it.");

    private Interfaces() {}

    /// How Stage calls a kind of model.
    static String typeOf(ModelKind kind) {
        return switch (kind) {
            case ModelKind.Position _ -> "position";
            case ModelKind.Ranger _ -> "ranger";
            case ModelKind.Blobfinder _ -> "blobfinder";
            case ModelKind.Fiducial _ -> "fiducial";
            case ModelKind.Gripper _ -> "gripper";
            case ModelKind.Bumper _ -> "bumper";
            case ModelKind.Actuator _ -> "actuator";
            case ModelKind.Camera _ -> "camera";
            case ModelKind.Blinkenlight _, ModelKind.LightIndicator _, ModelKind.Thing _ -> "model";
        };
    }
}
