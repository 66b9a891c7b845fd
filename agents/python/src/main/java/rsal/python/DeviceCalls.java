package rsal.python;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.behavior.Pilot;
import rsal.device.Actuator;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.Docking;
import rsal.device.DriveBase;
import rsal.device.FiducialFinder;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Light;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.device.Sensor;
import rsal.device.SonarArray;
import rsal.robot.DeviceKind;
import rsal.robot.DeviceKinds;

/// The contracts of devices, by which Python calls them: each method of such an interface, by its name and the number
/// of
/// its arguments.
final class DeviceCalls {
    private static final SortedMap<String, Class<? extends Device>> CONTRACTS = contracts();

    private DeviceCalls() {}

    private static SortedMap<String, Class<? extends Device>> contracts() {
        var all = new TreeMap<String, Class<? extends Device>>();
        for (Class<? extends Device> contract : List.of(
                Actuator.class,
                Battery.class,
                BlobFinder.class,
                Bumper.class,
                Docking.class,
                DriveBase.class,
                FiducialFinder.class,
                Gripper.class,
                LaserScanner.class,
                Light.class,
                Localizer.class,
                Mapper.class,
                Navigator.class,
                Pilot.class,
                PlaceFinder.class,
                Planner.class,
                SonarArray.class)) {
            all.put(contract.getSimpleName(), contract);
        }
        DeviceKinds.all().stream().map(DeviceKind::makes).forEach(kind -> all.put(kind.getSimpleName(), kind));
        return all;
    }

    /// Those of robots, by the names that Python has for them.
    static SortedMap<String, Class<? extends Device>> all() {
        return CONTRACTS;
    }

    /// What a device can be called as.
    static List<String> of(Device device) {
        return CONTRACTS.entrySet().stream()
                .filter(contract -> contract.getValue().isInstance(device))
                .map(Map.Entry::getKey)
                .toList();
    }

    /// Calls a method of a device's contracts.
    ///
    /// @return what it returns; empty for nothing
    /// @throws IllegalArgumentException when it has none such, or can't do that
    static Optional<Object> call(Device device, String name, List<?> words) {
        Method method = methods(device.getClass()).stream()
                .filter(each -> each.getName().equals(name) && each.getParameterCount() == words.size())
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("Device '%s' has no '%s' with %d arguments."
                        .formatted(device.info().id(), name, words.size())));
        var arguments = new ArrayList<@Nullable Object>();
        for (int i = 0; i < words.size(); i++) {
            arguments.add(FromWords.value(words.get(i), method.getGenericParameterTypes()[i]));
        }
        try {
            return Optional.ofNullable(method.invoke(device, arguments.toArray()));
        } catch (InvocationTargetException e) {
            if (e.getTargetException() instanceof RuntimeException why) {
                throw why;
            }
            throw new IllegalStateException(e.getTargetException());
        } catch (IllegalAccessException e) {
            throw new IllegalArgumentException("Python can't call '%s'.".formatted(name), e);
        }
    }

    private static final ClassValue<List<Method>> METHODS = new ClassValue<>() {
        @Override
        protected List<Method> computeValue(Class<?> type) {
            Set<Class<?>> contracts = new LinkedHashSet<>();
            addContracts(type, contracts);
            if (type == Pilot.class) { // no interface has what it can do
                contracts.add(type);
            }
            return contracts.stream()
                    .flatMap(contract -> List.of(contract.getMethods()).stream())
                    .filter(method -> method.getDeclaringClass() != Object.class)
                    .filter(method -> !Modifier.isStatic(method.getModifiers()))
                    .filter(method -> !method.isBridge())
                    .toList();
        }
    };

    private static List<Method> methods(Class<?> type) {
        return METHODS.get(type);
    }

    private static void addContracts(Class<?> type, Set<Class<?>> found) {
        for (Class<?> each : type.getInterfaces()) {
            if (Device.class.isAssignableFrom(each) && Modifier.isPublic(each.getModifiers())) {
                found.add(each);
            }
            addContracts(each, found);
        }
        if (type.getSuperclass() != null) {
            addContracts(type.getSuperclass(), found);
        }
    }

    /// A device that has readings.
    static Sensor<?> sensor(Device device) {
        if (device instanceof Sensor<?> sensor) {
            return sensor;
        }
        throw new IllegalArgumentException(
                "Device '%s' has no readings.".formatted(device.info().id()));
    }
}
