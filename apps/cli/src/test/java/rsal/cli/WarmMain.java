package rsal.cli;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Locale;
import picocli.CommandLine;

/// The program of the [WarmProcess]: reads command lines and answers with how each ended, until nobody writes any more.
final class WarmMain {
    private WarmMain() {}

    public static void main(String[] none) throws IOException {
        Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT); // as Main does
        var in = new DataInputStream(System.in);
        var answers = new DataOutputStream(System.out);
        while (true) {
            var arguments = new ArrayList<String>();
            try {
                for (int left = in.readInt(); left > 0; left--) {
                    arguments.add(read(in));
                }
            } catch (EOFException _) {
                Runtime.getRuntime().halt(0); // no run of a test is left
            }
            var out = new ByteArrayOutputStream();
            var err = new ByteArrayOutputStream();
            System.setOut(new PrintStream(out, true, StandardCharsets.UTF_8));
            System.setErr(new PrintStream(err, true, StandardCharsets.UTF_8));
            CommandLine commandLine = Main.commandLine(out);
            int code = commandLine.execute(arguments.toArray(String[]::new));
            commandLine.getOut().flush();
            commandLine.getErr().flush();
            answers.writeInt(code);
            write(answers, out.toByteArray());
            write(answers, err.toByteArray());
            answers.flush();
        }
    }

    static void write(DataOutputStream to, byte[] bytes) throws IOException {
        to.writeInt(bytes.length);
        to.write(bytes);
    }

    static String read(DataInputStream from) throws IOException {
        return new String(from.readNBytes(from.readInt()), StandardCharsets.UTF_8);
    }
}
