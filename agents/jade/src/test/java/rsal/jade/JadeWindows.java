package rsal.jade;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Frame;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JTree;
import javax.swing.tree.TreeModel;
import rsal.settings.Arguments;
import rsal.testkit.contract.HostRun;

/// A run on JADE with windows, as `mas: {use: jade, sniffer: true, rma: true}` has it; a program of its own, as those
/// of tests have no display. Prints a line for each window, once they show all agents.
final class JadeWindows {
    private JadeWindows() {}

    public static void main(String[] arguments) {
        int code = 1;
        try {
            show();
            code = 0;
        } finally {
            System.exit(code); // else windows keep it alive
        }
    }

    private static void show() {
        var jade = new JadeHostProvider();
        var settings = Arguments.of(jade.parameters(), Map.of("sniffer", true, "rma", true));
        try (var run = HostRun.inRealTime(time -> jade.create(settings, time))) {
            run.start("amy", _ -> {});
            run.start("bob", _ -> {});
            run.until("two windows show both", () -> {
                List<String> windows = windows();
                return windows.size() == 2 && windows.stream().allMatch(w -> w.contains("amy") && w.contains("bob"));
            });
            windows().forEach(System.out::println);
        }
    }

    /// Titles of those that can be seen, with the agents in them.
    private static List<String> windows() {
        var windows = new ArrayList<String>();
        try {
            EventQueue.invokeAndWait(() -> Arrays.stream(Frame.getFrames())
                    .filter(Component::isShowing)
                    .map(frame -> frame.getTitle() + ": "
                            + trees(frame).flatMap(JadeWindows::nodes).toList())
                    .forEach(windows::add));
        } catch (InterruptedException | InvocationTargetException e) {
            throw new AssertionError(e);
        }
        return windows;
    }

    private static Stream<JTree> trees(Component component) {
        return switch (component) {
            case JTree tree -> Stream.of(tree);
            case Container container -> Arrays.stream(container.getComponents()).flatMap(JadeWindows::trees);
            default -> Stream.empty();
        };
    }

    private static Stream<String> nodes(JTree tree) {
        return nodes(tree.getModel(), tree.getModel().getRoot());
    }

    private static Stream<String> nodes(TreeModel model, Object node) {
        return Stream.concat(
                Stream.of(node.toString()),
                IntStream.range(0, model.getChildCount(node))
                        .boxed()
                        .flatMap(i -> nodes(model, model.getChild(node, i))));
    }
}
